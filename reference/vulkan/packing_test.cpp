#include "reference/vulkan/packing.h"

#include <gmock/gmock.h>

namespace fillrule::vulkan {
namespace {

using testing::ElementsAre;

TEST(Packing, ComponentsOfOneInterpolationFollowEachOther) {
  const Packing packing = pack({{.name = "a", .components = 3, .interpolation = Interpolation::kFlat},
                                {.name = "b", .components = 2, .interpolation = Interpolation::kSmooth},
                                {.name = "c", .components = 1, .interpolation = Interpolation::kNoperspective},
                                {.name = "d", .components = 3, .interpolation = Interpolation::kSmooth},
                                {.name = "e", .components = 2, .interpolation = Interpolation::kFlat}});
  EXPECT_EQ(packing.counts, (SlotCounts{.smooth = 2, .noperspective = 1, .flat = 2}));
  using Place = ComponentPlace;
  EXPECT_THAT(packing.components, ElementsAre(Place{3, 0}, Place{3, 1}, Place{3, 2},  // a
                                              Place{0, 0}, Place{0, 1},               // b
                                              Place{2, 0},                            // c
                                              Place{0, 2}, Place{0, 3}, Place{1, 0},  // d
                                              Place{3, 3}, Place{4, 0}));             // e
}

TEST(Packing, NoVaryingsNeedNoSlotsButOnePass) {
  const Packing packing = pack({});
  EXPECT_EQ(packing.counts.total(), 0U);
  const std::vector<SlotRange> passes = split_into_passes(packing.counts, 6);
  ASSERT_EQ(passes.size(), 1U);
  EXPECT_EQ(passes[0].counts, SlotCounts{});
}

TEST(Packing, PassesAreFilledInSlotOrder) {
  const std::vector<SlotRange> passes = split_into_passes({.smooth = 4, .noperspective = 3, .flat = 6}, 6);
  ASSERT_EQ(passes.size(), 3U);
  EXPECT_EQ(passes[0].first, 0U);
  EXPECT_EQ(passes[0].counts, (SlotCounts{.smooth = 4, .noperspective = 2}));
  EXPECT_EQ(passes[1].first, 6U);
  EXPECT_EQ(passes[1].counts, (SlotCounts{.noperspective = 1, .flat = 5}));
  EXPECT_EQ(passes[2].first, 12U);
  EXPECT_EQ(passes[2].counts, (SlotCounts{.flat = 1}));
}

TEST(Packing, SlotsThatJustFitTakeOnePass) {
  EXPECT_EQ(split_into_passes({.smooth = 1, .noperspective = 2, .flat = 3}, 6).size(), 1U);
}

}  // namespace
}  // namespace fillrule::vulkan
