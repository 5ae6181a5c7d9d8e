// The program `varyings`: one hit, the primitive's number with its facing, and the packed varyings as interpolated.
//
// The macros are those of varyings.vert. Attachment 0 adds up the hits, attachment 1 takes the primitive's number + 1
// with the facing in the top bit, the others one slot each.
#version 450

layout(push_constant) uniform Numbering {
  uint first_primitive;
  uint vertices_per_primitive;
  uint first_provoking_vertex;
};

#if NUM_SMOOTH > 0
layout(location = 0) smooth in vec4 smooth_in[NUM_SMOOTH];
layout(location = 2) out vec4 smooth_out[NUM_SMOOTH];
#endif
#if NUM_NOPERSPECTIVE > 0
layout(location = NUM_SMOOTH) noperspective in vec4 noperspective_in[NUM_NOPERSPECTIVE];
layout(location = 2 + NUM_SMOOTH) out vec4 noperspective_out[NUM_NOPERSPECTIVE];
#endif
#if NUM_FLAT > 0
layout(location = NUM_SMOOTH + NUM_NOPERSPECTIVE) flat in vec4 flat_in[NUM_FLAT];
layout(location = 2 + NUM_SMOOTH + NUM_NOPERSPECTIVE) out vec4 flat_out[NUM_FLAT];
#endif
#if !PRIMITIVE_ID
layout(location = NUM_SMOOTH + NUM_NOPERSPECTIVE + NUM_FLAT) flat in uint primitive_in;
#endif

layout(location = 0) out float hits;
layout(location = 1) out uint owner;

void main() {
#if PRIMITIVE_ID
  const uint primitive = first_primitive + uint(gl_PrimitiveID);
#else
  const uint primitive = primitive_in;
#endif
  hits = 1.0;
  owner = (primitive + 1u) | (gl_FrontFacing ? 0x80000000u : 0u);
#if NUM_SMOOTH > 0
  smooth_out = smooth_in;
#endif
#if NUM_NOPERSPECTIVE > 0
  noperspective_out = noperspective_in;
#endif
#if NUM_FLAT > 0
  flat_out = flat_in;
#endif
}
