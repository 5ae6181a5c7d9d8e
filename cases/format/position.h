// One position of a draw, as the file gives it, in clip space.
#pragma once

#include <toml++/toml.h>

#include "cases/format/space.h"
#include "cases/format/values.h"
#include "cases/model/case.h"

namespace fillrule::format {

// Clip space wants [x, y, z, w]; the others may leave out w, or z and w. Zeros, with an error, if it cannot be read.
ClipPosition read_position(const toml::node& node, PositionSpace space, const RasterState& state, Values& values);

}  // namespace fillrule::format
