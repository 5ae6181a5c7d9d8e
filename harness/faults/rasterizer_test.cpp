#include "harness/faults/rasterizer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "cases/format/reader.h"
#include "cases/format/suite.h"
#include "harness/judge/judge.h"
#include "harness/scene/build.h"

namespace fillrule::faults {
namespace {

using testing::ElementsAre;

Case parsed(const std::string& text) {
  const std::string head = "title = 't'\nwhy = 'w'\nspec = 's'\n[target]\nsize = [4, 2]\n";
  const format::CaseFile file = format::parse(head + text, "t.toml", "t");
  EXPECT_TRUE(file.errors.empty()) << to_string(file.errors.front());
  return file.cases.front();
}

const std::string kTwoColumns = R"(
[varyings]
x = "smooth"
[[draw]]
space = "framebuffer"
positions = [[0.5, 0], [2.5, 0], [2.5, 2], [0.5, 0], [2.5, 2], [0.5, 2]]
varyings.x = [0.5, 2.5, 2.5, 0.5, 2.5, 0.5]
)";

TEST(NaiveRasterizer, CoversEachSampleOfASquareOnceAndLeavesTheRightEdgeOut) {
  const Planes planes = draw_case(parsed(kTwoColumns), Fault::kNone, 8);
  EXPECT_THAT(planes.hits, ElementsAre(1, 1, 0, 0, 1, 1, 0, 0));
  EXPECT_THAT(planes.varyings[0], ElementsAre(0.5F, 1.5F, 0, 0, 0.5F, 1.5F, 0, 0));
}

TEST(NaiveRasterizer, MakesTheFaultThatItIsAskedFor) {
  const Case drawn = parsed(kTwoColumns);
  EXPECT_THAT(draw_case(drawn, Fault::kEdgesInclusive, 8).hits, ElementsAre(1, 1, 1, 0, 1, 1, 1, 0));
  EXPECT_THAT(draw_case(drawn, Fault::kBottomRightRule, 8).hits, ElementsAre(0, 1, 1, 0, 0, 1, 1, 0));
  EXPECT_THAT(draw_case(drawn, Fault::kFlatFromLastVertex, 8).varyings, draw_case(drawn, Fault::kNone, 8).varyings);
}

TEST(NaiveRasterizer, PassesTheWholeSuiteUnderEveryProfileOfTheOracle) {
  const format::Suite suite = scene::load_suite(FILLRULE_SOURCE_DIR "/cases", {});
  ASSERT_TRUE(suite.errors.empty());
  for (const Case& one : suite.cases) {
    const Planes planes = draw_case(one, Fault::kNone, 8);
    const judge::CaseVerdict verdict =
        judge::judge(one, {.planes = &planes, .subpixel_bits = 8}, nullptr,
                     {.profile = {.top_left = true, .diamond_exit = true, .precise = true}});
    EXPECT_EQ(verdict.candidate_faults(), 0U) << one.name;
  }
}

}  // namespace
}  // namespace fillrule::faults
