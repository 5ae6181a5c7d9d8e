// The sections of a case file, each read for one case: with the variables of that case in place. What cannot be read
// leaves an error in the diagnostics and a default in the result, so that reading goes on and finds the other errors.
#pragma once

#include <fmt/format.h>
#include <toml++/toml.h>

#include <array>
#include <string_view>
#include <vector>

#include "cases/format/toml_access.h"
#include "cases/format/values.h"
#include "cases/model/case.h"
#include "cases/model/scene.h"

namespace fillrule::format {

// title, why, spec, origin, tags and opt_out, into `head`. They hold no variables.
void read_head(const toml::table& root, Diagnostics& diagnostics, Case& head);

// [target]
Target read_target(const toml::table& root, Values& values);

// The state where a file says nothing: viewport and scissor are the whole target.
RasterState default_state(const Target& target);

// [state] or a draw's state: sets the keys that are there. Vulkan's limits on viewports and scissors are checked
// ("Controlling the Viewport", VkViewport; "Scissor Test", vkCmdSetScissor).
void read_state(const Section& section, const Target& target, Values& values, RasterState& state);

// [varyings], in the order of the file.
std::vector<Varying> read_varyings(const toml::table& root, Values& values);

// [[draw]], all of them.
std::vector<Draw> read_draws(const toml::table& root, const Target& target, const std::vector<Varying>& varyings,
                             const RasterState& state, Values& values);

// [scene] and its objects, but for their draws, which are made where models and images can be read.
Scene read_scene(const toml::node& node, Values& values);
// The material of an object: [scene.object.material].
Material read_material(const toml::table& table, Values& values);
// Numbers in an array, as many as `result` has; it keeps its values where they will not do.
template <size_t N>
void read_vector(const toml::node& node, std::string_view label, Values& values, std::array<double, N>& result) {
  const toml::array* const array =
      as_array(node, label, fmt::format("an array of {} numbers", N), values.diagnostics());
  if (array == nullptr) return;
  if (array->size() != N) {
    values.diagnostics().add(place_of(node), fmt::format("{} must be {} numbers, not {}", label, N, array->size()));
    return;
  }
  for (size_t i = 0; i < N; ++i) result[i] = values.finite(*array->get(i), label).value_or(result[i]);
}

}  // namespace fillrule::format
