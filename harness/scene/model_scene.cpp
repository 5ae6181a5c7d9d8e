#include "harness/scene/model_scene.h"

#include <algorithm>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace fillrule::scene {
namespace {

constexpr uint32_t kSize = 512;

Vector3 array_of(const glm::dvec3& vector) {
  return {vector.x, vector.y, vector.z};
}

}  // namespace

Result<Case> scene_of_model(const std::string& path, Assets& assets) {
  const std::filesystem::path file(path);
  Case one{.name = file.stem().string(),
           .file = path,
           .title = "The model " + file.filename().string(),
           .why = "A look at a model.",
           .spec = "Rasterization",
           .origin = path};
  one.target.width = one.target.height = kSize;
  Scene scene;
  scene.objects.push_back({.mesh = {.text = file.filename().string()}});
  const auto mesh = assets.mesh(path, scene.objects[0]);
  if (!mesh) return tl::unexpected(mesh.error());
  glm::dvec3 low((*mesh)->vertices[0].position);
  glm::dvec3 high = low;
  for (const mesh::Vertex& vertex : (*mesh)->vertices) {
    low = glm::min(low, glm::dvec3(vertex.position));
    high = glm::max(high, glm::dvec3(vertex.position));
  }
  const glm::dvec3 centre = (low + high) / 2.0;
  const double radius = std::max(glm::length(high - low) / 2, 1e-6);
  // At 3.2 radii the sphere around the model fills 0.76 of 45 degrees.
  constexpr double kDistance = 3.2;
  const glm::dvec3 towards = glm::normalize(glm::dvec3(0.6, 0.45, 1));
  scene.camera.placement =
      LookAt{.eye = array_of(centre + towards * (kDistance * radius)), .target = array_of(centre), .up = {0, 1, 0}};
  scene.projection = {
      .shape = PerspectiveProjection{}, .near = (kDistance - 1.5) * radius / 2, .far = (kDistance + 1.5) * radius};
  scene.lighting = Lighting{.ambient = {0.2, 0.2, 0.2},
                            .directional = {{.direction = {0.3, -0.8, -1}, .color = {0.75, 0.75, 0.75}}}};
  scene.background = {0.1, 0.11, 0.13};
  scene.state.viewport = {.width = kSize, .height = kSize, .maxDepth = 1};
  scene.state.scissor = {.extent = {kSize, kSize}};
  scene.state.depth_test = true;
  one.scene = std::make_shared<const Scene>(std::move(scene));
  return one;
}

}  // namespace fillrule::scene
