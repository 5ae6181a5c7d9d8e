#include "harness/scene/build.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "harness/scene/matrices.h"

namespace fillrule::scene {
namespace {

using MeshPointer = std::shared_ptr<const mesh::Mesh>;

// Which space a draw's positions and normals are of.
enum class Space : uint8_t { kClip, kObject };

// One object of the scene, ready to be written into draws.
struct Part {
  MeshPointer mesh;
  glm::dmat4 model{1};
  glm::dmat4 to_clip{1};
  glm::dmat3 normal{1};
};

glm::dmat3 normal_matrix(const glm::dmat4& model) {
  return glm::transpose(glm::inverse(glm::dmat3(model)));
}

Result<std::vector<Part>> parts_of(const Case& scene_case, Assets& assets) {
  const Scene& scene = *scene_case.scene;
  const glm::dmat4 to_clip = projection_matrix(scene) * view_matrix(scene.camera);
  std::vector<Part> parts;
  for (const SceneObject& object : scene.objects) {
    const Result<MeshPointer> mesh = assets.mesh(scene_case.file, object);
    if (!mesh) return tl::unexpected(mesh.error());
    if (object.material.texture) {
      // Read only by those who draw it.
      const Result<void> found = Assets::find_texture(scene_case.file, *object.material.texture);
      if (!found) return tl::unexpected(found.error());
    }
    const glm::dmat4 model = transform_matrix(object.transform);
    parts.push_back({.mesh = *mesh, .model = model, .to_clip = to_clip * model, .normal = normal_matrix(model)});
  }
  return parts;
}

// A vertex at the end of the draw's.
void add_vertex(const Part& part, const mesh::Vertex& vertex, Space space, Draw& draw) {
  const glm::dvec4 object(glm::dvec3(vertex.position), 1);
  const glm::vec3 world(part.model * object);
  const glm::dvec3 turned = part.normal * glm::dvec3(vertex.normal);
  const double length = glm::length(turned);
  const glm::vec3 normal =
      space == Space::kObject ? vertex.normal : glm::vec3(length > 0 ? turned / length : glm::dvec3(0));
  const glm::vec4 position(space == Space::kObject ? object : part.to_clip * object);
  draw.positions.push_back({position.x, position.y, position.z, position.w});
  draw.varyings.insert(draw.varyings.end(),
                       {world.x, world.y, world.z, normal.x, normal.y, normal.z, vertex.uv.x, vertex.uv.y});
}

Draw whole_draw(const Part& part, const RasterState& state, Space space) {
  Draw draw{.state = state};
  draw.positions.reserve(part.mesh->vertices.size());
  for (const mesh::Vertex& vertex : part.mesh->vertices) add_vertex(part, vertex, space, draw);
  draw.indices = part.mesh->indices;
  return draw;
}

// A triangle for the painter.
struct Painted {
  double distance = 0;
  uint32_t object = 0;
  uint32_t first_index = 0;
};

// The farthest first; equal ones in their order.
std::vector<Painted> painters_order(const Scene& scene, const std::vector<Part>& parts) {
  const glm::dvec4 eye = eye_of(scene);
  std::vector<Painted> order;
  for (uint32_t object = 0; object < parts.size(); ++object) {
    const mesh::Mesh& mesh = *parts[object].mesh;
    for (uint32_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      glm::dvec3 centroid(0);
      for (uint32_t corner = 0; corner < 3; ++corner) {
        const glm::dvec3 position(mesh.vertices[mesh.indices[i + corner]].position);
        centroid += glm::dvec3(parts[object].model * glm::dvec4(position, 1)) / 3.0;
      }
      const double distance =
          eye.w == 0 ? -glm::dot(centroid, glm::dvec3(eye)) : glm::distance(centroid, glm::dvec3(eye));
      order.push_back({.distance = distance, .object = object, .first_index = i});
    }
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const Painted& a, const Painted& b) { return a.distance > b.distance; });
  return order;
}

// A draw for each run of triangles of one object.
void add_painted(const std::vector<Part>& parts, Space space, Scene& scene, std::vector<Draw>& draws) {
  for (const Painted& triangle : painters_order(scene, parts)) {
    if (draws.empty() || scene.object_of_draw.back() != triangle.object) {
      draws.push_back({.state = scene.state});
      scene.object_of_draw.push_back(triangle.object);
    }
    const Part& part = parts[triangle.object];
    for (uint32_t corner = 0; corner < 3; ++corner) {
      add_vertex(part, part.mesh->vertices[part.mesh->indices[triangle.first_index + corner]], space, draws.back());
    }
  }
}

Result<Case> build_in(const Case& scene_case, Assets& assets, Space space) {
  if (!scene_case.scene) return failure("a case without a scene");
  const Result<std::vector<Part>> parts = parts_of(scene_case, assets);
  if (!parts) return tl::unexpected(parts.error());
  Case built = scene_case;
  Scene scene = *scene_case.scene;
  built.draws.clear();
  built.varyings = programs::scene_varyings(scene.affine_texture);
  scene.object_of_draw.clear();
  if (scene.order == DrawOrder::kPainter) {
    add_painted(*parts, space, scene, built.draws);
  } else {
    for (uint32_t object = 0; object < parts->size(); ++object) {
      built.draws.push_back(whole_draw((*parts)[object], scene.state, space));
      scene.object_of_draw.push_back(object);
    }
  }
  for (const Draw& draw : built.draws) {
    const auto is_finite = [](float value) { return std::isfinite(value); };
    const bool finite = std::all_of(draw.varyings.begin(), draw.varyings.end(), is_finite) &&
                        std::all_of(draw.positions.begin(), draw.positions.end(), [&](const ClipPosition& position) {
                          return std::all_of(position.begin(), position.end(), is_finite);
                        });
    if (finite) continue;
    return tl::unexpected(
        Error{.file = scene_case.file, .what = "a transformed vertex is beyond float32", .hint = "scale the model"});
  }
  built.scene = std::make_shared<const Scene>(std::move(scene));
  return built;
}

glm::vec4 color_of(const Color& color) {
  return {color[0], color[1], color[2], 0};
}

void set_lights(const Lighting& lighting, programs::ShadingUniforms& uniforms) {
  uniforms.lights = static_cast<int32_t>(lighting.directional.size());
  uniforms.ambient = color_of(lighting.ambient);
  for (size_t i = 0; i < lighting.directional.size(); ++i) {
    const glm::dvec3 direction = glm::normalize(vector_of(lighting.directional[i].direction));
    uniforms.to_light[i] = glm::vec4(-direction, 0);
    uniforms.light_color[i] = color_of(lighting.directional[i].color);
  }
}

}  // namespace

