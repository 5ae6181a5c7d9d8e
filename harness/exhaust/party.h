// Who draws the small world: the candidate and the reference behind one interface, fed with the same bytes.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cases/model/result.h"
#include "harness/exhaust/batch.h"

namespace fillrule::exhaust {

// A triangle list in a square target that the viewport fills; counter-clockwise is front.
struct HitDraw {
  std::span<const PlanePosition> positions_clip;
  uint32_t target_size = 0;  // pixels
  VkCullModeFlags cull_mode = VK_CULL_MODE_NONE;
};

// Counts hits into the target's bytes, row by row: vulkan::kHit for each, vulkan::kFrontHit for those of front faces.
// May be called by several threads at once.
using Drawer = std::function<Result<void>(const HitDraw& draw, std::span<uint8_t> hits)>;

inline constexpr const char* kRenderer = "renderer";

struct Party {
  std::string name;     // "renderer", "lavapipe"
  std::string version;  // the driver's own text; empty for a candidate
  uint32_t subpixel_bits = 8;
  Drawer draw;
};

// Our own renderer.
Party make_renderer(uint32_t subpixel_bits);

// A Vulkan driver, as `fillrule devices` names it; it draws one batch after the other.
Result<Party> make_device(const std::string& driver, const std::vector<std::string>& driver_files,
                          const CellLayout& layout);

}  // namespace fillrule::exhaust
