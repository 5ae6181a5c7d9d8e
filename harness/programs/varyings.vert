// The program `varyings`: final clip-space positions and packed varyings, handed on without arithmetic.
//
// Components of equal interpolation are packed into vec4 slots; NUM_SMOOTH, NUM_NOPERSPECTIVE and NUM_FLAT say how many
// slots of each kind there are. PRIMITIVE_ID says whether the fragment stage can read gl_PrimitiveID.
// Its twin for the renderer is varyings.h.
#version 450

layout(location = 0) in vec4 position_clip;

#if NUM_SMOOTH > 0
layout(location = 1) in vec4 smooth_in[NUM_SMOOTH];
layout(location = 0) smooth out vec4 smooth_out[NUM_SMOOTH];
#endif
#if NUM_NOPERSPECTIVE > 0
layout(location = 1 + NUM_SMOOTH) in vec4 noperspective_in[NUM_NOPERSPECTIVE];
layout(location = NUM_SMOOTH) noperspective out vec4 noperspective_out[NUM_NOPERSPECTIVE];
#endif
#if NUM_FLAT > 0
layout(location = 1 + NUM_SMOOTH + NUM_NOPERSPECTIVE) in vec4 flat_in[NUM_FLAT];
layout(location = NUM_SMOOTH + NUM_NOPERSPECTIVE) flat out vec4 flat_out[NUM_FLAT];
#endif

#if !PRIMITIVE_ID
// Without gl_PrimitiveID the provoking vertex carries the number: primitive i of an unindexed draw has the provoking
// vertex first_provoking_vertex + i * vertices_per_primitive.
layout(push_constant) uniform Numbering {
  uint first_primitive;
  uint vertices_per_primitive;
  uint first_provoking_vertex;
};
layout(location = NUM_SMOOTH + NUM_NOPERSPECTIVE + NUM_FLAT) flat out uint primitive_out;
#endif

void main() {
  gl_Position = position_clip;
#if NUM_SMOOTH > 0
  smooth_out = smooth_in;
#endif
#if NUM_NOPERSPECTIVE > 0
  noperspective_out = noperspective_in;
#endif
#if NUM_FLAT > 0
  flat_out = flat_in;
#endif
#if !PRIMITIVE_ID
  primitive_out = first_primitive + (uint(gl_VertexIndex) - first_provoking_vertex) / vertices_per_primitive;
#endif
}
