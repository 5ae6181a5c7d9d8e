// What every stage of the naive rasterizer knows: what is drawn, and which fault to make.
#pragma once

#include <cstdint>

#include "cases/model/case.h"
#include "harness/faults/fault.h"

namespace fillrule::faults {

struct Context {
  const Case& drawn;
  const Draw& draw;
  uint32_t subpixel_bits = 8;
  Fault fault = Fault::kNone;

  [[nodiscard]] bool has(Fault one) const { return fault == one; }
  [[nodiscard]] const RasterState& state() const { return draw.state; }
  [[nodiscard]] bool depth_clip() const { return draw.state.depth_clip || has(Fault::kDepthClipAlways); }
  [[nodiscard]] bool minus_one_to_one() const {
    return draw.state.negative_one_to_one && !has(Fault::kMinusOneToOneIgnored);
  }
};

}  // namespace fillrule::faults
