#include "harness/run/lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace fillrule::run {
namespace {

// Cases of eleven kinds of varyings, mixed.
std::vector<Case> mixed_cases() {
  std::vector<Case> cases(500);
  for (size_t i = 0; i < cases.size(); ++i) {
    for (size_t v = 0; v < i * i % 11; ++v) {
      cases[i].varyings.push_back({.name = "v", .components = 4, .interpolation = Interpolation::kSmooth});
    }
  }
  return cases;
}

// What each of two devices takes, which ask in turn.
std::array<std::vector<size_t>, 2> shared_out(const std::vector<Case>& cases, DeviceOfSlots& device_of) {
  std::array<std::vector<size_t>, 2> taken;
  Lanes lanes(cases, device_of);
  for (bool is_left = true; is_left;) {
    is_left = false;
    for (size_t device = 0; device < taken.size(); ++device) {
      const std::vector<size_t> batch = lanes.next(device, 8);
      EXPECT_LE(batch.size(), 8U);
      taken[device].insert(taken[device].end(), batch.begin(), batch.end());
      is_left = is_left || !batch.empty();
    }
  }
  return taken;
}

TEST(Lanes, HandOutEachCaseOnceAndShadersToOneDevice) {
  const std::vector<Case> cases = mixed_cases();
  DeviceOfSlots device_of;
  const auto taken = shared_out(cases, device_of);
  std::vector<size_t> times(cases.size());
  for (size_t device = 0; device < taken.size(); ++device) {
    for (const size_t number : taken[device]) {
      ++times[number];
      EXPECT_EQ(device_of.at(vulkan::pack(cases[number].varyings).counts), device);
    }
  }
  EXPECT_EQ(std::ranges::count(times, 1U), std::ssize(cases));
  for (const std::vector<size_t>& numbers : taken) EXPECT_GT(numbers.size(), cases.size() / 4);
}

TEST(Lanes, ADeviceKeepsItsShadersFromRunToRun) {
  const std::vector<Case> cases = mixed_cases();
  DeviceOfSlots device_of;
  EXPECT_EQ(shared_out(cases, device_of), shared_out(cases, device_of));
}

TEST(Lanes, ADeviceThatIsLeftWithNothingTakesWhatIsNobodys) {
  const std::vector<Case> cases = mixed_cases();
  DeviceOfSlots device_of;
  Lanes lanes(cases, device_of);
  EXPECT_FALSE(lanes.next(0, 1).empty());
  const size_t of_first = lanes.next(0, cases.size()).size();
  EXPECT_EQ(of_first, cases.size() - 1) << "the second one has not asked";
  EXPECT_TRUE(lanes.next(1, 1).empty());
}

TEST(Lanes, TellWhichDeviceIsBehind) {
  const std::vector<Case> cases = mixed_cases();
  DeviceOfSlots device_of;
  const auto taken = shared_out(cases, device_of);
  ASSERT_NE(taken[0].size(), taken[1].size());
  const size_t larger = taken[0].size() > taken[1].size() ? 0 : 1;
  const size_t more = taken[larger].size() - taken[1 - larger].size();
  // Now that they have their own, from the beginning.
  Lanes lanes(cases, device_of);
  EXPECT_TRUE(lanes.is_behind(larger, more - 1));
  EXPECT_FALSE(lanes.is_behind(larger, more));
  EXPECT_FALSE(lanes.is_behind(1 - larger, 0));
  EXPECT_EQ(lanes.next(larger, more + 1).size(), more + 1);
  EXPECT_FALSE(lanes.is_behind(larger, 0));
  EXPECT_TRUE(lanes.is_behind(1 - larger, 0));
  // Of what is nobody's nothing is left for anyone.
  DeviceOfSlots none;
  Lanes fresh(cases, none);
  EXPECT_FALSE(fresh.is_behind(0, 0));
  EXPECT_EQ(fresh.next(0, 1).size(), 1U);
  EXPECT_TRUE(fresh.is_behind(0, 0));
  EXPECT_FALSE(fresh.is_behind(1, 0));
}

}  // namespace
}  // namespace fillrule::run
