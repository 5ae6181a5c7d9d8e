#include "harness/view/switches.h"

#include <fmt/format.h>

namespace fillrule::view {
namespace {

std::string on_off(const char* what, bool value) {
  return fmt::format("{} {}", what, value ? "on" : "off");
}

bool flipped(bool& value) {
  value = !value;
  return value;
}

}  // namespace

Switches::Switches(const Case& looked_at) {
  RasterState state;
  if (looked_at.scene) {
    state = looked_at.scene->state;
  } else if (!looked_at.draws.empty()) {
    state = looked_at.draws.front().state;
  }
  is_wireframe_ = state.polygon_mode == VK_POLYGON_MODE_LINE;
  is_culling_ = state.cull_mode != VK_CULL_MODE_NONE;
}

std::string Switches::flip(Action action) {
  switch (action) {
    case Action::kWireframe:
      wireframe_ = !wireframe_.value_or(is_wireframe_);
      return *wireframe_ ? "wireframe" : "filled";
    case Action::kCulling:
      culling_ = !culling_.value_or(is_culling_);
      return on_off("culling", *culling_);
    case Action::kTexture:
      return on_off("textures", flipped(texture_));
    case Action::kLights:
      return on_off("lights", flipped(lights_));
    case Action::kOwnSize:
      return flipped(own_size_) ? "as large as in the file" : "as large as the window";
    default:
      return {};
  }
}

void Switches::apply(RasterState& state) const {
  if (wireframe_) state.polygon_mode = *wireframe_ ? VK_POLYGON_MODE_LINE : VK_POLYGON_MODE_FILL;
  if (culling_) state.cull_mode = *culling_ ? VK_CULL_MODE_BACK_BIT : VK_CULL_MODE_NONE;
}

void Switches::apply(Scene& scene) const {
  apply(scene.state);
  if (!lights_) scene.lighting.reset();
  for (SceneObject& object : scene.objects) {
    if (!texture_) object.material.texture.reset();
  }
}

}  // namespace fillrule::view
