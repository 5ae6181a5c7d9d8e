// The judge is shown right pictures with one thing made wrong at a time, and has to say what is wrong and whose fault
// it is. The right pictures come from the oracle itself.
#include "harness/judge/judge.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>
#include <functional>
#include <limits>

#include "reference/exact/expectation.h"

namespace fillrule::judge {
namespace {

constexpr uint32_t kSize = 16;
constexpr double kHalfSize = kSize / 2.0;

ClipPosition at(double x, double y, double z = 0.5, double w = 1) {
  return {static_cast<float>((x / kHalfSize - 1) * w), static_cast<float>((y / kHalfSize - 1) * w),
          static_cast<float>(z * w), static_cast<float>(w)};
}

Draw draw_of(std::vector<ClipPosition> positions) {
  Draw draw{.positions = std::move(positions)};
  draw.state.viewport = {.x = 0, .y = 0, .width = kSize, .height = kSize, .minDepth = 0, .maxDepth = 1};
  draw.state.scissor = {.offset = {}, .extent = {.width = kSize, .height = kSize}};
  draw.state.depth_test = true;
  draw.state.depth_compare = VK_COMPARE_OP_LESS_OR_EQUAL;
  for (size_t i = 0; i < draw.positions.size(); ++i) {
    const auto corner = static_cast<float>(i % 3);
    draw.varyings.insert(draw.varyings.end(), {corner, 1 - corner, corner + 10});
  }
  return draw;
}

// A square of two triangles in perspective, its diagonal through pixel centres.
Case square() {
  Case result{.name = "square",
              .target = {.width = kSize, .height = kSize},
              .varyings = {{.name = "uv", .components = 2, .interpolation = Interpolation::kSmooth},
                           {.name = "id", .components = 1, .interpolation = Interpolation::kFlat}}};
  result.draws.push_back(draw_of({at(2, 2, 0.2, 1), at(14, 2, 0.4, 2), at(2, 14, 0.3, 1), at(14, 2, 0.4, 2),
                                  at(14, 14, 0.8, 4), at(2, 14, 0.3, 1)}));
  return result;
}

// What a rasterizer without any error draws: each sample owned by the top-left rule, values rounded once.
Planes perfect(const Case& test_case) {
  const exact::Expectation expectation(test_case, 8);
  Planes planes = Planes::cleared(kSize, kSize, 1, component_count(test_case.varyings), test_case.target.clear_depth);
  for (size_t index = 0; index < planes.hits.size(); ++index) {
    const double x = static_cast<double>(index % kSize) + 0.5;
    const size_t row = index / kSize;
    const double y = static_cast<double>(row) + 0.5;
    std::vector<exact::Entry> entries;
    expectation.collect(index, entries);
    for (const exact::Entry& entry : entries) {
      const exact::Piece& piece = expectation.pieces()[entry.piece];
      if (piece.shape->undefined() || !piece.shape->owns(x, y)) continue;
      const auto values = exact::values_of(test_case, piece);
      ++planes.hits[index];
      planes.owner[index] = piece.owner;
      planes.front_facing[index] = piece.front_facing ? 1 : 0;
      planes.depth[index] = static_cast<float>(values->depth(x, y).value);
      uint32_t component = 0;
      for (const Varying& varying : test_case.varyings) {
        for (uint32_t c = 0; c < varying.components; ++c, ++component) {
          const bool flat = varying.interpolation == Interpolation::kFlat;
          planes.varyings[component][index] =
              flat ? values->provoking(component) : static_cast<float>(values->varying_for(component, 0, x, y).value);
        }
      }
    }
  }
  return planes;
}

size_t index_of(uint32_t x, uint32_t y) {
  return size_t{y} * kSize + x;
}

const PlaneVerdict& plane(const CaseVerdict& verdict, const std::string& name) {
  for (const PlaneVerdict& candidate : verdict.planes) {
    if (candidate.name == name) return candidate;
  }
  throw std::out_of_range(name);
}

CaseVerdict judge_pair(const Case& test_case, const Planes& candidate, const Planes& reference,
                       Profile profile = {}) {
  const Party reference_party{.planes = &reference};
  return judge(test_case, {.planes = &candidate}, &reference_party, {.profile = profile, .keep_maps = true});
}

using Spoil = std::function<void(Planes&)>;

// Spoils the candidate alone, the reference alone, and both; expects the fault where it was made.
void expect_fault(const std::string& plane_name, const Spoil& spoil, const Case& test_case = square()) {
  const Planes right = perfect(test_case);
  Planes wrong = right;
  spoil(wrong);
  const CaseVerdict candidate_wrong = judge_pair(test_case, wrong, right);
  EXPECT_EQ(plane(candidate_wrong, plane_name).candidate_faults(), 1U) << plane_name;
  EXPECT_EQ(candidate_wrong.reference_faults(), 0U) << plane_name;
  const CaseVerdict reference_wrong = judge_pair(test_case, right, wrong);
  EXPECT_EQ(reference_wrong.candidate_faults(), 0U) << plane_name;
  EXPECT_EQ(plane(reference_wrong, plane_name).reference_faults(), 1U) << plane_name;
  const CaseVerdict both_wrong = judge_pair(test_case, wrong, wrong);
  EXPECT_EQ(plane(both_wrong, plane_name).count(Verdict::kBothFault), 1U) << plane_name;
  const CaseVerdict alone = judge(test_case, {.planes = &wrong}, nullptr, {});
  EXPECT_EQ(plane(alone, plane_name).candidate_faults(), 1U) << plane_name;
}

TEST(Profile, IsNamedByItsParts) {
  EXPECT_EQ(to_string(Profile{}), "");
  EXPECT_EQ(to_string(Profile{.top_left = true, .same_bits = true}), "top_left,same_bits");
}

TEST(Judge, MapsComeWithTheOraclesAnswers) {
  const Planes right = perfect(square());
  const CaseVerdict verdict = judge_pair(square(), right, right);
  const size_t inside = size_t{4} * right.width + 4;
  ASSERT_EQ(verdict.oracle.size(), verdict.samples);
  EXPECT_EQ(verdict.oracle[inside].coverage, OracleAnswer::Coverage::kMust);
  EXPECT_EQ(verdict.oracle[inside].owner, right.owner[inside]);
  EXPECT_EQ(verdict.oracle[0].coverage, OracleAnswer::Coverage::kMustNot);
  EXPECT_EQ(verdict.oracle[0].owner, kNoOwner);
}

TEST(Judge, APerfectPictureIsIdenticalToItselfAndToTheOracle) {
  const Case test_case = square();
  const Planes planes = perfect(test_case);
  const CaseVerdict verdict =
      judge_pair(test_case, planes, planes, {.top_left = true, .precise = true, .same_bits = true});
  EXPECT_EQ(verdict.count(Verdict::kIdentical), verdict.samples * verdict.planes.size());
  const CaseVerdict alone = judge(test_case, {.planes = &planes}, nullptr, {});
  EXPECT_EQ(alone.candidate_faults(), 0U);
  EXPECT_EQ(alone.count(Verdict::kImprecise), 0U);
  EXPECT_GT(alone.may_samples, 0U);
  EXPECT_LT(alone.may_samples, alone.covered_samples);
  EXPECT_EQ(verdict.may_samples, 0U);  // the profile leaves no tie open
}

TEST(Judge, AMissingSampleIsAFaultOfCoverage) {
  expect_fault("coverage", [](Planes& planes) {
    const size_t i = index_of(5, 5);
    planes.hits[i] = 0;
    planes.owner[i] = kNoOwner;
    planes.depth[i] = 1;
    for (auto& varying : planes.varyings) varying[i] = 0;
  });
}

TEST(Judge, AnExtraSampleIsAFaultOfCoverage) {
  expect_fault("coverage", [](Planes& planes) {
    planes.hits[index_of(0, 0)] = 1;
    planes.owner[index_of(0, 0)] = 0;
  });
}

TEST(Judge, ADoubleHitOnASharedEdgeIsAFaultOfHits) {
  expect_fault("hits", [](Planes& planes) { planes.hits[index_of(7, 8)] = 2; });
}

TEST(Judge, AGapOnASharedEdgeIsAFaultOfCoverage) {
  expect_fault("coverage", [](Planes& planes) {
    const size_t i = index_of(7, 8);
    planes.hits[i] = 0;
    planes.owner[i] = kNoOwner;
    planes.depth[i] = 1;
  });
}

TEST(Judge, AWrongOwnerIsToldFromAnOpenOne) {
  expect_fault("owner", [](Planes& planes) { planes.owner[index_of(4, 4)] = 1; });
  const Case test_case = square();
  const Planes right = perfect(test_case);
  Planes other = right;
  other.owner[index_of(7, 8)] ^= 1U;  // on the diagonal either triangle may own the sample
  EXPECT_EQ(judge_pair(test_case, other, right).candidate_faults(), 0U);
  EXPECT_EQ(judge_pair(test_case, other, right, {.top_left = true}).candidate_faults(), 1U);
  EXPECT_EQ(judge_pair(test_case, other, right, {.same_bits = true}).candidate_faults(), 1U);
  // A profile asks nothing of the reference.
  EXPECT_EQ(judge_pair(test_case, right, other, {.top_left = true}).reference_faults(), 0U);
}

// The same value is right for one owner and wrong for the other.
TEST(Judge, EqualValuesOfDifferentOwnersDoNotStandAlike) {
  Case test_case = square();
  constexpr size_t kIdOfSecondTriangle = size_t{3} * 3 + 2;
  test_case.draws[0].varyings[kIdOfSecondTriangle] = 20;
  const Planes right = perfect(test_case);
  Planes other = right;
  other.owner[index_of(7, 8)] ^= 1U;  // on the diagonal either triangle may own the sample
  const CaseVerdict verdict = judge_pair(test_case, right, other);
  EXPECT_EQ(plane(verdict, "id").reference_faults(), 1U);
  EXPECT_EQ(plane(verdict, "owner").reference_faults(), 0U);
  EXPECT_EQ(verdict.candidate_faults(), 0U);
}

// Lavapipe finds the facing of unclipped triangles before it rounds positions if another triangle of the draw is
// clipped, and after it otherwise.
TEST(Judge, SameBitsAreNotAskedForWhereRoundingMayCullATriangle) {
  Case test_case = square();
  test_case.draws = {draw_of({at(4, 8.5), at(12, 8.5 + 0x1p-10), at(8, 8.5 + 0x1p-9)})};
  test_case.draws[0].state.depth_test = false;
  // Faults of a picture with one more sample than the other, where the triangle may cover it.
  const auto faults = [&test_case](VkCullModeFlags cull_mode) {
    test_case.draws[0].state.cull_mode = cull_mode;
    const exact::Expectation expectation(test_case, 8);
    EXPECT_TRUE(expectation.pieces()[0].facing_in_doubt);
    const auto is_open = [&expectation](uint32_t number) {
      return number != exact::kNothing && !expectation.sole(number);
    };
    const auto sample =
        static_cast<size_t>(std::ranges::find_if(expectation.classes(), is_open) - expectation.classes().begin());
    if (sample == expectation.classes().size()) return ~uint64_t{0};
    const Planes nothing = Planes::cleared(test_case.target.width, test_case.target.height, 1,
                                           component_count(test_case.varyings), test_case.target.clear_depth);
    Planes other = nothing;
    other.hits[sample] = 1;
    other.owner[sample] = 0;
    return plane(judge_pair(test_case, other, nothing, {.same_bits = true}), "coverage").candidate_faults();
  };
  EXPECT_EQ(faults(VK_CULL_MODE_BACK_BIT), 0U);
  EXPECT_EQ(faults(VK_CULL_MODE_NONE), 1U);
}

// Its facing is in doubt for a rasterizer that rounds, but vertices on the grid are not rounded.
TEST(Judge, ASliverOnTheGridThatIsCulledStaysCulledUnderTopLeft) {
  Case test_case = square();
  test_case.draws = {draw_of({at(2.5, 4.5), at(12.5, 4.5), at(8.5, 4.5 + 0x1p-8)})};
  test_case.draws[0].state.cull_mode = VK_CULL_MODE_BACK_BIT;
  test_case.draws[0].state.depth_test = false;
  const Planes nothing = Planes::cleared(kSize, kSize, 1, component_count(test_case.varyings), 1.0F);
  EXPECT_TRUE(exact::Expectation(test_case, 8).pieces()[0].facing_in_doubt);
  const auto faults = [&](bool top_left) {
    return judge(test_case, {.planes = &nothing}, nullptr, {.profile = {.top_left = top_left}}).candidate_faults();
  };
  EXPECT_EQ(faults(false), 0U);
  EXPECT_EQ(faults(true), 0U);
  test_case.draws[0].state.cull_mode = VK_CULL_MODE_NONE;
  EXPECT_EQ(faults(false), 0U);
  EXPECT_GT(faults(true), 0U);
}

TEST(Judge, AWrongFacingIsAFault) {
  expect_fault("front_facing", [](Planes& planes) { planes.front_facing[index_of(4, 4)] ^= 1U; });
}

TEST(Judge, ValuesArePermittedThenImpreciseThenAtFault) {
  const Case test_case = square();
  const Planes right = perfect(test_case);
  const size_t i = index_of(4, 4);
  const auto verdict_of = [&](float depth, Profile profile = {}) {
    Planes other = right;
    other.depth[i] = depth;
    return plane(judge_pair(test_case, other, right, profile), "depth").map[i];
  };
  Planes far_off = right;
  far_off.depth[i] += 0.5F;
  const double tolerance = plane(judge_pair(test_case, far_off, right), "depth").worst->tolerance;
  const auto moved = [&](double times) { return static_cast<float>(double{right.depth[i]} + times * tolerance); };
  EXPECT_EQ(verdict_of(moved(0.9)), Verdict::kPermitted);
  EXPECT_EQ(verdict_of(moved(1.5)), Verdict::kImprecise);
  EXPECT_EQ(verdict_of(moved(1.5), {.precise = true}), Verdict::kCandidateFault);
  EXPECT_EQ(verdict_of(moved(-63)), Verdict::kImprecise);
  EXPECT_EQ(verdict_of(moved(65)), Verdict::kCandidateFault);
  EXPECT_EQ(verdict_of(std::numeric_limits<float>::quiet_NaN()), Verdict::kCandidateFault);
}

TEST(Judge, AWrongVaryingIsAFaultOfItsPlaneAlone) {
  expect_fault("uv", [](Planes& planes) { planes.varyings[1][index_of(4, 4)] += 0.25F; });
  expect_fault("id", [](Planes& planes) {
    float& value = planes.varyings[2][index_of(4, 4)];
    value = std::nextafter(value, 100.0F);
  });
  expect_fault("uv", [](Planes& planes) { planes.varyings[0][index_of(9, 3)] = INFINITY; });
}

TEST(Judge, WhereNothingLandedNothingMayBeWritten) {
  expect_fault("depth", [](Planes& planes) { planes.depth[index_of(0, 0)] = 0.999F; });
  expect_fault("uv", [](Planes& planes) { planes.varyings[0][index_of(0, 0)] = 1; });
}

TEST(Judge, TheDepthTestDecidesWhoOwnsASample) {
  Case layered = square();
  layered.draws.push_back(layered.draws.front());
  for (ClipPosition& position : layered.draws[1].positions) position[2] = 0.95F * position[3];
  const Planes front = perfect(square());
  EXPECT_EQ(judge(layered, {.planes = &front}, nullptr, {}).candidate_faults(), 0U);
  Planes behind = front;
  behind.owner[index_of(4, 4)] = 2;
  behind.hits[index_of(4, 4)] = 2;
  const CaseVerdict verdict = judge(layered, {.planes = &behind}, nullptr, {});
  EXPECT_EQ(plane(verdict, "owner").candidate_faults(), 1U);
  EXPECT_EQ(plane(verdict, "hits").candidate_faults(), 1U);
}

// Two layers that cross: along a row the same two primitives land, now the one in front, now the other.
TEST(Judge, TheDepthTestIsAskedAtEverySample) {
  Case test_case = square();
  const Draw nearer_left = draw_of({at(1, 1, 0.25), at(15, 1, 0.75), at(8, 15, 0.5)});
  const Draw nearer_right = draw_of({at(1, 1, 0.75), at(15, 1, 0.25), at(8, 15, 0.5)});
  test_case.draws = {nearer_left};
  Planes planes = perfect(test_case);
  const Planes left = planes;
  test_case.draws = {nearer_right};
  const Planes right = perfect(test_case);
  for (size_t i = 0; i < planes.hits.size(); ++i) {
    if (i % kSize < kSize / 2 || planes.hits[i] == 0) continue;
    planes.hits[i] = 2;
    planes.owner[i] = 1;
    planes.depth[i] = right.depth[i];
  }
  test_case.draws = {nearer_left, nearer_right};
  EXPECT_EQ(judge(test_case, {.planes = &planes}, nullptr, {}).candidate_faults(), 0U);
  EXPECT_GT(judge(test_case, {.planes = &left}, nullptr, {}).candidate_faults(), 0U);
}

TEST(Judge, TheSameGeometryDrawnTwiceHasTheSameDepth) {
  Case twice = square();
  twice.draws.push_back(twice.draws.front());
  const auto hits_faults = [&twice](VkCompareOp op, uint32_t hits) {
    twice.draws[1].state.depth_compare = op;
    Planes planes = perfect(square());
    for (uint32_t& count : planes.hits) count = count != 0 ? hits : 0;
    for (uint32_t& owner : planes.owner) owner += owner != kNoOwner && hits == 2 ? 2 : 0;
    return judge(twice, {.planes = &planes}, nullptr, {}).candidate_faults();
  };
  EXPECT_EQ(hits_faults(VK_COMPARE_OP_LESS, 1), 0U);
  EXPECT_GT(hits_faults(VK_COMPARE_OP_LESS, 2), 0U);
  EXPECT_EQ(hits_faults(VK_COMPARE_OP_EQUAL, 2), 0U);
  EXPECT_GT(hits_faults(VK_COMPARE_OP_EQUAL, 1), 0U);
}

TEST(Judge, AnUndefinedPrimitiveIsNobodysFaultAndLeavesItsNeighboursJudged) {
  Case with_nan = square();
  Draw nan = draw_of({at(2, 2), at(14, 2), at(2, 14)});
  nan.positions[1][0] = std::numeric_limits<float>::quiet_NaN();
  with_nan.draws.push_back(nan);
  const Planes neighbours = perfect(square());
  const CaseVerdict verdict = judge(with_nan, {.planes = &neighbours}, nullptr, {});
  EXPECT_EQ(verdict.candidate_faults(), 0U);
  EXPECT_EQ(verdict.undefined_samples, verdict.samples);
  Planes disturbed = neighbours;
  disturbed.hits[index_of(4, 4)] = 0;
  disturbed.owner[index_of(4, 4)] = kNoOwner;
  disturbed.depth[index_of(4, 4)] = 1;
  EXPECT_GT(judge(with_nan, {.planes = &disturbed}, nullptr, {}).candidate_faults(), 0U);
}

TEST(Judge, ReportsTheBoxTheFirstAndTheWorstSample) {
  const Case test_case = square();
  const Planes right = perfect(test_case);
  Planes wrong = right;
  wrong.depth[index_of(4, 3)] += 0.1F;
  wrong.depth[index_of(3, 6)] += 0.3F;
  const CaseVerdict verdict = judge_pair(test_case, wrong, right);
  const PlaneVerdict& depth = plane(verdict, "depth");
  EXPECT_EQ(depth.candidate_faults(), 2U);
  EXPECT_EQ(depth.first->x, 4U);
  EXPECT_EQ(depth.first->y, 3U);
  EXPECT_EQ(depth.worst->x, 3U);
  EXPECT_EQ(depth.worst->y, 6U);
  EXPECT_EQ(verdict.worst()->x, 3U);
  EXPECT_EQ(verdict.worst()->y, 6U);
  EXPECT_FALSE(judge_pair(test_case, right, right).worst());
  EXPECT_EQ(depth.bounds->min_x, 3U);
  EXPECT_EQ(depth.bounds->min_y, 3U);
  EXPECT_EQ(depth.bounds->max_x, 4U);
  EXPECT_EQ(depth.bounds->max_y, 6U);
}

TEST(Judge, KeepsTheWorstSamplesTheGravestFirst) {
  const Case test_case = square();
  const Planes right = perfect(test_case);
  Planes wrong = right;
  wrong.depth[index_of(4, 3)] += 0.1F;
  wrong.depth[index_of(3, 6)] += 0.3F;
  wrong.depth[index_of(5, 6)] += 0.1F;
  const CaseVerdict verdict = judge_pair(test_case, wrong, right);
  const std::vector<SampleRecord>& worst = plane(verdict, "depth").worst_samples;
  ASSERT_EQ(worst.size(), 3U);
  EXPECT_EQ(worst[0].x, 3U);
  EXPECT_GE(worst[1].severity, worst[2].severity);
  EXPECT_TRUE(plane(verdict, "owner").worst_samples.empty());
}

TEST(KeepWorst, NoMoreThanTheGravest) {
  std::vector<SampleRecord> worst;
  for (uint32_t i = 0; i < 2 * kWorstSamples; ++i) {
    keep_worst(worst, {.x = i, .verdict = Verdict::kCandidateFault, .severity = static_cast<double>(i)});
  }
  keep_worst(worst, {.x = 1000, .verdict = Verdict::kReferenceFault, .severity = 1e9});
  ASSERT_EQ(worst.size(), kWorstSamples);
  EXPECT_EQ(worst.front().x, 2 * kWorstSamples - 1);
  EXPECT_EQ(worst.back().x, kWorstSamples);
}

TEST(UlpsBetween, InTheLastPlaceOfTheExactValue) {
  EXPECT_EQ(ulps_between(1, 1), 0);
  EXPECT_EQ(ulps_between(1 + 3 * 0x1p-23, 1), 3);
  EXPECT_EQ(ulps_between(-0.5 - 0x1p-24, -0.5), 1);
  EXPECT_EQ(ulps_between(0x1p-149, 0), 1);
  EXPECT_EQ(ulps_between(1, std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_TRUE(std::isnan(ulps_between(std::numeric_limits<double>::quiet_NaN(), 1)));
}

}  // namespace
}  // namespace fillrule::judge
