#include "harness/scene/view.h"

#include <cmath>
#include <utility>

namespace fillrule::scene {

Case with_scene(const Case& scene_case, Scene scene) {
  Case result = scene_case;
  result.scene = std::make_shared<const Scene>(std::move(scene));
  return result;
}

Case resized(const Case& scene_case, uint32_t width, uint32_t height) {
  Scene scene = *scene_case.scene;
  const float by_x = static_cast<float>(width) / static_cast<float>(scene_case.target.width);
  const float by_y = static_cast<float>(height) / static_cast<float>(scene_case.target.height);
  VkViewport& viewport = scene.state.viewport;
  viewport.x *= by_x;
  viewport.width *= by_x;
  viewport.y *= by_y;
  viewport.height *= by_y;
  const auto scaled = [](auto value, float factor) { return std::lround(static_cast<float>(value) * factor); };
  VkRect2D& scissor = scene.state.scissor;
  scissor.offset = {.x = static_cast<int32_t>(scaled(scissor.offset.x, by_x)),
                    .y = static_cast<int32_t>(scaled(scissor.offset.y, by_y))};
  scissor.extent = {.width = static_cast<uint32_t>(scaled(scissor.extent.width, by_x)),
                    .height = static_cast<uint32_t>(scaled(scissor.extent.height, by_y))};
  Case result = with_scene(scene_case, std::move(scene));
  result.target.width = width;
  result.target.height = height;
  return result;
}

Case turned(const Case& scene_case, double degrees) {
  Scene scene = *scene_case.scene;
  LookAt look{.target = {0, 0, 0}, .up = {0, 1, 0}};
  if (const auto* const placement = std::get_if<LookAt>(&scene.camera.placement)) look = *placement;
  const Vector3 back{-look.target[0], -look.target[1], -look.target[2]};
  for (SceneObject& object : scene.objects) {
    object.transform.emplace_back(Translate{back});
    object.transform.emplace_back(Rotate{look.up, degrees});
    object.transform.emplace_back(Translate{look.target});
  }
  return with_scene(scene_case, std::move(scene));
}

}  // namespace fillrule::scene
