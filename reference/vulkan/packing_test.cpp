#include "reference/vulkan/packing.h"

#include <gmock/gmock.h>

namespace fillrule::vulkan {
namespace {

using testing::ElementsAre;

using enum SlotKind;

SlotCounts counts_of(std::initializer_list<std::pair<SlotKind, uint32_t>> counts) {
  SlotCounts all;
  for (const auto& [kind, count] : counts) all.of[static_cast<size_t>(kind)] = count;
  return all;
}

TEST(Packing, ComponentsOfOneInterpolationFollowEachOther) {
  const Packing packing = pack({{.name = "a", .components = 3, .interpolation = Interpolation::kFlat},
                                {.name = "b", .components = 2, .interpolation = Interpolation::kSmooth},
                                {.name = "c", .components = 1, .interpolation = Interpolation::kNoperspective},
                                {.name = "d", .components = 3, .interpolation = Interpolation::kSmooth},
                                {.name = "e", .components = 2, .interpolation = Interpolation::kFlat}});
  EXPECT_EQ(packing.counts, counts_of({{kSmooth, 2}, {kNoperspective, 1}, {kFlat, 2}}));
  using Place = ComponentPlace;
  EXPECT_THAT(packing.components, ElementsAre(Place{3, 0}, Place{3, 1}, Place{3, 2},  // a
                                              Place{0, 0}, Place{0, 1},               // b
                                              Place{2, 0},                            // c
                                              Place{0, 2}, Place{0, 3}, Place{1, 0},  // d
                                              Place{3, 3}, Place{4, 0}));             // e
}

TEST(Packing, EverySamplingIsAKindOfItsOwnButOfFlatOnes) {
  const Packing packing = pack({{.name = "a", .sampling = Sampling::kSample},
                                {.name = "b", .interpolation = Interpolation::kFlat, .sampling = Sampling::kSample},
                                {.name = "c", .interpolation = Interpolation::kNoperspective},
                                {.name = "d", .sampling = Sampling::kCentroid},
                                {.name = "e", .components = 4}});
  EXPECT_EQ(packing.counts,
            counts_of({{kSmooth, 1}, {kSmoothCentroid, 1}, {kSmoothSample, 1}, {kNoperspective, 1}, {kFlat, 1}}));
  using Place = ComponentPlace;
  EXPECT_THAT(packing.components, ElementsAre(Place{2, 0}, Place{4, 0}, Place{3, 0}, Place{1, 0},  //
                                              Place{0, 0}, Place{0, 1}, Place{0, 2}, Place{0, 3}));
  EXPECT_EQ(packing.vertex_components, packing.components);
}

TEST(Packing, BuiltInsComeLastAndAreNotInTheVertices) {
  const Packing packing = pack({{.name = "p", .components = 2, .source = VaryingSource::kPointCoord},
                                {.name = "f", .components = 4, .source = VaryingSource::kFragCoord},
                                {.name = "q", .components = 2, .source = VaryingSource::kPointCoord},
                                {.name = "v"}});
  EXPECT_EQ(packing.counts, counts_of({{kSmooth, 1}, {kFragCoord, 1}, {kPointCoord, 1}}));
  EXPECT_EQ(packing.counts.interpolated(), 1U);
  using Place = ComponentPlace;
  EXPECT_THAT(packing.components, ElementsAre(Place{2, 0}, Place{2, 1},                            // p
                                              Place{1, 0}, Place{1, 1}, Place{1, 2}, Place{1, 3},  // f
                                              Place{2, 2}, Place{2, 3},                            // q
                                              Place{0, 0}));                                       // v
  EXPECT_THAT(packing.vertex_components, ElementsAre(Place{0, 0}));
}

TEST(Packing, NoVaryingsNeedNoSlotsButOnePass) {
  const Packing packing = pack({});
  EXPECT_EQ(packing.counts.total(), 0U);
  const std::vector<SlotRange> passes = split_into_passes(packing.counts, 6);
  ASSERT_EQ(passes.size(), 1U);
  EXPECT_EQ(passes[0].counts, SlotCounts{});
}

TEST(Packing, PassesAreFilledInSlotOrder) {
  const std::vector<SlotRange> passes =
      split_into_passes(counts_of({{kSmooth, 4}, {kNoperspectiveSample, 3}, {kPointCoord, 6}}), 6);
  ASSERT_EQ(passes.size(), 3U);
  EXPECT_EQ(passes[0].first, 0U);
  EXPECT_EQ(passes[0].counts, counts_of({{kSmooth, 4}, {kNoperspectiveSample, 2}}));
  EXPECT_EQ(passes[1].first, 6U);
  EXPECT_EQ(passes[1].counts, counts_of({{kNoperspectiveSample, 1}, {kPointCoord, 5}}));
  EXPECT_EQ(passes[2].first, 12U);
  EXPECT_EQ(passes[2].counts, counts_of({{kPointCoord, 1}}));
}

TEST(Packing, SlotsThatJustFitTakeOnePass) {
  EXPECT_EQ(split_into_passes(counts_of({{kSmooth, 1}, {kNoperspective, 2}, {kFlat, 3}}), 6).size(), 1U);
}

}  // namespace
}  // namespace fillrule::vulkan
