#include "reference/exact/samples.h"

#include <array>

namespace fillrule::exact {
namespace {

constexpr double kSteps = 16;  // of a pixel: the grid of the standard locations

struct Steps {
  uint8_t x;
  uint8_t y;
};

template <size_t kCount>
constexpr std::array<Position, kCount> from_steps(const std::array<Steps, kCount>& steps) {
  std::array<Position, kCount> positions;
  for (size_t i = 0; i < kCount; ++i) positions[i] = {.x = steps[i].x / kSteps, .y = steps[i].y / kSteps};
  return positions;
}

constexpr auto kOne = from_steps<1>({{{8, 8}}});
constexpr auto kTwo = from_steps<2>({{{12, 12}, {4, 4}}});
constexpr auto kFour = from_steps<4>({{{6, 2}, {14, 6}, {2, 10}, {10, 14}}});
constexpr auto kEight = from_steps<8>({{{9, 5}, {7, 11}, {13, 9}, {5, 3}, {3, 13}, {1, 7}, {11, 15}, {15, 1}}});
constexpr auto kSixteen = from_steps<16>({{{9, 9},
                                           {7, 5},
                                           {5, 10},
                                           {12, 7},
                                           {3, 6},
                                           {10, 13},
                                           {13, 11},
                                           {11, 3},
                                           {6, 14},
                                           {8, 1},
                                           {4, 2},
                                           {2, 12},
                                           {0, 8},
                                           {15, 4},
                                           {14, 15},
                                           {1, 0}}});

}  // namespace

std::span<const Position> sample_locations(VkSampleCountFlagBits samples) {
  switch (samples) {
    case VK_SAMPLE_COUNT_2_BIT:
      return kTwo;
    case VK_SAMPLE_COUNT_4_BIT:
      return kFour;
    case VK_SAMPLE_COUNT_8_BIT:
      return kEight;
    case VK_SAMPLE_COUNT_16_BIT:
      return kSixteen;
    default:
      return kOne;
  }
}

SamplePlace sample_place(const Target& target, size_t index) {
  const std::span<const Position> locations = sample_locations(target.samples);
  const size_t pixel = index / locations.size();
  SamplePlace place{.x = static_cast<uint32_t>(pixel % target.width),
                    .y = static_cast<uint32_t>(pixel / target.width),
                    .sample = static_cast<uint32_t>(index % locations.size())};
  const Position& location = locations[place.sample];
  place.position = {.x = place.x + location.x, .y = place.y + location.y};
  return place;
}

}  // namespace fillrule::exact
