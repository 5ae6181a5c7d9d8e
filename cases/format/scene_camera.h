// What moves and projects in a scene: transforms, the camera, the projection. As in sections.h, what cannot be read
// leaves an error in the diagnostics and a default in the result.
#pragma once

#include <string_view>

#include "cases/format/sections.h"

namespace fillrule::format {

// A vector that is not zero.
void read_direction(const toml::node& node, std::string_view label, Values& values, Vector3& direction);
Transform read_transform(const toml::node& node, Values& values);
Camera read_camera(const toml::node& node, Values& values);
Projection read_projection(const toml::node& node, Values& values);

}  // namespace fillrule::format
