// The program `shaded`, fragment stage: texel times material, lit by Phong's model: ambient, diffuse and specular
// light. The colour goes to the one attachment behind hits and owner. shaded.cpp does the same operations in the same
// order.
//
// Powers are made by multiplying, levels of detail from the differences within a quad of pixels: both are then exact
// operations, where pow() and a sampler's own choice of level leave much open.
//
// VARIANT tells whether there is a texture (1) and light (2): each of both is half of what a driver compiles. What else
// it tells is of the vertex stage.
#version 450

layout(push_constant) uniform Numbering {
  uint first_primitive;
  uint vertices_per_primitive;
  uint first_provoking_vertex;
};

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
layout(set = 0, binding = 1) uniform sampler2D image;

layout(location = 0) out float hits;
layout(location = 1) out uint owner;

#define DECLARE(i, qualifiers) layout(location = i) qualifiers in vec4 in_##i;
INTERPOLATED(DECLARE)
#if NUM_INTERPOLATED > 0
layout(location = 2) out vec4 color_out;
#endif

#if !PRIMITIVE_ID
layout(location = NUM_INTERPOLATED) flat in uint primitive_in;
#endif

vec3 direction_of(vec3 vector) {
  const float squared = dot(vector, vector);
  return squared > 0.0 ? vector / sqrt(squared) : vec3(0.0);
}

float power(float base, int exponent) {
  float result = 1.0;
  for (; exponent > 0; exponent >>= 1) {
    if ((exponent & 1) != 0) result *= base;
    base *= base;
  }
  return result;
}

vec3 texel_at(vec2 uv) {
  float level = 0.0;
  if (shading.mipmapped != 0) {
    const vec2 step_x = dFdxFine(uv) * shading.texture_size.xy;
    const vec2 step_y = dFdyFine(uv) * shading.texture_size.xy;
    const float squared = max(dot(step_x, step_x), dot(step_y, step_y));
    level = squared > 0.0 ? clamp(0.5 * log2(squared), 0.0, shading.texture_size.z) : 0.0;
  }
  return textureLod(image, uv, level).rgb;
}

vec3 lit(vec3 base, vec3 position_world, vec3 normal_world) {
  const vec3 normal = direction_of(normal_world);
  const vec3 to_eye = direction_of(shading.eye.xyz - position_world * shading.eye.w);
  vec3 diffuse = shading.ambient.rgb;
  vec3 specular = vec3(0.0);
  for (int i = 0; i < shading.lights; ++i) {
    const vec3 to_light = shading.to_light[i].xyz;
    const float cosine = dot(normal, to_light);
    if (cosine <= 0.0) continue;
    diffuse += shading.light_color[i].rgb * cosine;
    const vec3 reflected = normal * (2.0 * cosine) - to_light;
    specular += shading.light_color[i].rgb * power(max(dot(reflected, to_eye), 0.0), shading.shininess);
  }
  return base * diffuse + shading.specular.rgb * specular;
}

void main() {
#if PRIMITIVE_ID
  const uint primitive = first_primitive + uint(gl_PrimitiveID);
#else
  const uint primitive = primitive_in;
#endif
  hits = 1.0;
  owner = (primitive + 1u) | (gl_FrontFacing ? 0x80000000u : 0u);
#if NUM_INTERPOLATED > 0
#if NUM_INTERPOLATED == 2
  const vec2 uv = in_1.zw;
#else
  const vec2 uv = in_2.xy;
#endif
  vec3 color = shading.color.rgb;
#if (VARIANT & 1) != 0
  color *= texel_at(uv);
#endif
#if (VARIANT & 2) != 0
  color = lit(color, in_0.xyz, vec3(in_0.w, in_1.xy));
#endif
  color_out = vec4(clamp(color, 0.0, 1.0), 1.0);
#endif
}
