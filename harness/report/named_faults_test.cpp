// Faults of every part of the pipeline, put into the naive rasterizer: the first sentence that the report opens with
// names the class of error.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cases/format/suite.h"
#include "harness/report/html_case.h"

namespace fillrule::report {
namespace {

struct NamedFault {
  const char* fault;
  const char* cases;
  const char* words;
};

class NamedFaults : public testing::TestWithParam<NamedFault> {};

TEST_P(NamedFaults, AreNamedByTheFirstSentence) {
  const auto& [fault, selector, words] = GetParam();
  const std::string name = selector;
  const format::Suite suite = format::load_suite(FILLRULE_SOURCE_DIR "/cases", {&name, 1});
  auto runner = run::SuiteRunner::create(
      {.candidate = std::string("faults:") + fault, .reference = run::kNoReference, .checks = false});
  ASSERT_TRUE(runner);
  const run::RunResult result = runner->run(suite.cases);
  const auto failed = std::ranges::find(result.cases, run::Status::kFailed, &run::CaseResult::status);
  ASSERT_NE(failed, result.cases.end());
  const Case& first = suite.cases[static_cast<size_t>(failed - result.cases.begin())];
  const Result<run::Drawing> drawing = runner->draw(first);
  ASSERT_TRUE(drawing);
  const HtmlCase page = html_case(first, *failed, *drawing, {.candidate = result.candidate});
  EXPECT_THAT(page.diagnosis.sentence, testing::HasSubstr(words)) << first.name;
}

// The case files are those in which a run of the whole suite finds the faults first.
constexpr std::array kFaults{
    NamedFault{"fan_provokes_hub", "assembly/fan_winding", "that of the third vertex (flat)"},
    NamedFault{"no_near_clip", "builtins/frag_coord_clipped", "beyond the near plane"},
    NamedFault{"drop_if_any_behind_eye", "clipping/cube_from_inside",
               "lost as a whole, as by culling, clipping or a limit"},
    NamedFault{"negative_height_ignored", "builtins/frag_coord_in_a_viewport", "upside down"},
    NamedFault{"snap_by_truncation", "coverage/edge_past_tile_corner", "points to snapping"},
    NamedFault{"samples_on_regular_grid", "builtins/frag_coord_at_samples", "the place of the samples"},
    NamedFault{"point_size_rounded", "builtins/point_coord", "the size of the points"},
    NamedFault{"perspective_depth", "builtins/frag_coord", "perspective correction, which depth never is"},
    NamedFault{"depth_compare_off_by_equal", "depth/clamp_and_test", "fail the depth test"},
    NamedFault{"bias_slope_missing", "builtins/frag_coord_with_bias", "depth bias"},
    NamedFault{"affine_varyings", "builtins/frag_coord_at_samples", "without perspective correction (affine)"}};

INSTANTIATE_TEST_SUITE_P(OfEveryPart, NamedFaults, testing::ValuesIn(kFaults),
                         [](const testing::TestParamInfo<NamedFault>& named) { return named.param.fault; });

}  // namespace
}  // namespace fillrule::report
