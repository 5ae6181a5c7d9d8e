// The sections of a case file, each read for one case: with the variables of that case in place. What cannot be read
// leaves an error in the diagnostics and a default in the result, so that reading goes on and finds the other errors.
#pragma once

#include <toml++/toml.h>

#include <vector>

#include "cases/format/toml_access.h"
#include "cases/format/values.h"
#include "cases/model/case.h"

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

}  // namespace fillrule::format
