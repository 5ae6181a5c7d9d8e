// The program `shaded`, vertex stage: hands positions and varyings on as they are, or applies the matrices to a position
// of object space. The packed varyings are position (xyz), normal (xyz), uv: slot 0 is (position, normal.x), slot 1
// begins with normal.yz. VARIANT tells whether to apply the matrices (4). Its twin for the renderer is shaded.h; the
// macros are those of varyings.vert.
#version 450

layout(set = 0, binding = 0, std140) readonly buffer Shading {
  mat4 model;
  mat4 view;
  mat4 projection;
  mat4 normal;
  vec4 eye;
  vec4 color;
  vec4 specular;
  vec4 ambient;
  vec4 to_light[4];
  vec4 light_color[4];
  vec4 texture_size;
  int lights;
  int shininess;
  int textured;
  int mipmapped;
  int transforms;
} shading;

layout(location = 0) in vec4 position;

#define DECLARE(i, qualifiers)               \
  layout(location = 1 + i) in vec4 in_##i;   \
  layout(location = i) qualifiers out vec4 out_##i;
#define HAND_ON(i, qualifiers) out_##i = in_##i;
INTERPOLATED(DECLARE)

layout(location = 1 + NUM_INTERPOLATED) in float point_size;

#if !PRIMITIVE_ID
layout(push_constant) uniform Numbering {
  uint first_primitive;
  uint vertices_per_primitive;
  uint first_provoking_vertex;
};
layout(location = NUM_INTERPOLATED) flat out uint primitive_out;
#endif

vec3 direction_of(vec3 vector) {
  const float squared = dot(vector, vector);
  return squared > 0.0 ? vector / sqrt(squared) : vec3(0.0);
}

void main() {
  INTERPOLATED(HAND_ON)
  gl_Position = position;
#if (VARIANT & 4) != 0 && NUM_INTERPOLATED > 0
  const vec4 position_world = shading.model * position;
  gl_Position = shading.projection * (shading.view * position_world);
  const vec3 normal_world = direction_of(mat3(shading.normal) * vec3(in_0.w, in_1.xy));
  out_0 = vec4(position_world.xyz, normal_world.x);
  out_1.xy = normal_world.yz;
#endif
  gl_PointSize = point_size;
#if !PRIMITIVE_ID
  primitive_out = first_primitive + (uint(gl_VertexIndex) - first_provoking_vertex) / vertices_per_primitive;
#endif
}
