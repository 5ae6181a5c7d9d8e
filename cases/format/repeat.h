// `repeat = { i = 8, j = 4 }`: the copies of a draw's vertices, one for each combination of the variables.
#pragma once

#include <toml++/toml.h>

#include <functional>

#include "cases/format/values.h"

namespace fillrule::format {

// Calls `emit` for each copy with the variables defined, the last one running fastest; once if `node` is null. More
// than `max_copies` are an error.
void for_each_copy(const toml::node* node, size_t max_copies, Values& values, const std::function<void()>& emit);

}  // namespace fillrule::format