Result<Case> build(const Case& scene_case, Assets& assets) {
  return build_in(scene_case, assets, Space::kClip);
}

Result<Case> object_case(const Case& built, Assets& assets) {
  return build_in(built, assets, Space::kObject);
}

void build_scenes(format::Suite& suite, Assets& assets) {
  std::erase_if(suite.cases, [&](Case& one) {
    if (!one.scene) return false;
    Result<Case> built = build(one, assets);
    if (!built) {
      // The cases of a sweep mostly have the same.
      const bool is_new = suite.errors.empty() || to_string(suite.errors.back()) != to_string(built.error());
      if (is_new) suite.errors.push_back(built.error());
      return true;
    }
    one = std::move(*built);
    return false;
  });
}

format::Suite load_suite(const std::string& root, const std::vector<std::string>& selectors,
                         const format::Preview& preview) {
  format::Suite suite = format::load_suite(root, selectors, preview);
  Assets assets;
  build_scenes(suite, assets);
  return suite;
}

Result<programs::CaseShading> shading_of(const Case& built, Assets& assets, bool transforms) {
  const Scene& scene = *built.scene;
  const glm::dmat4 view = view_matrix(scene.camera);
  const glm::dmat4 projection = projection_matrix(scene);
  programs::CaseShading shading;
  for (const uint32_t number : scene.object_of_draw) {
    const SceneObject& object = scene.objects[number];
    const glm::dmat4 model = transform_matrix(object.transform);
    programs::DrawShading one;
    programs::ShadingUniforms& uniforms = one.uniforms;
    if (transforms) {
      uniforms.model = model;
      uniforms.view = view;
      uniforms.projection = projection;
      uniforms.normal = glm::dmat4(normal_matrix(model));
      uniforms.transforms = 1;
    }
    uniforms.eye = eye_of(scene);
    uniforms.color = color_of(object.material.color);
    uniforms.specular = color_of(object.material.specular);
    uniforms.shininess = static_cast<int32_t>(object.material.shininess);
    if (scene.lighting) set_lights(*scene.lighting, uniforms);
    if (object.material.texture) {
      const auto texture = assets.texture(built.file, *object.material.texture, object.material.sampling);
      if (!texture) return tl::unexpected(texture.error());
      one.texture = *texture;
      const TextureLevel& level = (*texture)->levels.front();
      uniforms.texture_size = {level.width, level.height, (*texture)->levels.size() - 1, 0};
      uniforms.textured = 1;
      uniforms.mipmapped = object.material.sampling.mipmaps == Mipmaps::kNone ? 0 : 1;
    }
    shading.push_back(std::move(one));
  }
  return shading;
}

}  // namespace fillrule::scene
