// The program `varyings`: final clip-space positions and packed varyings, handed on without arithmetic.
//
// Components of equal kind are packed into vec4 slots. INTERPOLATED(S) calls S(i, qualifiers) for each slot i that the
// vertices fill, and there are NUM_INTERPOLATED of them. NUM_CLIP_DISTANCES and NUM_CULL_DISTANCES say how many user
// distances there are, and PRIMITIVE_ID whether the fragment stage can read gl_PrimitiveID. Its twin for the renderer is
// varyings.h.
#version 450

layout(location = 0) in vec4 position_clip;

#define DECLARE(i, qualifiers)               \
  layout(location = 1 + i) in vec4 in_##i;   \
  layout(location = i) qualifiers out vec4 out_##i;
#define HAND_ON(i, qualifiers) out_##i = in_##i;
INTERPOLATED(DECLARE)

layout(location = 1 + NUM_INTERPOLATED) in float point_size;
#if NUM_CLIP_DISTANCES > 0
layout(location = 2 + NUM_INTERPOLATED) in float clip_distances[NUM_CLIP_DISTANCES];
out float gl_ClipDistance[NUM_CLIP_DISTANCES];
#endif
#if NUM_CULL_DISTANCES > 0
layout(location = 2 + NUM_INTERPOLATED + NUM_CLIP_DISTANCES) in float cull_distances[NUM_CULL_DISTANCES];
out float gl_CullDistance[NUM_CULL_DISTANCES];
#endif

#if !PRIMITIVE_ID
// Without gl_PrimitiveID the provoking vertex carries the number: primitive i of an unindexed draw has the provoking
// vertex first_provoking_vertex + i * vertices_per_primitive.
layout(push_constant) uniform Numbering {
  uint first_primitive;
  uint vertices_per_primitive;
  uint first_provoking_vertex;
};
layout(location = NUM_INTERPOLATED) flat out uint primitive_out;
#endif

void main() {
  gl_Position = position_clip;
  INTERPOLATED(HAND_ON)
  gl_PointSize = point_size;
#if NUM_CLIP_DISTANCES > 0
  for (int i = 0; i < NUM_CLIP_DISTANCES; ++i) gl_ClipDistance[i] = clip_distances[i];
#endif
#if NUM_CULL_DISTANCES > 0
  for (int i = 0; i < NUM_CULL_DISTANCES; ++i) gl_CullDistance[i] = cull_distances[i];
#endif
#if !PRIMITIVE_ID
  primitive_out = first_primitive + (uint(gl_VertexIndex) - first_provoking_vertex) / vertices_per_primitive;
#endif
}
