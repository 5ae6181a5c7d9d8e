#include "harness/terminal/text.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "harness/report/printable.h"
#include "harness/terminal/golden.h"
#include "harness/terminal/map.h"
#include "harness/terminal/preview.h"
#include "harness/terminal/scene.h"
#include "harness/terminal/worst.h"

namespace fillrule::terminal {
namespace {

TEST(Terminal, AFailedCaseShowsCountsBoxFirstAndWorstSample) {
  judge::PlaneVerdict coverage{.name = "coverage", .kind = judge::PlaneKind::kCoverage};
  coverage.counts = {4096, 0, 0, 0, 0, 0};
  judge::PlaneVerdict owner{.name = "owner", .kind = judge::PlaneKind::kOwner};
  owner.counts = {4095, 0, 0, 0, 1, 0};
  owner.bounds = judge::Bounds{.min_x = 1, .min_y = 2, .max_x = 1, .max_y = 2};
  owner.first = judge::SampleRecord{.x = 1,
                                    .y = 2,
                                    .verdict = judge::Verdict::kCandidateFault,
                                    .candidate = 4294967295.0,
                                    .reference = 3,
                                    .expected = 3};
  owner.worst = owner.first;
  judge::PlaneVerdict uv{.name = "uv", .kind = judge::PlaneKind::kVarying, .components = 2};
  uv.counts = {4000, 90, 4, 1, 1, 0};
  uv.bounds = judge::Bounds{.min_x = 3, .min_y = 4, .max_x = 9, .max_y = 8};
  uv.first = judge::SampleRecord{.x = 3,
                                 .y = 4,
                                 .component = 1,
                                 .verdict = judge::Verdict::kCandidateFault,
                                 .candidate = 0.25,
                                 .reference = 0.5,
                                 .expected = 0.5,
                                 .tolerance = 1.5e-7};
  uv.worst = uv.first;
  uv.worst->x = 9;
  uv.worst->candidate = std::numeric_limits<double>::quiet_NaN();
  run::CaseResult result{.name = "clipping/near[angle=30]",
                         .status = run::Status::kFailed,
                         .show_command = "fillrule show 'clipping/near[angle=30]'",
                         .explain_command = "fillrule explain 'clipping/near[angle=30]' --pixel 9,4"};
  result.verdict.planes = {coverage, owner, uv};
  EXPECT_EQ(case_text(result, {}),
            "  FAILED  clipping/near[angle=30]\n"
            "    owner: 1 candidate fault, 4095 identical; within (1, 2) to (1, 2)\n"
            "      first (1, 2): candidate fault, candidate none, reference 3, exact 3\n"
            "    uv: 1 candidate fault, 1 reference fault, 4 imprecise, 90 permitted, 4000 identical; within (3, 4) "
            "to (9, 8)\n"
            "      first (3, 4) .y: candidate fault, candidate 0.25, reference 0.5, exact 0.5 +- 1.5e-07\n"
            "      worst (9, 4) .y: candidate fault, candidate nan, reference 0.5, exact 0.5 +- 1.5e-07\n"
            "    see it: fillrule show 'clipping/near[angle=30]'\n"
            "    explain it: fillrule explain 'clipping/near[angle=30]' --pixel 9,4\n");
}

TEST(Terminal, AFaultOfTheReferenceAloneCanBeSeenToo) {
  judge::PlaneVerdict depth{.name = "depth", .kind = judge::PlaneKind::kDepth};
  depth.counts = {4095, 0, 0, 1, 0, 0};
  run::CaseResult result{.name = "a/b", .show_command = "fillrule show 'a/b'"};
  result.verdict.planes = {depth};
  EXPECT_NE(case_text(result, {}).find("    see it: fillrule show 'a/b'\n"), std::string::npos);
  result.verdict.planes[0].counts = {4095, 1, 0, 0, 0, 0};
  EXPECT_EQ(case_text(result, {}).find("see it"), std::string::npos);
}

TEST(Terminal, ASkippedCaseGivesTheReason) {
  EXPECT_EQ(case_text({.name = "a/b", .status = run::Status::kSkipped, .message = "target.size: too large"}, {}),
            "  SKIPPED a/b\n    target.size: too large\n");
}

TEST(Terminal, TheSummaryNamesThePartiesAndCounts) {
  run::RunResult result{
      .candidate = "renderer",
      .candidate_subpixel_bits = 8,
      .reference = {.driver = "lavapipe", .name = "llvmpipe", .version = "Mesa 1", .subpixel_bits = 8},
      .summary = {.cases = 5,
                  .passed = 3,
                  .failed = 1,
                  .skipped = 1,
                  .identical = 100,
                  .permitted = 10,
                  .imprecise = 2,
                  .candidate_faults = 1,
                  .reference_faults = 4,
                  .wall_seconds = 0.5}};
  EXPECT_EQ(
      summary_text(result, {}),
      "candidate renderer (8 subpixel bits) against lavapipe (llvmpipe, Mesa 1, 8 subpixel bits) and the oracle\n"
      "5 cases: 3 passed, 1 failed, 1 skipped, in 0.50 s\n"
      "samples over all planes: 100 identical, 10 permitted, 2 imprecise, 1 candidate fault, 4 reference faults\n");
  result.reference = {.driver = "none"};
  EXPECT_EQ(summary_text(result, {}).substr(0, 61), "candidate renderer (8 subpixel bits) against the oracle alone");
}

TEST(Terminal, TheSummaryIsColouredByTheOutcomeAndKeepsToTheWidth) {
  run::RunResult result{.candidate = "renderer", .shard = {.index = 1, .total = 4, .suite_cases = 9}};
  result.summary = {.cases = 2, .passed = 1, .failed = 1};
  const std::string text = summary_text(result, {.colour = true, .columns = 30});
  EXPECT_NE(text.find("\x1b[1;31m2 cases: 1 passed, 1 failed, 0\n  skipped, in 0.00 s\x1b[0m\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("shard 2 of 4, of 9 cases\n"), std::string::npos) << text;
  result.summary = {.cases = 1, .passed = 1};
  EXPECT_NE(summary_text(result, {.colour = true}).find("\x1b[32m1 case: 1 passed"), std::string::npos);
}

TEST(Terminal, NewFaultsOfTheReferenceAndThoseThatAreGoneAreTold) {
  run::RunResult result;
  result.reference.driver = "lavapipe";
  result.reference.version = "Mesa 22.3.6";
  EXPECT_EQ(deviations_text(result, {}), "");
  EXPECT_EQ(deviations_text(result, {.unexpected = {{.case_name = "a/b", .plane = "depth", .samples = 3}},
                                     .known = {{.case_name = "a/c", .plane = "depth", .samples = 1}},
                                     .gone = {{.cases = {"a/*"}, .planes = {"owner", "hits"}}}}),
            "1 of its known deviations was met, listed in lavapipe-22.3.6.toml\n"
            "NEW fault of lavapipe: a/b, depth, 3 samples\n"
            "GONE from lavapipe: a/* (owner, hits) no longer occurs\n");
}

TEST(Terminal, TwoReferencesThatDisagreeAreToldApart) {
  judge::PlaneVerdict coverage{.name = "coverage", .kind = judge::PlaneKind::kCoverage};
  coverage.counts = {10, 4, 0, 2, 3, 1};
  run::CaseResult one{.name = "a/b"};
  one.verdict.planes = {coverage};
  run::RunResult result;
  result.candidate = "lavapipe";
  result.reference.driver = "swiftshader";
  result.cases.push_back(one);
  EXPECT_EQ(
      disagreements_text(result),
      "lavapipe and swiftshader draw differently, as permitted, 4 samples of coverage, hits, owner or facing in 1 "
      "case, and where one is wrong:\n"
      "  a/b, coverage: wrong at 3 samples lavapipe, at 2 swiftshader, at 1 both\n");
}

TEST(Terminal, AFailedCheckIsTold) {
  run::CaseResult result{.name = "a/b", .status = run::Status::kFailed};
  result.verdict.planes.emplace_back();
  result.show_command = "fillrule show 'a/b'";
  result.checks = {{.name = "second_run"},
                   {.name = "scissor_crop",
                    .outcome = judge::CheckResult::Outcome::kFailed,
                    .message = "depth differs at (1, 2)"}};
  EXPECT_EQ(case_text(result, {}),
            "  FAILED  a/b\n    check scissor_crop: depth differs at (1, 2)\n    see it: fillrule show 'a/b'\n");
}

// What the command line prints of a case at fault.
std::string whole_text(const Scene& scene, const Style& style) {
  return case_text(scene.result, style,
                   worst_text(scene.drawing.verdict, style) + map_text(scene.test_case, scene.drawing, style) +
                       preview_text(scene.test_case, scene.drawing, style));
}

Scene spoiled_scene() {
  Scene scene = draw_scene(16, [](Planes& candidate, Planes& reference) {
    for (uint32_t x = 4; x < 8; ++x) lose(candidate, x, 4);
    for (uint32_t x = 4; x < 8; ++x) candidate.varyings[1][16 * 5 + x] += 0.001F * static_cast<float>(x);
    candidate.varyings[2][16 * 6 + 4] = std::numeric_limits<float>::quiet_NaN();
    candidate.depth[16 * 6 + 5] = 0.5F;
    reference.owner[16 * 7 + 4] = 3;
  });
  scene.result.reason =
      "The candidate leaves out a sample 512 subpixels inside edge v0-v1 of primitive 0: candidate fault.";
  scene.result.checks = {{.name = "second_run"},
                         {.name = "scissor_crop",
                          .outcome = judge::CheckResult::Outcome::kFailed,
                          .message = "depth differs at (1, 2)"}};
  return scene;
}

TEST(TerminalGolden, AFailedCase) {
  expect_golden("failed_case.txt", whole_text(spoiled_scene(), {}));
}

TEST(TerminalGolden, AFailedCaseInColour) {
  expect_golden("failed_case_colour.txt", whole_text(spoiled_scene(), {.colour = true, .columns = 120}));
}

TEST(TerminalGolden, AFailedCaseOnANarrowTerminal) {
  const std::string text = whole_text(spoiled_scene(), {.columns = 50});
  expect_golden("failed_case_narrow.txt", text);
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    const bool command = line.find(" it: fillrule ") != std::string::npos;  // to be pasted, so it stays whole
    EXPECT_TRUE(command || report::columns_of(line) <= 50U) << line;
  }
}

TEST(TerminalGolden, AFaultOfTheReference) {
  const Scene scene = draw_scene(16, [](Planes&, Planes& reference) {
    reference.varyings[0][16 * 5 + 5] = std::numeric_limits<float>::infinity();
  });
  expect_golden("reference_fault.txt", whole_text(scene, {}));
}

TEST(TerminalGolden, HostileAndLongNames) {
  Scene scene = spoiled_scene();
  scene.result.name = "clipping/\x1b[2J\x1b]0;owned\x07<b>\"&'" + std::string(200, 'x') +
                      "\xe4\xb8\x89\xe8\xa7\x92\xff\n  PASSED  all";
  scene.result.message = "cannot be read: \x1b[31mred\x1b[0m\r\n";
  scene.result.verdict.planes[5].name = "u\x1b[1mv";
  scene.result.show_command.clear();
  scene.result.explain_command.clear();
  const std::string text = case_text(scene.result, {.columns = 80});
  expect_golden("hostile_names.txt", text);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_EQ(text.find('\r'), std::string::npos);
}

}  // namespace
}  // namespace fillrule::terminal
