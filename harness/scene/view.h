// A scene seen otherwise: other sizes, other cameras, models that turn. Every function gives a scene's case that has
// to be built again (build.h).
#pragma once

#include <cstdint>

#include "cases/model/case.h"
#include "cases/model/scene.h"

namespace fillrule::scene {

// The same case of another scene.
Case with_scene(const Case& scene_case, Scene scene);

// On a target of this size in pixels; viewport and scissor grow with it.
Case resized(const Case& scene_case, uint32_t width, uint32_t height);

// Every model turned by so many degrees, about the axis through what the camera looks at that points up on the
// picture. Camera and lights stay. A camera that is placed by a transform has the world's origin and y axis instead.
Case turned(const Case& scene_case, double degrees);

}  // namespace fillrule::scene
