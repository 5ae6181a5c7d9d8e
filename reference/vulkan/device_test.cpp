#include "reference/vulkan/device.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

#include "reference/vulkan/submission.h"
#include "reference/vulkan/test_support.h"

namespace fillrule::vulkan {
namespace {

using testing::AllOf;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

// An environment variable set for the time of a test.
class ScopedVariable {
 public:
  ScopedVariable(const char* name, const char* value) : name_(name) {
    if (const char* const before = std::getenv(name)) before_ = before;
    setenv(name, value, 1);
  }
  ~ScopedVariable() {
    if (before_) {
      setenv(name_, before_->c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }
  ScopedVariable(const ScopedVariable&) = delete;
  ScopedVariable(ScopedVariable&&) = delete;
  ScopedVariable& operator=(const ScopedVariable&) = delete;
  ScopedVariable& operator=(ScopedVariable&&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

TEST(Devices, WhatTheUserSaysOfOptimisationStays) {
  const auto after_call = [] {
    prefer_fast_compilation();
    return std::string(std::getenv("GALLIVM_PERF"));
  };
  const ScopedVariable set("GALLIVM_PERF", "");
  EXPECT_EQ(after_call(), "");
  unsetenv("GALLIVM_PERF");
  EXPECT_EQ(after_call(), "nopt");
}

TEST(Devices, ListsLavapipeWithItsLimits) {
  const auto devices = list_devices();
  ASSERT_TRUE(devices) << to_string(devices.error());
  const auto lavapipe = std::ranges::find(*devices, "lavapipe", &DeviceInfo::driver);
  ASSERT_NE(lavapipe, devices->end());
  EXPECT_EQ(lavapipe->driver_id, VK_DRIVER_ID_MESA_LLVMPIPE);
  EXPECT_THAT(lavapipe->driver_version, HasSubstr("Mesa"));
  EXPECT_GE(lavapipe->api_version, VK_API_VERSION_1_3);
  EXPECT_EQ(lavapipe->subpixel_bits, 8U);
  EXPECT_EQ(lavapipe->max_target_size, 16384U);
  EXPECT_TRUE(lavapipe->has_primitive_id);
  EXPECT_EQ(lavapipe->line_widths.max, 255.0F);
  EXPECT_EQ(lavapipe->point_sizes.max, 255.0F);
  EXPECT_EQ(lavapipe->point_sizes.step, 0.125F);
  EXPECT_EQ(to_string(FeatureSet::all().without(lavapipe->features)),
            "2 samples (samples), 8 samples (samples), 16 samples (samples), depth bounds (depth_bounds)");
}

TEST(Devices, KeepsMesaFromWritingACache) {
  ASSERT_TRUE(list_devices());
  EXPECT_STREQ(std::getenv("MESA_SHADER_CACHE_DISABLE"), "true");
}

// The names of this process's threads; Linux alone tells them.
std::vector<std::string> thread_names() {
  std::vector<std::string> names;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string name;
    std::getline(std::ifstream(task.path() / "comm"), name);
    names.push_back(name);
  }
  return names;
}

TEST(Devices, LavapipeHasNoRasterizerThreads) {
  Case drawn = empty_case(64);
  drawn.draws = {draw_of(drawn, {at(64, 0, 0), at(64, 64, 0), at(64, 0, 64)})};
  draw_one(drawn);
  EXPECT_THAT(thread_names(), Each(Not(StartsWith("llvmpipe")))) << "they damage the heap";
}

TEST(Devices, ListsNothingWithoutADriver) {
  const ScopedVariable no_drivers("VK_DRIVER_FILES", "/nonexistent/icd.json");
  const auto devices = list_devices();
  ASSERT_TRUE(devices) << to_string(devices.error());
  EXPECT_THAT(*devices, IsEmpty());

  const Result<Reference> reference = Reference::create({.program = varyings_program()});
  ASSERT_FALSE(reference);
  EXPECT_EQ(reference.error().what, "no Vulkan device of the driver 'lavapipe': no device at all was found");
}

TEST(Devices, AddsDriverFilesOnce) {
  const ScopedVariable added("VK_ADD_DRIVER_FILES", "/nonexistent/a.json");
  const std::vector<std::string> files = {"/nonexistent/b.json", "/nonexistent/a.json"};
  ASSERT_TRUE(list_devices(files));
  ASSERT_TRUE(list_devices(files));
  EXPECT_STREQ(std::getenv("VK_ADD_DRIVER_FILES"), "/nonexistent/a.json:/nonexistent/b.json");
}

TEST(Devices, NamesThoseFoundWhenTheWantedOneIsMissing) {
  const Result<Reference> reference = Reference::create({.driver = "voodoo", .program = varyings_program()});
  ASSERT_FALSE(reference);
  EXPECT_EQ(reference.error().what, "no Vulkan device of the driver 'voodoo'");
  EXPECT_THAT(reference.error().hint, AllOf(HasSubstr("the devices found are"), HasSubstr("'lavapipe' (llvmpipe")));
}

// Objects that a device still has when it is destroyed are what the validation layers would tell here.
TEST(Device, IsLeftWithNothingOfOurs) {
  const Result<Instance> instance = Instance::create({}, true);
  ASSERT_TRUE(instance) << to_string(instance.error());
  const auto physical = instance->physical_devices();
  ASSERT_TRUE(physical);
  const auto lavapipe =
      std::ranges::find_if(*physical, [](const PhysicalDevice& p) { return p.info.driver == "lavapipe"; });
  ASSERT_NE(lavapipe, physical->end());
  {
    const Result<Device> device = Device::create(*lavapipe);
    ASSERT_TRUE(device) << to_string(device.error());
    Result<PipelineCache> pipelines = PipelineCache::create(*device, varyings_program(), true, VK_NULL_HANDLE);
    ASSERT_TRUE(pipelines) << to_string(pipelines.error());
    Result<Submitter> submitter = Submitter::create(*device, *pipelines, 1);
    ASSERT_TRUE(submitter) << to_string(submitter.error());

    Case drawn = empty_case(16, {{.name = "v"}});
    drawn.draws = {draw_of(drawn, {at(16, 0, 0), at(16, 16, 0), at(16, 0, 16)}, {1, 2, 3})};
    std::vector<Result<Planes>> results(1);
    std::vector<CaseJob> jobs(1);
    jobs[0].drawn = &drawn;
    jobs[0].needs = *submitter->needs(drawn);
    submitter->draw(std::move(jobs), results);
    ASSERT_TRUE(results[0]) << to_string(results[0].error());
    EXPECT_EQ(results[0]->hits[0], 1U);
  }
  EXPECT_THAT(instance->log().messages(), IsEmpty());
}

TEST(Program, ReportsWhereItDoesNotCompile) {
  Options options{.program = varyings_program()};
  options.program.fragment_glsl = "#version 450\nvoid main() {\n  nonsense;\n}\n";
  const Result<Reference> reference = Reference::create(options);
  ASSERT_FALSE(reference);
  EXPECT_THAT(reference.error().what,
              AllOf(HasSubstr("the fragment shader does not compile"), HasSubstr("0:3: 'nonsense'")));
}

}  // namespace
}  // namespace fillrule::vulkan
