#include "harness/run/under_way.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "harness/run/suite_runner.h"

namespace fillrule::run {
namespace {

std::vector<std::string> under_way() {
  std::vector<std::string> lines;
  for (size_t slot = 0; slot < UnderWay::kMost; ++slot) {
    const UnderWay* const work = UnderWay::in_slot(slot);
    if (work == nullptr) continue;
    std::string line = std::string(work->what()) + ' ' + std::string(work->party()) + ':';
    for (const Case* const one : work->cases()) line += ' ' + one->name;
    lines.push_back(line);
  }
  return lines;
}

Case named(const std::string& name) {
  Case one;
  one.name = name;
  return one;
}

TEST(UnderWay, IsToldWhileItLives) {
  const Case a = named("a");
  const Case b = named("b");
  const std::vector<const Case*> both{&a, &b};
  EXPECT_TRUE(under_way().empty());
  {
    const UnderWay outer("drawn by", "lavapipe", both);
    {
      const UnderWay inner("judged with", "renderer", std::span(both).last(1));
      EXPECT_EQ(under_way(), (std::vector<std::string>{"drawn by lavapipe: a b", "judged with renderer: b"}));
    }
    EXPECT_EQ(under_way(), std::vector<std::string>{"drawn by lavapipe: a b"});
  }
  EXPECT_TRUE(under_way().empty());
}

TEST(UnderWay, LeavesOutWhatHasNoRoom) {
  const Case a = named("a");
  const Case* const one = &a;
  std::vector<std::unique_ptr<UnderWay>> all;
  for (size_t i = 0; i < UnderWay::kMost + 2; ++i) {
    all.push_back(std::make_unique<UnderWay>("drawn by", "lavapipe", std::span(&one, 1)));
  }
  EXPECT_EQ(under_way().size(), UnderWay::kMost);
  all.clear();
  EXPECT_TRUE(under_way().empty());
}

// The candidate looks around while it draws.
TEST(UnderWay, HasTheCaseThatTheCandidateDraws) {
  std::vector<std::string> seen;
  Candidate candidate{.name = "onlooker", .check = [](const Case&) { return Result<void>(); }};
  candidate.draw = [&](const Case&, uint32_t) -> Result<Planes> {
    seen = under_way();
    return failure("it only looks");
  };
  auto runner = SuiteRunner::create({.reference = kNoReference}, candidate);
  ASSERT_TRUE(runner);
  const std::vector<Case> cases{named("x/y")};
  runner->run(cases);
  EXPECT_EQ(seen, std::vector<std::string>{"drawn or judged for the candidate onlooker: x/y"});
  EXPECT_TRUE(under_way().empty());
}

}  // namespace
}  // namespace fillrule::run
