// Every case of the suite as a GoogleTest test of its own, named TOPIC.NAME[SWEEP], so that filters and sharding work
// on the suite. Our renderer is held to every profile, with the validation layers on.
#include <gtest/gtest.h>

#include <iostream>
#include <string>

#include "harness/run/suite_runner.h"
#include "harness/scene/build.h"
#include "harness/terminal/text.h"

namespace {

using fillrule::Case;

// Vulkan starts with the first test, so that listing the tests needs no device.
fillrule::Result<fillrule::run::SuiteRunner>& shared_runner() {
  static fillrule::Result<fillrule::run::SuiteRunner> runner = fillrule::run::SuiteRunner::create(
      {.profile = {.top_left = true, .diamond_exit = true, .precise = true, .same_bits = true}, .validation = true});
  return runner;
}

class ConformanceTest : public testing::Test {
 public:
  explicit ConformanceTest(const Case& test_case) : case_(test_case) {}

  void TestBody() override {
    auto& runner = shared_runner();
    ASSERT_TRUE(runner) << to_string(runner.error());
    const auto drawing = runner->draw(case_);
    ASSERT_TRUE(drawing) << to_string(drawing.error());
    EXPECT_EQ(drawing->verdict.candidate_faults(), 0U) << fillrule::terminal::case_text(
        {.name = case_.name, .status = fillrule::run::Status::kFailed, .verdict = drawing->verdict}, {});
    if (const auto& colors = drawing->scene_colors) {
      ASSERT_TRUE(*colors) << to_string(colors->error());
      EXPECT_EQ((*colors)->outcome, fillrule::judge::CheckResult::Outcome::kPassed) << (*colors)->message;
      EXPECT_EQ((*colors)->message, "") << "a fault of the reference";
    }
    const auto again = runner->draw(case_);
    ASSERT_TRUE(again) << to_string(again.error());
    // A case that the device cannot draw has been held against the oracle alone.
    ASSERT_EQ(drawing->reference.has_value(), again->reference.has_value());
    if (drawing->reference) {
      EXPECT_EQ(fillrule::judge::differing_bytes(*drawing->reference, *again->reference), "")
          << "the reference, twice";
    }
    EXPECT_TRUE(runner->validation_messages().empty()) << runner->validation_messages().back();
  }

 private:
  const Case& case_;
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const fillrule::format::Suite suite = fillrule::scene::load_suite(FILLRULE_SOURCE_DIR "/cases", {});
  for (const fillrule::Error& error : suite.errors) std::cerr << to_string(error) << '\n';
  if (!suite.errors.empty() || suite.cases.empty()) return 2;
  for (const Case& one : suite.cases) {
    const size_t slash = one.name.find('/');
    const std::string topic = one.name.substr(0, slash);
    testing::RegisterTest(topic.c_str(), one.name.substr(slash + 1).c_str(), nullptr, nullptr, one.file.c_str(), 1,
                          [&one]() -> testing::Test* { return new ConformanceTest(one); });
  }
  return RUN_ALL_TESTS();
}
