// The program `varyings`: one hit, the primitive's number with its facing, and the packed varyings as interpolated.
//
// The macros are those of varyings.vert; FRAG_COORDS(S) and POINT_COORDS(S) call S(i) for each slot i that a built-in
// fills. Attachment 0 adds up the hits, attachment 1 takes the primitive's number + 1 with the facing in the top bit,
// the others one slot each.
#version 450

layout(push_constant) uniform Numbering {
  uint first_primitive;
  uint vertices_per_primitive;
  uint first_provoking_vertex;
};

layout(location = 0) out float hits;
layout(location = 1) out uint owner;

#define DECLARE_OUTPUT(i) layout(location = 2 + i) out vec4 out_##i;
#define DECLARE(i, qualifiers)                     \
  layout(location = i) qualifiers in vec4 in_##i; \
  DECLARE_OUTPUT(i)
#define RECORD(i, qualifiers) out_##i = in_##i;
#define RECORD_FRAG_COORD(i) out_##i = gl_FragCoord;
#define RECORD_POINT_COORD(i) out_##i = vec4(gl_PointCoord, gl_PointCoord);
INTERPOLATED(DECLARE)
FRAG_COORDS(DECLARE_OUTPUT)
POINT_COORDS(DECLARE_OUTPUT)

#if !PRIMITIVE_ID
layout(location = NUM_INTERPOLATED) flat in uint primitive_in;
#endif

void main() {
#if PRIMITIVE_ID
  const uint primitive = first_primitive + uint(gl_PrimitiveID);
#else
  const uint primitive = primitive_in;
#endif
  hits = 1.0;
  owner = (primitive + 1u) | (gl_FrontFacing ? 0x80000000u : 0u);
  INTERPOLATED(RECORD)
  FRAG_COORDS(RECORD_FRAG_COORD)
  POINT_COORDS(RECORD_POINT_COORD)
}
