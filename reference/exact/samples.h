// Where the samples of a pixel are: Vulkan's standard sample locations (specification, "Multisampling"), which
// parties are asked for. Written apart from the renderer's, so that the two cannot share a mistake.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <span>

#include "cases/model/case.h"

namespace fillrule::exact {

// In framebuffer coordinates, or from a pixel's top left corner.
struct Position {
  double x = 0;
  double y = 0;
  bool operator==(const Position&) const = default;
};

// From the pixel's top left corner, in the order of the samples' numbers.
std::span<const Position> sample_locations(VkSampleCountFlagBits samples);

// One sample of a target, by its index in Planes.
struct SamplePlace {
  uint32_t x = 0;       // pixel
  uint32_t y = 0;       // pixel
  uint32_t sample = 0;  // of the pixel
  Position position;    // in the framebuffer
};
SamplePlace sample_place(const Target& target, size_t index);

}  // namespace fillrule::exact
