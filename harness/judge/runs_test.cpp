// Judging whole runs of samples at once finds what judging one sample after the other finds: the same counts for each
// plane, whatever is wrong in the pictures. Maps of verdicts are asked for where every sample is to be judged by
// itself.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "harness/judge/judge.h"
#include "harness/judge/possibilities.h"
#include "harness/programs/varyings.h"

namespace fillrule::judge {
namespace {

constexpr uint32_t kSize = 24;

class Random {
 public:
  explicit Random(uint32_t seed) : engine_(seed) {}
  float between(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }
  uint32_t below(uint32_t end) { return std::uniform_int_distribution<uint32_t>(0, end - 1)(engine_); }

 private:
  std::mt19937 engine_;
};

// One to four draws of two triangles each, one over the other, with depth tests of every kind; some are undefined.
Case layers(Random& random) {
  Case result{.name = "layers",
              .target = {.width = kSize, .height = kSize},
              .varyings = {{.name = "uv", .components = 2, .interpolation = Interpolation::kSmooth},
                           {.name = "id", .components = 1, .interpolation = Interpolation::kFlat}}};
  if (random.below(4) == 0) result.target.samples = VK_SAMPLE_COUNT_4_BIT;
  const uint32_t draws = 1 + random.below(4);
  for (uint32_t i = 0; i < draws; ++i) {
    Draw draw;
    for (uint32_t vertex = 0; vertex < 6; ++vertex) {
      const float w = random.between(1, 4);
      draw.positions.push_back({w * random.between(-1, 1), w * random.between(-1, 1), w * random.between(0, 1), w});
      draw.varyings.insert(draw.varyings.end(), {random.between(0, 1), random.between(-5, 5), static_cast<float>(i)});
    }
    draw.state.viewport = {.x = 0, .y = 0, .width = kSize, .height = kSize, .minDepth = 0, .maxDepth = 1};
    draw.state.scissor = {.offset = {}, .extent = {.width = kSize, .height = kSize}};
    draw.state.depth_test = random.below(3) != 0;
    draw.state.depth_write = random.below(3) != 0;
    draw.state.depth_compare = static_cast<VkCompareOp>(random.below(8));
    if (random.below(5) == 0) draw.state.depth_bias = DepthBias{.slope_factor = 1};
    // What is undefined may be anywhere, so that all of the picture is judged sample by sample.
    if (random.below(6) == 0) draw.positions[random.below(6)][0] = std::numeric_limits<float>::quiet_NaN();
    result.draws.push_back(draw);
  }
  result.target.clear_depth = random.below(2) == 0 ? 1.0F : 0.5F;
  return result;
}

// As if nothing had been drawn.
void clear_at(size_t index, Planes& planes, float clear_depth) {
  planes.hits[index] = 0;
  planes.owner[index] = kNoOwner;
  planes.front_facing[index] = 0;
  planes.depth[index] = clear_depth;
  for (std::vector<float>& plane : planes.varyings) plane[index] = 0;
}

void spoil_somewhere(Planes& planes, float clear_depth, Random& random) {
  const size_t index = random.below(static_cast<uint32_t>(planes.hits.size()));
  switch (random.below(6)) {
    case 0:
      planes.hits[index] = random.below(2) == 0 ? 1 : planes.hits[index] + 1;
      break;
    case 1:
      planes.owner[index] = random.below(8);
      break;
    case 2:
      planes.front_facing[index] ^= 1U;
      break;
    case 3:
      planes.depth[index] = random.below(2) == 0 ? clear_depth : planes.depth[index] + random.between(-0.1F, 0.1F);
      break;
    case 4:
      for (size_t i = index; i < std::min(index + 4, planes.hits.size()); ++i) clear_at(i, planes, clear_depth);
      break;
    default:
      planes.varyings[random.below(3)][index] += 1;
  }
}

// Under something undefined, samples that show nothing are alike, and none of them goes unrecorded.
TEST(Runs, OfMissingSamplesAreRecordedWhole) {
  Case test_case{.name = "under_nan", .target = {.width = kSize, .height = kSize}};
  Draw square{.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP,
              .positions = {{-1, -1, 0.5F, 1}, {1, -1, 0.5F, 1}, {-1, 1, 0.5F, 1}, {1, 1, 0.5F, 1}}};
  square.state.viewport = {.x = 0, .y = 0, .width = kSize, .height = kSize, .minDepth = 0, .maxDepth = 1};
  square.state.scissor = {.offset = {}, .extent = {.width = kSize, .height = kSize}};
  square.state.depth_test = false;
  test_case.draws = {square, square};
  test_case.draws[1].positions[0][0] = std::numeric_limits<float>::quiet_NaN();
  test_case.draws[1].positions.pop_back();
  Result<Planes> planes = programs::draw_case(test_case, {});
  ASSERT_TRUE(planes);
  for (size_t x = 2; x < 6; ++x) clear_at(size_t{3} * kSize + x, *planes, test_case.target.clear_depth);
  const CaseVerdict verdict = judge(test_case, {.planes = &*planes}, nullptr, {});
  EXPECT_EQ(verdict.undefined_samples, verdict.samples);
  EXPECT_EQ(verdict.planes[0].candidate_faults(), 4U);
  EXPECT_EQ(verdict.planes[0].bounds, (Bounds{.min_x = 2, .min_y = 3, .max_x = 5, .max_y = 3}));
}

TEST(Runs, AreJudgedAsTheirSamplesAre) {
  uint64_t faults = 0;
  for (uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Case test_case = layers(random);
    const Result<Planes> right = programs::draw_case(test_case, {});
    ASSERT_TRUE(right);
    Planes wrong = *right;
    for (uint32_t i = random.below(20); i > 0; --i) spoil_somewhere(wrong, test_case.target.clear_depth, random);
    const Party candidate{.planes = &wrong};
    const Party reference{.planes = &*right};
    const CaseVerdict in_runs = judge(test_case, candidate, &reference, {});
    const CaseVerdict one_by_one = judge(test_case, candidate, &reference, {.keep_maps = true});
    EXPECT_EQ(in_runs.covered_samples, one_by_one.covered_samples);
    for (size_t p = 0; p < in_runs.planes.size(); ++p) {
      EXPECT_EQ(in_runs.planes[p].counts, one_by_one.planes[p].counts) << in_runs.planes[p].name;
      EXPECT_EQ(in_runs.planes[p].bounds, one_by_one.planes[p].bounds) << in_runs.planes[p].name;
    }
    EXPECT_EQ(in_runs.reference_faults(), 0U);
    const CaseVerdict other_way = judge(test_case, reference, &candidate, {});
    const CaseVerdict other_way_one_by_one = judge(test_case, reference, &candidate, {.keep_maps = true});
    for (size_t p = 0; p < other_way.planes.size(); ++p) {
      EXPECT_EQ(other_way.planes[p].counts, other_way_one_by_one.planes[p].counts) << other_way.planes[p].name;
    }
    EXPECT_EQ(other_way.candidate_faults(), 0U);
    const CaseVerdict alone_in_runs = judge(test_case, candidate, nullptr, {});
    const CaseVerdict alone_one_by_one = judge(test_case, candidate, nullptr, {.keep_maps = true});
    for (size_t p = 0; p < alone_in_runs.planes.size(); ++p) {
      EXPECT_EQ(alone_in_runs.planes[p].candidate_faults(), alone_one_by_one.planes[p].candidate_faults());
    }
    faults += in_runs.candidate_faults();
  }
  EXPECT_GT(faults, 500U);
}

TEST(Runs, WhatIsTheSameAtBothEndsIsTheSameBetween) {
  size_t same = 0;
  size_t not_same = 0;
  for (uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Case test_case = layers(random);
    const exact::Expectation expectation(test_case, 8);
    ValueCache values(test_case, expectation);
    Replay replay(test_case, expectation, values, 8, {});
    const std::vector<uint32_t>& classes = expectation.classes();
    const size_t row = size_t{kSize} * static_cast<size_t>(test_case.target.samples);
    for (size_t begin = 0, end = 0; begin < classes.size(); begin = end) {
      const size_t end_of_row = begin - begin % row + row;
      for (end = begin + 1; end < end_of_row && classes[end] == classes[begin];) ++end;
      if (end - begin < 3 || !replay.may_tell_between(begin)) continue;
      if (!replay.is_same_between(begin, end - 1)) {
        ++not_same;
        continue;
      }
      ++same;
      const Possibilities expected = replay.at(end - 1);
      for (size_t index = begin; index < end; ++index) {
        const Possibilities& found = replay.at(index);
        EXPECT_EQ(found.outcomes, expected.outcomes) << index;
        EXPECT_EQ(found.least_hits, expected.least_hits) << index;
        EXPECT_EQ(found.most_hits, expected.most_hits) << index;
      }
    }
  }
  EXPECT_GT(same, 1000U);
  EXPECT_GT(not_same, 100U);
}

}  // namespace
}  // namespace fillrule::judge
