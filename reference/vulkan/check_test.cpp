#include "reference/vulkan/check.h"

#include <gmock/gmock.h>

#include <limits>

#include "reference/vulkan/test_support.h"

namespace fillrule::vulkan {
namespace {

using testing::StartsWith;

const DeviceInfo kDevice{.driver = "small",
                         .max_target_size = 100,
                         .max_viewport_size = {100, 50},
                         .viewport_bounds = {-200.0F, 199.0F},
                         .line_widths = {.min = 0.5F, .max = 8, .step = 0.375F},
                         .point_sizes = {.min = 1, .max = 64}};

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

// The same on a device that has every feature.
template <typename Change>
std::string able_error_after(Change change) {
  DeviceInfo able = kDevice;
  able.features = FeatureSet::all();
  Case drawn = valid_case();
  change(drawn, drawn.draws.front());
  const Result<void> checked = check_case(able, drawn);
  return checked ? "no error" : checked.error().what;
}

TEST(CheckCase, TakesAValidCase) {
  EXPECT_EQ(error_of(valid_case()), "no error");
}

TEST(CheckCase, NamesWhatIsWrongWithTheTarget) {
  EXPECT_EQ(error_after([](Case& c, Draw&) { c.target.height = 0; }), "target.size: 16 x 0 pixels is empty");
  EXPECT_EQ(error_after([](Case& c, Draw&) { c.target.width = 101; }),
            "target.size: 101 x 16 pixels is beyond the 100 pixels that small can draw to");
  EXPECT_EQ(error_after([](Case& c, Draw&) { c.target.samples = VK_SAMPLE_COUNT_4_BIT; }),
            "small lacks 4 samples (samples)");
  EXPECT_EQ(error_after([](Case& c, Draw&) { c.target.depth_format = VK_FORMAT_D16_UNORM; }),
            "small lacks depth format D16_UNORM (depth_format)");
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

TEST(CheckCase, NamesWhatIsWrongWithTheIndices) {
  const auto with = [](auto change) {
    return able_error_after([&](Case&, Draw& draw) {
      draw.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
      draw.indices = {1, 2, 3, 255};
      draw.index_type = VK_INDEX_TYPE_UINT8_EXT;
      draw.vertex_offset = -1;
      draw.primitive_restart = true;
      change(draw);
    });
  };
  EXPECT_EQ(with([](Draw&) {}), "no error");
  EXPECT_EQ(with([](Draw& d) { d.vertex_offset = 0; }), "indices: 3 is beyond the last of 3 vertices");
  EXPECT_EQ(with([](Draw& d) { d.vertex_offset = -2; }), "indices: -1 is beyond the last of 3 vertices");
  EXPECT_EQ(with([](Draw& d) { d.primitive_restart = false; }), "indices: 254 is beyond the last of 3 vertices");
  EXPECT_EQ(with([](Draw& d) { d.indices->push_back(256); }), "indices: 256 is beyond the 255 of their type");
  EXPECT_EQ(with([](Draw& d) { d.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST; }),
            "primitive_restart: Vulkan restarts strips and fans, not lists");
}

TEST(CheckCase, NamesSizesThatTheDeviceCannotDraw) {
  const auto line = [](float width) {
    return able_error_after([&](Case&, Draw& draw) {
      draw.topology = VK_PRIMITIVE_TOPOLOGY_LINE_LIST;
      draw.state.line_width = width;
    });
  };
  EXPECT_EQ(line(7.625F), "no error");
  EXPECT_EQ(line(1), "no error");  // every device draws it, on a step or not
  EXPECT_EQ(line(300), "line_width: 300 is beyond the 0.5 to 8 of small");
  EXPECT_EQ(line(1.5F), "line_width: 1.5 is not in small's steps of 0.375");
  const auto point = [](float size, VkPrimitiveTopology topology) {
    return able_error_after([&](Case&, Draw& draw) {
      draw.topology = topology;
      draw.point_sizes = {1, size, 1};
    });
  };
  EXPECT_EQ(point(1.3F, VK_PRIMITIVE_TOPOLOGY_POINT_LIST), "no error");
  EXPECT_EQ(point(65, VK_PRIMITIVE_TOPOLOGY_POINT_LIST), "point_sizes: 65 is beyond the 1 to 64 of small");
  EXPECT_EQ(point(65, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST), "no error");  // no points are drawn
}

TEST(CheckCase, NamesWhatIsWrongWithTheState) {
  EXPECT_EQ(able_error_after([](Case&, Draw& draw) { draw.state.depth_bounds = {.min = -1, .max = 1}; }),
            "depth_bounds: -1 to 1 is not within [0, 1]");
  const auto bresenham = [](Case& c, Draw& draw) {
    draw.topology = VK_PRIMITIVE_TOPOLOGY_LINE_STRIP;
    draw.state.line_mode = VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT;
    c.varyings[0].sampling = Sampling::kSample;
  };
  EXPECT_EQ(able_error_after(bresenham), "line_mode: Vulkan has no Bresenham lines with interpolation at samples");
}

TEST(CheckCase, NamesWhatVerticesLack) {
  EXPECT_EQ(able_error_after([](Case&, Draw& draw) {
              draw.point_sizes = {1, 2};
            }),
            "vertices: 2 point sizes for 3 vertices of 1 each");
  EXPECT_EQ(able_error_after([](Case&, Draw& draw) { draw.clip_distance_count = 1; }),
            "vertices: 0 clip distances for 3 vertices of 1 each");
  EXPECT_EQ(able_error_after([](Case&, Draw& draw) { draw.cull_distances = {1}; }),
            "vertices: 1 cull distances for 3 vertices of 0 each");
  EXPECT_EQ(able_error_after([](Case&, Draw& draw) {
              draw.clip_distance_count = 5;
              draw.cull_distance_count = 4;
              draw.clip_distances.resize(15);
              draw.cull_distances.resize(12);
            }),
            "clip_distances: 5 and 4 cull distances are together more than 8");
  EXPECT_EQ(able_error_after([](Case& c, Draw&) {
              c.varyings.push_back({.name = "at", .components = 3, .source = VaryingSource::kFragCoord});
            }),
            "varyings: the built-in of at has 4 components, not 3");
  // Built-ins have no values in the vertices.
  EXPECT_EQ(able_error_after([](Case& c, Draw&) {
              c.varyings.push_back({.name = "at", .components = 4, .source = VaryingSource::kFragCoord});
            }),
            "no error");
}

}  // namespace
}  // namespace fillrule::vulkan
