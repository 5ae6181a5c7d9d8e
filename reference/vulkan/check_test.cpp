#include "reference/vulkan/check.h"

#include <gmock/gmock.h>

#include <limits>

#include "reference/vulkan/test_support.h"

namespace fillrule::vulkan {
namespace {

using testing::StartsWith;

const DeviceInfo kDevice{
    .driver = "small", .max_target_size = 100, .max_viewport_size = {100, 50}, .viewport_bounds = {-200.0F, 199.0F}};

Case valid_case() {
  Case drawn = empty_case(16, {{.name = "a", .components = 2}});
  drawn.draws = {draw_of(drawn, {at(16, 0, 0), at(16, 8, 0), at(16, 0, 8)}, {1, 2, 3, 4, 5, 6})};
  return drawn;
}

std::string error_of(const Case& drawn) {
  const Result<void> checked = check_case(kDevice, drawn);
  return checked ? "no error" : checked.error().what;
}

// The error of a valid case whose first draw was changed.
template <typename Change>
std::string error_after(Change change) {
  Case drawn = valid_case();
  change(drawn, drawn.draws.front());
  return error_of(drawn);
}

TEST(CheckCase, TakesAValidCase) {
  EXPECT_EQ(error_of(valid_case()), "no error");
}

TEST(CheckCase, NamesWhatIsWrongWithTheTarget) {
  EXPECT_EQ(error_after([](Case& c, Draw&) { c.target.height = 0; }), "target.size: 16 x 0 pixels is empty");
  EXPECT_EQ(error_after([](Case& c, Draw&) { c.target.width = 101; }),
            "target.size: 101 x 16 pixels is beyond the 100 pixels that small can draw to");
  EXPECT_EQ(error_after([](Case& c, Draw&) { c.target.samples = VK_SAMPLE_COUNT_4_BIT; }),
            "target.samples: the Vulkan reference draws 1 sample per pixel, not 4");
  EXPECT_THAT(error_after([](Case& c, Draw&) { c.target.depth_format = VK_FORMAT_D16_UNORM; }),
              StartsWith("target.depth_format: "));
  EXPECT_EQ(error_after([](Case& c, Draw&) { c.target.clear_depth = 1.5F; }),
            "target.clear_depth: 1.5 is outside [0, 1]");
}

TEST(CheckCase, NamesWhatIsWrongWithTheViewport) {
  const auto with = [](auto change) { return error_after([&](Case&, Draw& draw) { change(draw.state.viewport); }); };
  EXPECT_EQ(with([](VkViewport& v) { v.width = 101; }),
            "viewport: 101 x 16 pixels; small takes a width above 0 and at most 100 x 50");
  EXPECT_THAT(with([](VkViewport& v) { v.width = 0; }), StartsWith("viewport: 0 x 16"));
  EXPECT_THAT(with([](VkViewport& v) { v.width = std::numeric_limits<float>::quiet_NaN(); }),
              StartsWith("viewport: nan x 16"));
  EXPECT_THAT(with([](VkViewport& v) { v.height = -51; }), StartsWith("viewport: 16 x -51"));
  EXPECT_EQ(with([](VkViewport& v) { v.height = -16; }), "no error");
  EXPECT_EQ(with([](VkViewport& v) { v.x = -201; }),
            "viewport: (-201, 0) to (-185, 16) is not within [-200, 199], the bounds of small");
  EXPECT_EQ(with([](VkViewport& v) { v.maxDepth = 1.25F; }),
            "viewport: the depth range 0 to 1.25 is not within [0, 1]");
}

TEST(CheckCase, NamesWhatIsWrongWithTheScissor) {
  const auto with = [](VkRect2D scissor) {
    return error_after([&](Case&, Draw& draw) { draw.state.scissor = scissor; });
  };
  EXPECT_THAT(with({.offset = {-1, 0}, .extent = {4, 4}}), StartsWith("scissor: 4 x 4 pixels at (-1, 0)"));
  EXPECT_THAT(with({.offset = {0, 1}, .extent = {4, 0x7FFFFFFF}}), StartsWith("scissor: "));
  EXPECT_EQ(with({.offset = {50, 50}, .extent = {0, 0}}), "no error");
}

TEST(CheckCase, NamesWhatIsWrongWithTheVertices) {
  EXPECT_EQ(error_after([](Case&, Draw& draw) {
              draw.indices = {0, 1, 3};
            }),
            "indices: 3 is beyond the last of 3 vertices");
  EXPECT_EQ(error_after([](Case&, Draw& draw) { draw.varyings.pop_back(); }),
            "vertices: 5 varying components for 3 vertices of 2 each");
  EXPECT_THAT(error_after([](Case&, Draw& draw) { draw.topology = VK_PRIMITIVE_TOPOLOGY_PATCH_LIST; }),
              StartsWith("topology: "));
  EXPECT_EQ(error_after([](Case& c, Draw&) { c.varyings.resize(9); }), "varyings: 9 are more than 8");
}

}  // namespace
}  // namespace fillrule::vulkan
