// The control of a case and what the case shows beside it, as the file says and as the reader works it out.
#include "cases/format/siblings.h"

#include "cases/format/test_files.h"
#include "cases/format/writer.h"

namespace fillrule::format {
namespace {

const std::string kSweep = "[sweep]\nsize = [1, 1e3]\ncull = ['none', 'back']\n";

TEST(Siblings, ControlIsAValueOfTheSweep) {
  const std::vector<Case> cases = cases_of("control = { size = 1 }\n" + kSweep + kDraw);
  ASSERT_EQ(cases.size(), 4U);
  EXPECT_EQ(cases[0].control, "");
  EXPECT_EQ(cases[1].control, "");
  EXPECT_EQ(cases[2].control, "a[size=1,cull=none]");
  EXPECT_EQ(cases[3].control, "a[size=1,cull=back]");
}

TEST(Siblings, ControlIsOneCombination) {
  const std::vector<Case> cases = cases_of("control = { cull = 'back', size = 1000 }\n" + kSweep + kDraw);
  ASSERT_EQ(cases.size(), 4U);
  EXPECT_EQ(cases[0].control, "a[size=1e3,cull=back]");
  EXPECT_EQ(cases[3].control, "");
}

TEST(Siblings, ControlIsAnotherCase) {
  EXPECT_EQ(case_of("control = 'coverage/other[size=1]'\n" + kDraw).control, "coverage/other[size=1]");
  EXPECT_EQ(case_of(kDraw).control, "");
}

TEST(Siblings, ZerosOfEitherSignAreToldApart) {
  const std::vector<Case> cases = cases_of("control = { w = -0.0 }\n[sweep]\nw = [0, -0.0]\n" + kDraw);
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_EQ(cases[0].control, "a[w=-0.0]");
}

TEST(Siblings, EffectOfAllButTheControl) {
  const std::vector<Case> cases = cases_of("control = { cull = 'none' }\nexpect = 'nothing'\n" + kSweep + kDraw);
  ASSERT_EQ(cases.size(), 4U);
  EXPECT_EQ(cases[0].effect, Effect::kDifferent);
  EXPECT_EQ(cases[1].effect, Effect::kNothing);
}

TEST(Siblings, EffectOfSomeCases) {
  const std::vector<Case> cases = cases_of(
      "expect = { nothing = [{ size = 1e3, cull = 'back' }], same = [{ cull = 'back' }] }\n" + kSweep + kDraw);
  ASSERT_EQ(cases.size(), 4U);
  EXPECT_EQ(cases[0].effect, Effect::kDifferent);
  EXPECT_EQ(cases[1].effect, Effect::kSame);
  EXPECT_EQ(cases[2].effect, Effect::kDifferent);
  EXPECT_EQ(cases[3].effect, Effect::kNothing);
}

TEST(Siblings, AreWrittenAndReadBack) {
  for (const Case& one :
       cases_of("control = { size = 1 }\nexpect = { same = [{ cull = 'back' }] }\n" + kSweep + kDraw)) {
    const CaseFile again = parse(write(one), "a.toml", one.name);
    ASSERT_EQ(again.cases.size(), 1U);
    EXPECT_EQ(again.cases[0].control, one.control);
    EXPECT_EQ(again.cases[0].effect, one.effect);
  }
}

TEST(BadSiblings, Control) {
  EXPECT_EQ(errors_with_draw("control = { sise = 1 }\n" + kSweep),
            "a.toml:4:13: control: the sweep has no variable \"sise\"\n  hint: did you mean \"size\"?\n");
  EXPECT_EQ(errors_with_draw("control = { size = 7 }\n" + kSweep),
            "a.toml:4:20: the sweep's size has no value 7\n  hint: its values are: 1, 1e3\n");
  EXPECT_EQ(errors_with_draw("control = {}\n" + kSweep), "a.toml:4:11: control names no variable of the sweep\n");
  EXPECT_EQ(errors_with_draw("control = ' '\n"),
            "a.toml:4:11: control is empty\n  hint: name another case, control = \"topic/name\", or a value of the "
            "sweep, control = { size = 1 }\n");
  EXPECT_EQ(
      errors_with_draw("control = 3\n"),
      "a.toml:4:11: control must be a case's name or a table, not an integer\n  hint: name another case, control "
      "= \"topic/name\", or a value of the sweep, control = { size = 1 }\n");
}

TEST(BadSiblings, Expect) {
  EXPECT_EQ(errors_with_draw("expect = 'noting'\n"),
            "a.toml:4:10: expect knows no \"noting\"\n  hint: did you mean \"nothing\"?\n");
  EXPECT_EQ(errors_with_draw("expect = 1\n"),
            "a.toml:4:10: expect must be a word or a table, not an integer\n  hint: for example \"nothing\" or { "
            "nothing = [{ size = 0 }] }\n");
  EXPECT_EQ(errors_with_draw("expect = { some = [] }\n"),
            "a.toml:4:12: unknown key \"some\" in expect\n  hint: did you mean \"same\"?\n");
  EXPECT_EQ(errors_with_draw("expect = { same = true }\n"),
            "a.toml:4:19: same must be an array of tables, not a boolean\n");
  EXPECT_EQ(errors_with_draw("expect = { nothing = [{ size = 2 }] }\n" + kSweep),
            "a.toml:4:32: the sweep's size has no value 2\n  hint: its values are: 1, 1e3\n");
}

}  // namespace
}  // namespace fillrule::format
