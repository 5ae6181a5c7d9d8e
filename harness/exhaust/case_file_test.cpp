#include "harness/exhaust/case_file.h"

#include <gtest/gtest.h>

#include "cases/format/reader.h"
#include "cases/format/writer.h"

namespace fillrule::exhaust {
namespace {

constexpr World kWorld{.grid = 2, .size = 3};

Difference tie() {
  Difference difference{.number = 77, .vertices = {0, 6, 45}, .tally = {.triangles = 1, .ties = 1}};
  difference.expected[0] = 1;
  difference.drawn[0] = 0x11;
  difference.drawn[5] = 2;
  return difference;
}

TEST(DifferenceText, ShowsVerticesMeaningAndBothMasks) {
  EXPECT_EQ(
      difference_text(kWorld, "renderer", tie()),
      "renderer draws triangle 77 otherwise, (0, 0) (3, 0) (1.5, 3) px: a tie, against the top-left rule alone\n"
      "  expected drawn\n"
      "  #..      F..\n"
      "  ...      ..?\n"
      "  ...      ...\n");
}

TEST(DifferenceCase, IsReadBackAsItWasWritten) {
  const Case made = difference_case(kWorld, "renderer", tie());
  EXPECT_EQ(made.name, "2x3-renderer-77");
  const format::CaseFile read = format::parse(format::write(made), "x.toml", "x");
  ASSERT_TRUE(read.errors.empty());
  ASSERT_EQ(read.cases.size(), 1U);
  ASSERT_EQ(read.cases.front().draws.size(), 1U);
  EXPECT_EQ(read.cases.front().draws[0].positions, made.draws[0].positions);
  EXPECT_EQ(read.cases.front().target.width, 4U);
  EXPECT_EQ(made.draws[0].positions[1], (ClipPosition{0.5F, -1.0F, 0.5F, 1.0F}));
}

}  // namespace
}  // namespace fillrule::exhaust
