#include "cases/format/position.h"

#include <fmt/format.h>

#include <cmath>

namespace fillrule::format {
namespace {

std::optional<float> rounded_coordinate(const toml::node& node, double value, bool finite_inputs, Values& values) {
  const auto rounded = static_cast<float>(value);
  if (finite_inputs && !std::isfinite(rounded)) {
    values.diagnostics().add(place_of(node), fmt::format("clip-space coordinate {} is beyond float32", value),
                             "write inf if infinity is meant");
    return std::nullopt;
  }
  return rounded;
}

ClipPosition read_clip_position(const toml::array& coordinates, Values& values) {
  ClipPosition clip{};
  for (size_t i = 0; i < clip.size(); ++i) {
    clip[i] = values.float32(*coordinates.get(i), "coordinate").value_or(0.0F);
  }
  return clip;
}

ClipPosition read_other_position(const toml::array& coordinates, PositionSpace space, const RasterState& state,
                                 Values& values) {
  Position position{0.0, 0.0, 0.5, 1.0};
  bool finite_inputs = true;
  for (size_t i = 0; i < coordinates.size(); ++i) {
    const auto number = values.number(*coordinates.get(i), "coordinate");
    if (!number) return {};
    position[i] = number->value;
    finite_inputs = finite_inputs && std::isfinite(number->value);
  }
  Position pos_clip = clip_from(space, position, state);
  // Without a depth (and so with w = 1) the position lies in the middle of NDC, whatever the viewport's depth range.
  if (coordinates.size() == 2) pos_clip[2] = 0.5;
  ClipPosition rounded{};
  for (size_t i = 0; i < rounded.size(); ++i) {
    const auto value = rounded_coordinate(coordinates, pos_clip[i], finite_inputs, values);
    if (!value) return {};
    rounded[i] = *value;
  }
  return rounded;
}

}  // namespace

ClipPosition read_position(const toml::node& node, PositionSpace space, const RasterState& state, Values& values) {
  const bool clip = space == PositionSpace::kClip;
  const std::string_view expected = clip ? "[x, y, z, w]" : "[x, y], [x, y, z] or [x, y, z, w]";
  const toml::array* const coordinates = as_array(node, "position", expected, values.diagnostics());
  if (coordinates == nullptr) return {};
  const size_t count = coordinates->size();
  if (count > 4 || count < (clip ? 4U : 2U)) {
    values.diagnostics().add(place_of(node),
                             fmt::format("position in {} space must be {}, not {} numbers",
                                         enum_name(kPositionSpaces, space), expected, count),
                             clip ? R"(other spaces: space = "ndc" or "framebuffer")" : "");
    return {};
  }
  return clip ? read_clip_position(*coordinates, values) : read_other_position(*coordinates, space, state, values);
}

}  // namespace fillrule::format
