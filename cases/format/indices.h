// A draw's indices: their type, the vertex offset, primitive restart (Vulkan specification, "Drawing Commands",
// "Programmable Primitive Shading").
#pragma once

#include <toml++/toml.h>

#include <cstdint>

#include "cases/format/values.h"
#include "cases/model/case.h"

namespace fillrule::format {

// The keys index_type, vertex_offset and primitive_restart of a draw whose topology is known.
void read_index_state(const toml::table& table, Values& values, Draw& draw);

// Appends one index to draw.indices: the word "restart", or a number. With the vertex offset added it is one of
// `vertices` vertices; a copy of `repeat` begins at `first_vertex`.
void append_index(const toml::node& node, uint32_t first_vertex, int64_t vertices, Values& values, Draw& draw);

}  // namespace fillrule::format
