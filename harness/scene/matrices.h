// The matrices of a scene, in double. Columns, as GLM and GLSL have them: clip = projection * view * model *
// position.
//
// Object and world space are as the model says; eye space has x to the right, y up and the view along -z, or along +z
// in a left-handed world; clip space is Vulkan's, y down, z from 0 to w or from -w to w.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "cases/model/scene.h"

namespace fillrule::scene {

glm::dvec3 vector_of(const Vector3& vector);

// The steps, the first one applied first.
glm::dmat4 transform_matrix(const Transform& transform);

// From the world to the eye.
glm::dmat4 view_matrix(const Camera& camera);

// From the eye to clip space. The picture is upright: y is turned over, unless the viewport does that.
glm::dmat4 projection_matrix(const Scene& scene);

// The eye in the world; of an orthographic projection the direction to it, w = 0.
glm::dvec4 eye_of(const Scene& scene);

}  // namespace fillrule::scene
