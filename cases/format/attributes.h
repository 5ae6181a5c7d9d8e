// What a vertex has beside position and varyings: the keys point_sizes, clip_distances and cull_distances of a draw.
#pragma once

#include <toml++/toml.h>

#include <cstddef>

#include "cases/format/values.h"
#include "cases/model/case.h"

namespace fillrule::format {

// Checked once and evaluated for each copy of `repeat`; null where there are none, or wrong ones.
struct VertexAttributes {
  const toml::node* point_sizes = nullptr;      // a number for all vertices, or an array of one for each position
  const toml::array* clip_distances = nullptr;  // for each position a number, or an array of them
  const toml::array* cull_distances = nullptr;
};

// Sets the draw's numbers of distances: those of the first position.
VertexAttributes find_attributes(const toml::table& table, size_t positions, Diagnostics& diagnostics, Draw& draw);

// Appends those of one copy of the draw's positions.
void append_attributes(const VertexAttributes& attributes, size_t positions, Values& values, Draw& draw);

}  // namespace fillrule::format
