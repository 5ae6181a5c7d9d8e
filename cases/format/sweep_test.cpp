// Variables: [sweep], [let] and repeat.
#include "cases/format/sweep.h"

#include <gmock/gmock.h>

#include "cases/format/test_files.h"

namespace fillrule::format {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> names_of(const std::string& body) {
  std::vector<std::string> names;
  for (const Case& one : cases_of(body + kDraw)) names.push_back(one.name);
  return names;
}

// The x coordinates of a draw with this one expression.
std::vector<float> x_of(const std::string& body, const std::string& expression) {
  std::vector<float> x;
  const std::string draw = "[[draw]]\npositions = [['" + expression + "', 0, 0, 1]]\n";
  for (const Case& one : cases_of(body + draw)) {
    x.push_back(one.draws.at(0).positions.at(0)[0]);
  }
  return x;
}

TEST(Sweep, NamesHaveTheValuesAsWritten) {
  EXPECT_THAT(names_of("sweep.a = [0, 1.50, -0.0, 'pi/4', ' nan ', 0x10, 1e3]\n"),
              ElementsAre("a[a=0]", "a[a=1.50]", "a[a=-0.0]", "a[a=pi/4]", "a[a=nan]", "a[a=0x10]", "a[a=1e3]"));
}

TEST(Sweep, NamesAfterLettersBeyondAscii) {
  EXPECT_THAT(names_of("sweep = { \"\\u0061\" = ['0'], b = [1.5] }  # \xC3\xA4\n"), ElementsAre("a[a=0,b=1.5]"));
  EXPECT_THAT(names_of("tags = ['\xC3\xA4']\nsweep = { b = [\n  1.5, 2.50] } # \xC3\xA4\n"),
              ElementsAre("a[b=1.5]", "a[b=2.50]"));
}

TEST(Sweep, IsTheCrossProductInTheOrderOfTheFile) {
  EXPECT_THAT(names_of("[sweep]\nz = [1, 2]\na = ['none', 'back']\n"),
              ElementsAre("a[z=1,a=none]", "a[z=1,a=back]", "a[z=2,a=none]", "a[z=2,a=back]"));
  EXPECT_THAT(x_of("[sweep]\nz = [1, 2]\na = [10, 20, 30]\n", "z + a"), ElementsAre(11, 21, 31, 12, 22, 32));
}

TEST(Sweep, RangesIncludeTheirEnd) {
  EXPECT_THAT(names_of("sweep.a = { from = 0, to = 90, step = 45 }\n"), ElementsAre("a[a=0]", "a[a=45]", "a[a=90]"));
  EXPECT_THAT(names_of("sweep.a = { from = 0, to = 0.3, step = 0.1 }\n"),
              ElementsAre("a[a=0]", "a[a=0.1]", "a[a=0.2]", "a[a=0.3]"));
  EXPECT_THAT(names_of("sweep.a = { from = 1, to = -1, step = -1 }\n"), ElementsAre("a[a=1]", "a[a=0]", "a[a=-1]"));
  EXPECT_THAT(names_of("sweep.a = { from = 1, to = 2.5, step = '2/2' }\n"), ElementsAre("a[a=1]", "a[a=2]"));
  EXPECT_THAT(names_of("sweep.a = { from = 3, to = 3, step = 1 }\n"), ElementsAre("a[a=3]"));
}

TEST(Sweep, ManyCases) {
  EXPECT_EQ(names_of("[sweep]\na = { from = 1, to = 256, step = 1 }\nb = { from = 1, to = 256, step = 1 }\n").size(),
            kMaxCasesPerFile);
}

TEST(Sweep, TextVariablesStandWhereTextIsExpected) {
  const auto cases = cases_of(
      "[sweep]\ncull = ['none', 'back']\ntest = [false, true]\nspace = ['ndc']\nkind = ['flat']\n"
      "topology = ['triangle_strip']\n[state]\ncull_mode = '$cull'\ndepth_test = '$test'\n"
      "[varyings]\nv = '$kind'\n[[draw]]\nspace = '$space'\ntopology = '$topology'\npositions = [[0, 0]]\n"
      "varyings.v = [1]\n");
  ASSERT_EQ(cases.size(), 4U);
  EXPECT_EQ(cases[2].name, "a[cull=back,test=false,space=ndc,kind=flat,topology=triangle_strip]");
  EXPECT_EQ(cases[2].draws.at(0).state.cull_mode, VkCullModeFlags{VK_CULL_MODE_BACK_BIT});
  EXPECT_FALSE(cases[2].draws.at(0).state.depth_test);
  EXPECT_TRUE(cases[3].draws.at(0).state.depth_test);
  EXPECT_EQ(cases[0].draws.at(0).topology, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP);
  EXPECT_EQ(cases[0].varyings.at(0).interpolation, Interpolation::kFlat);
}

TEST(Sweep, AWordThatIsANumberIsANumber) {
  EXPECT_THAT(x_of("sweep.a = ['pi', 1]\n", "a > 3"), ElementsAre(1, 0));
}

TEST(Sweep, ValuesMayBeInfinite) {
  const auto cases = cases_of("sweep.a = [inf, '-inf']\n[[draw]]\npositions = [['a * 2', 0, 0, 1]]\n");
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_EQ(cases[1].draws.at(0).positions.at(0)[0], -std::numeric_limits<float>::infinity());
}

TEST(Sweep, ReachesEverySection) {
  const auto cases = cases_of(
      "sweep.a = [8, 16]\ntarget.size = ['a', 'a * 2']\nstate.viewport.x = 'a / 4'\nstate.scissor.y = 'a'\n"
      "[[draw]]\npositions = [[0, 0, 0, 1]]\nindices = ['a - a']\n");
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_EQ(cases[1].target.height, 32U);
  EXPECT_EQ(cases[1].draws.at(0).state.viewport.x, 4.0F);
  EXPECT_EQ(cases[1].draws.at(0).state.scissor.offset.y, 16);
}

TEST(Let, IsEvaluatedInTheOrderOfTheFileForEachCase) {
  EXPECT_THAT(x_of("[sweep]\nradius = [256, 512]\n[let]\nr = 'radius / 256'\nd = '2 * r'\none = 1\n", "d + one"),
              ElementsAre(3, 5));
}

TEST(Repeat, EmitsCopiesWithTheLastVariableFastest) {
  const Case one = case_of(
      "varyings.v = 'flat'\n[[draw]]\nrepeat = { j = 2, i = 'abs(-3)' }\npositions = [['j', 'i', 0, 1], [9, 9, 0, "
      "1]]\n"
      "indices = [1, 0]\nvaryings.v = ['10 * j + i', -1]\n");
  const Draw& draw = one.draws.at(0);
  ASSERT_EQ(draw.positions.size(), 12U);
  std::vector<float> x;
  for (size_t k = 0; k < 12; k += 2) x.push_back(10 * draw.positions[k][0] + draw.positions[k][1]);
  EXPECT_THAT(x, ElementsAre(0, 1, 2, 10, 11, 12));
  EXPECT_THAT(draw.varyings, ElementsAre(0, -1, 1, -1, 2, -1, 10, -1, 11, -1, 12, -1));
  EXPECT_EQ(draw.indices, (std::vector<uint32_t>{1, 0, 3, 2, 5, 4, 7, 6, 9, 8, 11, 10}));
}

TEST(Repeat, VariablesMayBeUsedAgainByAnotherDraw) {
  const Case one = case_of(
      "[[draw]]\nrepeat = { i = 2 }\npositions = [['i', 0, 0, 1]]\n"
      "[[draw]]\nrepeat = { i = 3 }\npositions = [['i', 0, 0, 1]]\n");
  EXPECT_EQ(one.draws.at(0).positions.size(), 2U);
  EXPECT_EQ(one.draws.at(1).positions.size(), 3U);
}

}  // namespace
}  // namespace fillrule::format
