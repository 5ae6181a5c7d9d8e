#include "cases/format/scene_camera.h"

#include <fmt/format.h>

#include <algorithm>

namespace fillrule::format {
namespace {

constexpr std::string_view kSteps =
    "steps are { translate = [x, y, z] }, { rotate_x = degrees }, rotate_y, rotate_z, { rotate = { axis = [x, y, z], "
    "degrees = 30 } } and { scale = [x, y, z] } or one factor";

Rotate read_rotation(const toml::node& node, Values& values) {
  Rotate rotation;
  const toml::table* const table = as_table(node, "rotate", values.diagnostics());
  if (table == nullptr) return rotation;
  check_keys({*table, "rotate"}, {"axis", "degrees"}, values.diagnostics());
  for (const char* const key : {"axis", "degrees"}) {
    if (!table->contains(key)) values.diagnostics().add(place_of(node), fmt::format("rotate without \"{}\"", key));
  }
  if (const toml::node* const axis = table->get("axis")) read_direction(*axis, "axis", values, rotation.axis);
  if (const toml::node* const degrees = table->get("degrees")) {
    rotation.degrees = values.finite(*degrees, "degrees").value_or(0);
  }
  return rotation;
}

Scale read_scale(const toml::node& node, Values& values) {
  Scale scale;
  if (node.is_array()) {
    read_vector(node, "scale", values, scale.by);
  } else if (const auto factor = values.finite(node, "scale")) {
    scale.by = {*factor, *factor, *factor};
  }
  if (std::any_of(scale.by.begin(), scale.by.end(), [](double factor) { return factor == 0; })) {
    values.diagnostics().add(place_of(node), "a scale of 0", "a flattened model has no normals");
    return {};
  }
  return scale;
}

TransformStep read_step(const toml::table& table, Values& values) {
  check_keys({table, "a transform step"}, {"translate", "rotate_x", "rotate_y", "rotate_z", "rotate", "scale"},
             values.diagnostics());
  const Entry only = in_file_order(table).front();
  const std::string_view name = only.key->str();
  const toml::node& node = *only.value;
  if (name == "rotate") return read_rotation(node, values);
  if (name == "scale") return read_scale(node, values);
  if (name.starts_with("rotate_")) {
    Rotate rotation{.axis = {0, 0, 0}};
    const auto axis = static_cast<size_t>(name.back() - 'x');
    if (axis < 3) rotation.axis[axis] = 1;
    rotation.degrees = values.finite(node, name).value_or(0);
    return rotation;
  }
  Translate translation;
  if (name == "translate") read_vector(node, "translate", values, translation.by);
  return translation;
}

// Reads `value` where the key is there; `is_good` says what it must be.
template <typename IsGood>
void read_positive(const toml::table& table, std::string_view key, std::string_view range, Values& values,
                   double& value, IsGood is_good) {
  const toml::node* const node = table.get(key);
  if (node == nullptr) return;
  const auto number = values.finite(*node, key);
  if (!number) return;
  if (!is_good(*number)) {
    values.diagnostics().add(place_of(*node), fmt::format("{} must be {}, not {}", key, range, *number));
    return;
  }
  value = *number;
}

// [left, right, bottom, top]
template <typename Rectangle>
Rectangle read_rectangle(const toml::node& node, std::string_view label, Values& values) {
  Rectangle rectangle;
  std::array<double, 4> sides{rectangle.left, rectangle.right, rectangle.bottom, rectangle.top};
  read_vector(node, label, values, sides);
  if (sides[0] == sides[1] || sides[2] == sides[3]) {
    values.diagnostics().add(place_of(node), fmt::format("{} without area", label), "[left, right, bottom, top]");
    return {};
  }
  return {.left = sides[0], .right = sides[1], .bottom = sides[2], .top = sides[3]};
}

LookAt read_look_at(const toml::table& table, Values& values) {
  LookAt look;
  if (const toml::node* const eye = table.get("eye")) read_vector(*eye, "eye", values, look.eye);
  if (const toml::node* const target = table.get("target")) read_vector(*target, "target", values, look.target);
  if (const toml::node* const up = table.get("up")) read_direction(*up, "up", values, look.up);
  const Vector3 view{look.target[0] - look.eye[0], look.target[1] - look.eye[1], look.target[2] - look.eye[2]};
  const Vector3 side{view[1] * look.up[2] - view[2] * look.up[1], view[2] * look.up[0] - view[0] * look.up[2],
                     view[0] * look.up[1] - view[1] * look.up[0]};
  if (side == Vector3{}) {
    values.diagnostics().add(place_of(table), "the camera looks along up, or nowhere",
                             "eye, target and up must not lie on one line");
    return {};
  }
  return look;
}

}  // namespace

void read_direction(const toml::node& node, std::string_view label, Values& values, Vector3& direction) {
  Vector3 read = direction;
  read_vector(node, label, values, read);
  if (read == Vector3{}) {
    values.diagnostics().add(place_of(node), fmt::format("{} must not be zero", label));
    return;
  }
  direction = read;
}

Transform read_transform(const toml::node& node, Values& values) {
  Transform transform;
  const toml::array* const array = as_array(node, "transform", "an array of steps", values.diagnostics());
  if (array == nullptr) return transform;
  for (const toml::node& element : *array) {
    const toml::table* const table = as_table(element, "a transform step", values.diagnostics());
    if (table == nullptr) continue;
    if (table->size() != 1) {
      values.diagnostics().add(place_of(element), fmt::format("a transform step of {} keys", table->size()),
                               std::string(kSteps));
      continue;
    }
    transform.push_back(read_step(*table, values));
  }
  return transform;
}

Camera read_camera(const toml::node& node, Values& values) {
  Camera camera;
  const toml::table* const table = as_table(node, "camera", values.diagnostics());
  if (table == nullptr) return camera;
  check_keys({*table, "[scene.camera]"}, {"eye", "target", "up", "transform", "handedness"}, values.diagnostics());
  if (const toml::node* const handedness = table->get("handedness")) {
    camera.handedness = values.enumerator(*handedness, "handedness", kHandedness).value_or(camera.handedness);
  }
  const toml::node* const transform = table->get("transform");
  if (transform == nullptr) {
    camera.placement = read_look_at(*table, values);
    return camera;
  }
  for (const char* const key : {"eye", "target", "up"}) {
    if (const toml::node* const other = table->get(key)) {
      values.diagnostics().add(place_of(*other), fmt::format(R"("{}" beside "transform")", key),
                               "a camera stands where its transform puts it, or looks from eye to target");
    }
  }
  camera.placement = read_transform(*transform, values);
  return camera;
}

Projection read_projection(const toml::node& node, Values& values) {
  Projection projection;
  const toml::table* const table = as_table(node, "projection", values.diagnostics());
  if (table == nullptr) return projection;
  check_keys({*table, "[scene.projection]"}, {"fov_y", "aspect", "frustum", "orthographic", "near", "far"},
             values.diagnostics());
  const toml::node* const frustum = table->get("frustum");
  const toml::node* const orthographic = table->get("orthographic");
  const bool has_fov = table->contains("fov_y") || table->contains("aspect");
  if ((frustum != nullptr ? 1 : 0) + (orthographic != nullptr ? 1 : 0) + (has_fov ? 1 : 0) > 1) {
    values.diagnostics().add(place_of(node), "more than one kind of projection",
                             "give fov_y and aspect, or frustum, or orthographic");
    return projection;
  }
  PerspectiveProjection perspective;
  read_positive(*table, "fov_y", "above 0 and below 180 degrees", values, perspective.fov_y,
                [](double degrees) { return degrees > 0 && degrees < 180; });
  if (table->contains("aspect")) {
    perspective.aspect = 1;
    read_positive(*table, "aspect", "above 0", values, *perspective.aspect, [](double aspect) { return aspect > 0; });
  }
  projection.shape = perspective;
  if (frustum != nullptr) projection.shape = read_rectangle<FrustumProjection>(*frustum, "frustum", values);
  if (orthographic != nullptr) {
    projection.shape = read_rectangle<OrthographicProjection>(*orthographic, "orthographic", values);
  }
  const bool is_orthographic = orthographic != nullptr;
  const auto is_good = [&](double distance) { return is_orthographic || distance > 0; };
  read_positive(*table, "near", "above 0", values, projection.near, is_good);
  read_positive(*table, "far", "above 0", values, projection.far, is_good);
  if (projection.near >= projection.far) {
    values.diagnostics().add(place_of(node),
                             fmt::format("near = {} is not before far = {}", projection.near, projection.far));
  }
  return projection;
}

}  // namespace fillrule::format
