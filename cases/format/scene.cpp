#include <fmt/format.h>

#include "cases/format/scene_camera.h"
#include "cases/format/sections.h"

namespace fillrule::format {
namespace {

void read_lights(const toml::node& node, Values& values, std::vector<DirectionalLight>& lights) {
  const toml::array* const array = as_array(node, "directional", "an array of lights", values.diagnostics());
  if (array == nullptr) return;
  if (array->size() > kMaxLights) {
    values.diagnostics().add(place_of(node),
                             fmt::format("{} directional lights; at most {}", array->size(), kMaxLights));
    return;
  }
  for (const toml::node& element : *array) {
    const toml::table* const table = as_table(element, "a directional light", values.diagnostics());
    if (table == nullptr) continue;
    check_keys({*table, "a directional light"}, {"direction", "color"}, values.diagnostics());
    DirectionalLight light;
    if (const toml::node* const direction = table->get("direction")) {
      read_direction(*direction, "direction", values, light.direction);
    }
    if (const toml::node* const color = table->get("color")) read_vector(*color, "color", values, light.color);
    lights.push_back(light);
  }
}

Lighting read_lighting(const toml::table& table, Values& values) {
  Lighting lighting;
  check_keys({table, "[scene.light]"}, {"ambient", "directional"}, values.diagnostics());
  if (const toml::node* const ambient = table.get("ambient")) {
    read_vector(*ambient, "ambient", values, lighting.ambient);
  }
  if (const toml::node* const lights = table.get("directional")) read_lights(*lights, values, lighting.directional);
  return lighting;
}

SceneObject read_object(const toml::table& table, Values& values) {
  SceneObject object;
  check_keys({table, "[[scene.object]]"}, {"mesh", "normals", "transform", "material"}, values.diagnostics());
  const toml::node* const mesh = table.get("mesh");
  if (mesh == nullptr) {
    values.diagnostics().add(place_of(table), "an object without a mesh",
                             "mesh = \"cube\", or the path of an OBJ file from this file's folder");
  } else if (const auto path = values.text(*mesh, "mesh")) {
    const Place place = place_of(*mesh);
    object.mesh = {.text = *path, .line = place.line, .column = place.column};
  }
  if (const toml::node* const normals = table.get("normals")) {
    object.normals = values.enumerator(*normals, "normals", kNormals).value_or(object.normals);
  }
  if (const toml::node* const transform = table.get("transform")) {
    object.transform = read_transform(*transform, values);
  }
  if (const toml::node* const material = table.get("material")) {
    const toml::table* const keys = as_table(*material, "material", values.diagnostics());
    if (keys != nullptr) object.material = read_material(*keys, values);
  }
  return object;
}

void read_objects(const toml::table& table, Values& values, Scene& scene) {
  const toml::node* const node = table.get("object");
  if (node == nullptr) {
    values.diagnostics().add(place_of(table), "a scene without an object", "add [[scene.object]] with a mesh");
    return;
  }
  const toml::array* const array = as_array(*node, "object", "[[scene.object]]", values.diagnostics());
  if (array == nullptr) return;
  for (const toml::node& element : *array) {
    const toml::table* const object = as_table(element, "an object", values.diagnostics());
    if (object != nullptr) scene.objects.push_back(read_object(*object, values));
  }
}

}  // namespace

Scene read_scene(const toml::node& node, Values& values) {
  Scene scene;
  const toml::table* const table = as_table(node, "scene", values.diagnostics());
  if (table == nullptr) return scene;
  check_keys({*table, "[scene]"},
             {"camera", "projection", "light", "order", "uv_interpolation", "transform_on", "background", "object"},
             values.diagnostics());
  if (const toml::node* const camera = table->get("camera")) scene.camera = read_camera(*camera, values);
  if (const toml::node* const projection = table->get("projection")) {
    scene.projection = read_projection(*projection, values);
  }
  if (const toml::node* const light = table->get("light")) {
    const toml::table* const keys = as_table(*light, "light", values.diagnostics());
    if (keys != nullptr) scene.lighting = read_lighting(*keys, values);
  }
  if (const toml::node* const order = table->get("order")) {
    scene.order = values.enumerator(*order, "order", kDrawOrders).value_or(scene.order);
  }
  if (const toml::node* const uv = table->get("uv_interpolation")) {
    const std::array names{EnumName<bool>{"smooth", false}, EnumName<bool>{"noperspective", true}};
    scene.affine_texture = values.enumerator(*uv, "uv_interpolation", names).value_or(false);
  }
  if (const toml::node* const place = table->get("transform_on")) {
    scene.transform_on = values.enumerator(*place, "transform_on", kTransformOn).value_or(scene.transform_on);
  }
  if (const toml::node* const color = table->get("background")) {
    read_vector(*color, "background", values, scene.background);
  }
  read_objects(*table, values, scene);
  return scene;
}

}  // namespace fillrule::format
