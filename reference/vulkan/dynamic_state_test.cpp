#include "reference/vulkan/dynamic_state.h"

#include <gtest/gtest.h>

#include <optional>

#include "reference/vulkan/pipeline.h"
#include "reference/vulkan/test_support.h"

namespace fillrule::vulkan {
namespace {

// Lavapipe has all of the states.
class DynamicStates : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(instance_) << to_string(instance_.error());
    const auto physical = instance_->choose_device("lavapipe");
    ASSERT_TRUE(physical) << to_string(physical.error());
    device_.emplace(*Device::create(*physical));
    ASSERT_TRUE(device_->has_dynamic_state());
    pipelines_.emplace(*PipelineCache::create(*device_, varyings_program(), true, VK_NULL_HANDLE));
  }

  [[nodiscard]] VkPipeline pipeline(const PipelineKey& key) { return *pipelines_->find_or_create(key); }

  Result<Instance> instance_ = Instance::create({}, false);
  std::optional<Device> device_;
  std::optional<PipelineCache> pipelines_;
};

TEST_F(DynamicStates, DrawsThatSetThemDifferentlyShareAPipeline) {
  const PipelineKey lines{.topology_class = VK_PRIMITIVE_TOPOLOGY_LINE_LIST,
                          .line_mode = VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT,
                          .provoking_vertex = VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT,
                          .depth_clamp = true,
                          .depth_clip = false,
                          .negative_one_to_one = true,
                          .sample_mask = 0};
  EXPECT_EQ(pipeline(lines), pipeline({}));
  EXPECT_EQ(pipeline({.polygon_mode = VK_POLYGON_MODE_POINT}), pipeline({}));
  EXPECT_EQ(pipeline({.topology_class = VK_PRIMITIVE_TOPOLOGY_POINT_LIST}), pipeline({}));
}

TEST_F(DynamicStates, WhatTheShadersOrTheTargetDifferInStaysApart) {
  EXPECT_NE(pipeline({.clip_distances = 1}), pipeline({}));
  EXPECT_NE(pipeline({.depth_format = VK_FORMAT_D16_UNORM}), pipeline({}));
  EXPECT_NE(pipeline({.samples = VK_SAMPLE_COUNT_4_BIT}), pipeline({}));
}

TEST(DynamicState, WithoutItEveryStateStaysInThePipeline) {
  const PipelineKey key{.polygon_mode = VK_POLYGON_MODE_LINE, .depth_clamp = true};
  EXPECT_EQ(DynamicState().without(key), key);
  EXPECT_TRUE(DynamicState().states().empty());
}

}  // namespace
}  // namespace fillrule::vulkan
