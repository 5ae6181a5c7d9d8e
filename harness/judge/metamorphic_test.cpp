// Each check passes on the renderer, and fails on a renderer spoiled in just the way that the check is for.
#include "harness/judge/metamorphic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "harness/judge/variants.h"
#include "harness/programs/varyings.h"

namespace fillrule::judge {
namespace {

using Outcome = CheckResult::Outcome;

ClipPosition at(double x, double y, double z) {
  return {static_cast<float>(x / 16 - 1), static_cast<float>(y / 16 - 1), static_cast<float>(z), 1};
}

// A strip of three triangles that overlaps a fan of two, with depth test and back faces culled.
Case layered() {
  Case result{.name = "layered",
              .target = {.width = 32, .height = 32},
              .varyings = {{.name = "smooth", .interpolation = Interpolation::kSmooth},
                           {.name = "flat", .interpolation = Interpolation::kFlat}}};
  Draw strip{.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP,
             .positions = {at(2, 2, 0.5), at(3, 20, 0.2), at(15, 3, 0.7), at(17, 22, 0.4), at(29, 5, 0.3)}};
  strip.state.viewport = {.x = 0, .y = 0, .width = 32, .height = 32, .minDepth = 0, .maxDepth = 1};
  strip.state.scissor = {.offset = {.x = 1, .y = 3}, .extent = {.width = 30, .height = 28}};
  strip.state.cull_mode = VK_CULL_MODE_BACK_BIT;
  strip.state.depth_test = true;
  Draw fan = strip;
  fan.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN;
  fan.positions = {at(8, 8, 0.1), at(9, 30, 0.9), at(30, 28, 0.4), at(28, 2, 0.2)};
  fan.indices = {0, 1, 2, 3};
  for (Draw* draw : {&strip, &fan}) {
    for (size_t i = 0; i < draw->positions.size(); ++i) {
      const auto number = static_cast<float>(i);
      draw->varyings.insert(draw->varyings.end(), {number / 3, 10 + number});
    }
    result.draws.push_back(*draw);
  }
  return result;
}

Result<Planes> draw_rightly(const Case& test_case, uint32_t threads) {
  return programs::draw_case(test_case, {.threads = std::max(threads, 1U)});
}

std::map<std::string, CheckResult> checks_of(
    const Case& test_case, const std::function<Result<Planes>(const Case&, uint32_t)>& draw = draw_rightly) {
  const Result<Planes> original = draw_rightly(test_case, 0);
  EXPECT_TRUE(original);
  std::map<std::string, CheckResult> results;
  for (CheckResult& check :
       metamorphic_checks(test_case, {.draw = draw, .features = programs::renderer_features()}, *original)) {
    results[check.name] = std::move(check);
  }
  EXPECT_EQ(results.size(), kChecks.size());
  return results;
}

void expect_failed(const std::map<std::string, CheckResult>& results, const std::string& name) {
  EXPECT_EQ(results.at(name).outcome, Outcome::kFailed) << name;
  EXPECT_NE(results.at(name).message, "") << name;
}

TEST(Metamorphic, TheRendererPassesAll) {
  for (const auto& [name, check] : checks_of(layered())) {
    EXPECT_EQ(check.outcome, Outcome::kPassed) << name << ": " << check.message;
  }
}

TEST(Metamorphic, ASecondRunThatDiffersIsFound) {
  const auto results = checks_of(layered(), [](const Case& test_case, uint32_t threads) {
    Result<Planes> planes = draw_rightly(test_case, threads);
    for (auto& varying : planes->varyings) varying[200] = std::nextafter(varying[200], 20.0F);
    return planes;
  });
  expect_failed(results, "second_run");
  EXPECT_EQ(results.at("second_run").message,
            "varying component 0 differs at (8, 6), in a second drawing of the same case");
}

TEST(Metamorphic, AnOrderLostBetweenThreadsIsFound) {
  const auto results = checks_of(layered(), [](const Case& test_case, uint32_t threads) {
    Result<Planes> planes = draw_rightly(test_case, threads);
    if (threads > 2) planes->owner[200] = 1;
    return planes;
  });
  expect_failed(results, "any_number_of_threads");
  EXPECT_EQ(results.at("second_run").outcome, Outcome::kPassed);
}

TEST(Metamorphic, CoverageThatDependsOnTheFirstVertexIsFound) {
  const auto results = checks_of(layered(), [](const Case& test_case, uint32_t threads) {
    Result<Planes> planes = draw_rightly(test_case, threads);
    if (test_case.draws[0].positions[0] == layered().draws[0].positions[1]) planes->hits[200] = 0;
    return planes;
  });
  expect_failed(results, "rotated_vertices");
}

TEST(Metamorphic, CullingThatForgetsTheFrontFaceIsFound) {
  const auto results = checks_of(layered(), [](const Case& test_case, uint32_t threads) {
    Case clockwise = test_case;
    for (Draw& draw : clockwise.draws) draw.state.front_face = VK_FRONT_FACE_COUNTER_CLOCKWISE;
    return draw_rightly(clockwise, threads);
  });
  expect_failed(results, "flipped_winding");
  EXPECT_EQ(results.at("rotated_vertices").outcome, Outcome::kPassed);
}

TEST(Metamorphic, AnAbsoluteEpsilonInClipSpaceIsFound) {
  const auto results = checks_of(layered(), [](const Case& test_case, uint32_t threads) {
    Case shifted = test_case;
    for (Draw& draw : shifted.draws) {
      for (ClipPosition& position : draw.positions) {
        if (position[3] > 1) position[0] += 8;
      }
    }
    return draw_rightly(shifted, threads);
  });
  expect_failed(results, "scaled_clip_space");
}

TEST(Metamorphic, ScalingThatOnlyMovesWhatIsLeftOpenIsNoFault) {
  Case tie = layered();
  tie.draws.resize(1);
  tie.draws[0].positions = {at(2.5, 2.5, 0.5), at(2.5, 20.5, 0.5), at(15.5, 2.5, 0.5)};
  tie.draws[0].varyings.resize(6);
  tie.draws[0].topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  const auto results = checks_of(tie, [](const Case& test_case, uint32_t threads) {
    Result<Planes> planes = draw_rightly(test_case, threads);
    if (test_case.draws[0].positions[0][3] > 1) {
      const size_t on_the_left_edge = 10 * 32 + 2;
      planes->hits[on_the_left_edge] = 0;
      planes->owner[on_the_left_edge] = kNoOwner;
      planes->front_facing[on_the_left_edge] = 0;
      planes->depth[on_the_left_edge] = 1;
      for (auto& varying : planes->varyings) varying[on_the_left_edge] = 0;
    }
    return planes;
  });
  EXPECT_EQ(results.at("scaled_clip_space").outcome, Outcome::kPassed) << results.at("scaled_clip_space").message;
}

TEST(Metamorphic, AScissorThatChangesWhatIsInsideOrLeavesATraceOutsideIsFound) {
  const VkRect2D original = layered().draws[0].state.scissor;
  for (const size_t spoiled : {size_t{10 * 32 + 12}, size_t{3 * 32 + 5}}) {
    const auto results = checks_of(layered(), [&](const Case& test_case, uint32_t threads) {
      Result<Planes> planes = draw_rightly(test_case, threads);
      if (test_case.draws[0].state.scissor.extent.width != original.extent.width) planes->depth[spoiled] = 0.123F;
      return planes;
    });
    expect_failed(results, "scissor_crop");
  }
}

TEST(Metamorphic, ACaseOptsOutByName) {
  Case opted_out = layered();
  opted_out.opt_outs = {{.check = "scissor_crop", .reason = "because"}};
  const auto results = checks_of(opted_out);
  EXPECT_EQ(results.at("scissor_crop").outcome, Outcome::kOptedOut);
  EXPECT_EQ(results.at("scissor_crop").message, "because");
}

TEST(Metamorphic, ACandidateThatCannotDrawAVariantFails) {
  const auto results = checks_of(layered(), [](const Case&, uint32_t) -> Result<Planes> { return failure("no"); });
  expect_failed(results, "second_run");
}

TEST(Metamorphic, ScalingIsNotAskedWhereFragCoordIsRead) {
  Case test_case = layered();
  test_case.varyings.push_back({.name = "coord", .components = 4, .source = VaryingSource::kFragCoord});
  const Planes nothing = Planes::cleared(32, 32, 1, component_count(test_case.varyings), 1);
  const auto draw = [&](const Case&, uint32_t) { return Result<Planes>(nothing); };
  for (const CheckResult& check : metamorphic_checks(test_case, {.draw = draw}, nothing)) {
    if (check.name == "scaled_clip_space") {
      EXPECT_EQ(check.outcome, Outcome::kDoesNotFit);
    }
  }
}

TEST(Variants, AListHasAllThatItsVerticesHad) {
  Case test_case{.varyings = {{.name = "coord", .components = 4, .source = VaryingSource::kFragCoord},
                              {.name = "flat", .interpolation = Interpolation::kFlat},
                              {.name = "smooth", .components = 2}}};
  test_case.draws.push_back({.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST,
                             .positions = {at(0, 0, 0), at(1, 0, 0), at(0, 1, 0)},
                             .varyings = {10, 1, 2, 11, 3, 4, 12, 5, 6},
                             .clip_distance_count = 2,
                             .cull_distance_count = 1,
                             .clip_distances = {0, 1, 2, 3, 4, 5},
                             .cull_distances = {6, 7, 8}});
  const Case variant = as_triangle_list(test_case, {1, 2, 0});
  const Draw& list = variant.draws.at(0);
  EXPECT_EQ(list.varyings, (std::vector<float>{10, 3, 4, 10, 5, 6, 10, 1, 2}));
  EXPECT_EQ(list.clip_distance_count, 2U);
  EXPECT_EQ(list.clip_distances, (std::vector<float>{2, 3, 4, 5, 0, 1}));
  EXPECT_EQ(list.cull_distance_count, 1U);
  EXPECT_EQ(list.cull_distances, (std::vector<float>{7, 8, 6}));
}

TEST(Variants, ScalingIsLeftAloneWhereItWouldRound) {
  Case tiny = layered();
  tiny.draws[0].positions[0][0] = 1e-40F;
  const Case before = tiny;
  EXPECT_FALSE(scale_clip_space(tiny, 6));
  EXPECT_EQ(tiny.draws[0].positions, before.draws[0].positions);
}

TEST(Variants, LeaveLinesAndOutlinesAsTheyAre) {
  Case lines = layered();
  lines.draws[0].topology = VK_PRIMITIVE_TOPOLOGY_LINE_STRIP;
  lines.draws[1].state.polygon_mode = VK_POLYGON_MODE_LINE;
  const Case varied = with_front_faces_flipped(as_triangle_list(lines, {0, 2, 1}));
  for (size_t i = 0; i < lines.draws.size(); ++i) {
    EXPECT_EQ(varied.draws[i].topology, lines.draws[i].topology);
    EXPECT_EQ(varied.draws[i].positions, lines.draws[i].positions);
    EXPECT_EQ(varied.draws[i].state.front_face, lines.draws[i].state.front_face);
  }
}

TEST(Metamorphic, AUserClipPlaneThatCutsNothingAddsUpToMoreThanTheWhole) {
  const auto ignores_planes = [](const Case& test_case, uint32_t threads) {
    Case uncut = test_case;
    for (Draw& draw : uncut.draws) {
      draw.clip_distance_count = 0;
      draw.clip_distances.clear();
    }
    return draw_rightly(uncut, threads);
  };
  const auto results = checks_of(layered(), ignores_planes);
  expect_failed(results, "partition");
  EXPECT_NE(results.at("partition").message.find("the sum of hits"), std::string::npos)
      << results.at("partition").message;
}

}  // namespace
}  // namespace fillrule::judge
