#include <fmt/format.h>

#include "cases/format/sections.h"

namespace fillrule::format {
namespace {

// One mode, or those of u and v.
void read_wrap(const toml::node& node, Values& values, Sampling2D& sampling) {
  const toml::array* const array = node.as_array();
  if (array == nullptr) {
    if (const auto mode = values.enumerator(node, "wrap", kWrapModes)) sampling.wrap_u = sampling.wrap_v = *mode;
    return;
  }
  if (array->size() != 2) {
    values.diagnostics().add(place_of(node), "wrap must be one mode, or [of u, of v]");
    return;
  }
  sampling.wrap_u = values.enumerator(*array->get(0), "wrap", kWrapModes).value_or(sampling.wrap_u);
  sampling.wrap_v = values.enumerator(*array->get(1), "wrap", kWrapModes).value_or(sampling.wrap_v);
}

void read_sampling(const toml::table& table, Values& values, Material& material) {
  Sampling2D& sampling = material.sampling;
  for (const char* const key : {"filter", "wrap", "border", "mipmaps"}) {
    const toml::node* const node = table.get(key);
    if (node == nullptr || table.contains("texture")) continue;
    values.diagnostics().add(place_of(*node), fmt::format("\"{}\" without a texture", key));
  }
  if (const toml::node* const filter = table.get("filter")) {
    sampling.filter = values.enumerator(*filter, "filter", kFilters).value_or(sampling.filter);
  }
  if (const toml::node* const wrap = table.get("wrap")) read_wrap(*wrap, values, sampling);
  if (const toml::node* const border = table.get("border")) {
    sampling.border = values.enumerator(*border, "border", kBorderColors).value_or(sampling.border);
  }
  if (const toml::node* const mipmaps = table.get("mipmaps")) {
    sampling.mipmaps = values.enumerator(*mipmaps, "mipmaps", kMipmaps).value_or(sampling.mipmaps);
  }
}

}  // namespace

Material read_material(const toml::table& table, Values& values) {
  Material material;
  check_keys({table, "[scene.object.material]"},
             {"color", "specular", "shininess", "texture", "filter", "wrap", "border", "mipmaps"},
             values.diagnostics());
  if (const toml::node* const color = table.get("color")) read_vector(*color, "color", values, material.color);
  if (const toml::node* const specular = table.get("specular")) {
    read_vector(*specular, "specular", values, material.specular);
  }
  if (const toml::node* const shininess = table.get("shininess")) {
    const auto exponent = values.integer(*shininess, "shininess", {.min = 1, .max = kMaxShininess});
    material.shininess = static_cast<uint32_t>(exponent.value_or(material.shininess));
  }
  if (const toml::node* const texture = table.get("texture")) {
    if (const auto path = values.text(*texture, "texture")) {
      const Place place = place_of(*texture);
      material.texture = ScenePath{.text = *path, .line = place.line, .column = place.column};
    }
  }
  read_sampling(table, values, material);
  return material;
}

}  // namespace fillrule::format
