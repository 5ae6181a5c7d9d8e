// What the five source systems do, where a picture alone does not show it: pairs of a wrong and a right way, whose
// pictures differ as they should; and pairs of two ways, whose pictures are the same. harness/README.md has the
// table.
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "harness/scene/test_scenes.h"
#include "harness/scene/view.h"

namespace fillrule::scene {
namespace {

Planes painted_scene(const std::string& name) {
  Assets assets;
  const std::vector<Case> scenes = suite_scenes(name, assets);
  if (scenes.size() != 1) {
    ADD_FAILURE() << name << ": " << scenes.size();
    return {};
  }
  return painted(scenes[0], assets, renderer_painter({}));
}

std::array<float, 3> color_at(const Planes& planes, size_t i) {
  return {planes.varyings[0][i], planes.varyings[1][i], planes.varyings[2][i]};
}

size_t differing(const Planes& a, const Planes& b) {
  size_t count = 0;
  for (size_t i = 0; i < a.hits.size(); ++i) count += color_at(a, i) != color_at(b, i) ? 1U : 0U;
  return count;
}

// How many samples show a primitive that is not the nearest of those there: the depth buffer's picture of the same
// triangles says which one is.
struct PainterAgainstDepthBuffer {
  Planes painter;
  Planes depth_buffer;
  size_t differing = 0;
  size_t painted_over = 0;  // samples that the painter drew twice and more
};

PainterAgainstDepthBuffer compare(const std::string& name) {
  PainterAgainstDepthBuffer result{.painter = painted_scene("scenes/source_a_" + name + "_by_painter"),
                                   .depth_buffer = painted_scene("scenes/source_a_" + name + "_by_depth_buffer")};
  result.differing = differing(result.painter, result.depth_buffer);
  for (const uint32_t hits : result.painter.hits) result.painted_over += hits > 1 ? 1U : 0U;
  return result;
}

TEST(SourceA, ThePainterFailsAtCyclesAndTheDepthBufferDoesNot) {
  const PainterAgainstDepthBuffer cycle = compare("cycle");
  EXPECT_GT(cycle.differing, 50U);
  EXPECT_LT(cycle.differing, cycle.painted_over) << "wrong only where beams overlap";
  // Turned by a third the picture is the same with the colours exchanged: each beam is in front once.
  std::map<std::array<float, 3>, size_t> visible;
  for (size_t i = 0; i < cycle.depth_buffer.hits.size(); ++i) {
    if (cycle.depth_buffer.hits[i] != 0) ++visible[color_at(cycle.depth_buffer, i)];
  }
  ASSERT_EQ(visible.size(), 3U);
  const auto [least, most] = std::minmax_element(visible.begin(), visible.end(),
                                                 [](const auto& a, const auto& b) { return a.second < b.second; });
  EXPECT_LT(static_cast<double>(most->second - least->second), 0.05 * static_cast<double>(most->second));
}

TEST(SourceA, ThePainterFailsAtCrossingTrianglesAndTheDepthBufferDoesNot) {
  const PainterAgainstDepthBuffer crossing = compare("crossing");
  EXPECT_GT(crossing.differing, 200U);
  EXPECT_LT(crossing.differing, crossing.painted_over);
}

TEST(SourceA, ThePainterIsRightForAConvexModel) {
  Assets assets;
  Case painter = suite_scenes("scenes/source_a_painter_of_a_convex_model", assets).at(0);
  Scene scene = *painter.scene;
  scene.order = DrawOrder::kDepthBuffer;
  scene.state.depth_test = true;
  const Case depth_buffer = built_scene(with_scene(painter, scene), assets);
  EXPECT_EQ(
      differing(painted(painter, assets, renderer_painter({})), painted(depth_buffer, assets, renderer_painter({}))),
      0U);
}

TEST(SourceA, TheNearPlaneTakesWhatIsBehindTheEye) {
  Assets assets;
  for (const Case& built : suite_scenes("scenes/source_a_near_plane", assets)) {
    const Planes planes = painted(built, assets, renderer_painter({}));
    for (size_t i = 0; i < planes.hits.size(); ++i) {
      if (planes.hits[i] != 0) {
        EXPECT_GE(planes.depth[i], 0);
      }
    }
    EXPECT_GT(std::count(planes.hits.begin(), planes.hits.end(), 0U), 0);
  }
}

// In every row of the image plane the tiles of a floor have equal widths; affine coordinates break them.
TEST(SourceB, AffineTexturesBreakAndPerspectiveOnesDoNot) {
  const Planes affine = painted_scene("scenes/source_b_floor_affine");
  const Planes perspective = painted_scene("scenes/source_b_floor_perspective");
  EXPECT_GT(differing(affine, perspective), 500U);
  EXPECT_EQ(affine.hits, perspective.hits);
  // The middle column runs along a border of tiles; mirrored about it, the right picture has light and dark
  // exchanged.
  const auto asymmetric = [](const Planes& planes) {
    size_t count = 0;
    for (size_t y = 0; y < planes.height; ++y) {
      for (size_t x = 0; x < planes.width / 2; ++x) {
        const size_t left = y * planes.width + x;
        const size_t right = y * planes.width + planes.width - 1 - x;
        if (planes.hits[left] == 0 || planes.hits[right] == 0) continue;
        const bool is_red = planes.varyings[0][left] > planes.varyings[2][left] + 0.3F ||
                            planes.varyings[0][right] > planes.varyings[2][right] + 0.3F;
        if (is_red) continue;
        const bool light_left = planes.varyings[1][left] > 0.5F;
        const bool light_right = planes.varyings[1][right] > 0.5F;
        count += light_left == light_right ? 1U : 0U;
      }
    }
    return count;
  };
  EXPECT_LT(asymmetric(perspective), 50U);
  EXPECT_GT(asymmetric(affine), 500U);
}

TEST(SourceB, BothDepthRangesShowTheSame) {
  Assets assets;
  const std::vector<Case> both = suite_scenes("scenes/source_b_depth_range", assets);
  ASSERT_EQ(both.size(), 2U);
  const Planes a = painted(both[0], assets, renderer_painter({}));
  const Planes b = painted(both[1], assets, renderer_painter({}));
  EXPECT_EQ(a.hits, b.hits);
  // Depth 0 to 1 of -1 to 1 and of 0 to 1 is not the same, but for rounding at both ends: the window's is.
  for (size_t i = 0; i < a.depth.size(); ++i) EXPECT_NEAR(a.depth[i], b.depth[i], 1e-6);
}

TEST(SourceB, CullingLeavesOneSideOfEach) {
  Assets assets;
  std::map<std::string, Planes> planes;
  for (const Case& built : suite_scenes("scenes/source_b_culling", assets)) {
    planes[built.name.substr(built.name.find('['))] = painted(built, assets, renderer_painter({}));
  }
  ASSERT_EQ(planes.size(), 6U);
  const Planes& all = planes["[cull=none,front=counter_clockwise]"];
  const Planes& outside = planes["[cull=back,front=counter_clockwise]"];
  const Planes& inside = planes["[cull=front,front=counter_clockwise]"];
  EXPECT_LT(differing(all, outside), 10U) << "the outside hides the inside, but where they meet at the silhouette";
  EXPECT_GT(differing(all, inside), 1000U);
  EXPECT_EQ(differing(outside, planes["[cull=front,front=clockwise]"]), 0U);
  // A closed model has as many front faces along each ray as back faces.
  for (size_t i = 0; i < all.hits.size(); ++i) EXPECT_EQ(outside.hits[i] == 0, inside.hits[i] == 0) << i;
}

TEST(SourceB, AModelTurnedOverInAWorldTurnedOverIsTheSame) {
  Assets assets;
  std::map<std::string, Planes> planes;
  for (const Case& built : suite_scenes("scenes/source_b_right_to_left", assets)) {
    planes[built.name.substr(built.name.find('['))] = painted(built, assets, renderer_painter({}));
  }
  ASSERT_EQ(planes.size(), 4U);
  const Planes& right = planes["[side=1,handedness=right]"];
  const Planes& left = planes["[side=-1,handedness=left]"];
  size_t covered = 0;
  size_t apart = 0;
  for (size_t i = 0; i < right.hits.size(); ++i) {
    covered += right.hits[i] != 0 ? 1U : 0U;
    apart += right.owner[i] != left.owner[i] ? 1U : 0U;
  }
  EXPECT_GT(covered, 2000U);
  EXPECT_LE(apart * 1000, covered) << "but for rounding";
  EXPECT_GT(differing(right, planes["[side=1,handedness=left]"]), 500U) << "turned over once, it is mirrored";
}

TEST(SourceB, ACubeTurnedAllTheWayIsWhereItWas) {
  Assets assets;
  const std::vector<Case> frames = suite_scenes("scenes/source_b_turning", assets);
  ASSERT_EQ(frames.size(), 8U);
  Scene scene = *frames[0].scene;
  std::get<Rotate>(scene.objects[0].transform[1]).degrees = 360;
  const Case whole = built_scene(with_scene(frames[0], scene), assets);
  const Planes first = painted(frames[0], assets, renderer_painter({}));
  EXPECT_EQ(first.owner, painted(whole, assets, renderer_painter({})).owner);
  EXPECT_NE(first.owner, painted(frames[1], assets, renderer_painter({})).owner);
}

TEST(SourceB, BitmapsAreTheSameInAnyFormat) {
  Assets assets;
  const Case bmp = suite_scenes("scenes/source_b_bitmap", assets).at(0);
  Scene scene = *bmp.scene;
  scene.objects[0].material.texture->text = "grid.png";
  EXPECT_EQ(differing(painted(bmp, assets, renderer_painter({})),
                      painted(with_scene(bmp, scene), assets, renderer_painter({}))),
            0U);
}

TEST(SourceB, TexturesBeginAtTheImagesTopLeft) {
  Assets assets;
  const Case upright = built_scene(
      parsed_scene("[scene]\nprojection = { orthographic = [-1, 1, -1, 1] }\n[[scene.object]]\nmesh = 'quad'\n"
                   "material = { texture = 'checker.png', filter = 'nearest' }\n"),
      assets);
  const Planes planes = painted(upright, assets, renderer_painter({}));
  EXPECT_GT(planes.varyings[0][2 * 64 + 2], planes.varyings[2][2 * 64 + 2] + 0.5F) << "the red square";
  EXPECT_LT(planes.varyings[0][61 * 64 + 2], planes.varyings[2][61 * 64 + 2] + 0.1F);
}

TEST(SourceC, AFloorWithoutAVertexInTheVolumeIsDrawn) {
  Assets assets;
  const Case built = suite_scenes("scenes/source_c_all_vertices_outside[size=50]", assets).at(0);
  bool behind = false;
  for (const auto& [x, y, z, w] : built.draws[0].positions) {
    EXPECT_TRUE(std::abs(x) > w || std::abs(y) > w || z < 0 || z > w);
    behind = behind || w < 0;
  }
  EXPECT_TRUE(behind);
  const Planes planes = painted(built, assets, renderer_painter({}));
  EXPECT_GT(std::count(planes.hits.begin(), planes.hits.end(), 1U), 5000);
}

TEST(SourceC, WhatIsNearerHidesWhoeverIsDrawnFirst) {
  Assets assets;
  const Case built = suite_scenes("scenes/source_c_occlusion[z=1.5]", assets).at(0);
  Case backwards = built;
  Scene scene = *built.scene;
  std::reverse(backwards.draws.begin(), backwards.draws.end());
  std::reverse(scene.object_of_draw.begin(), scene.object_of_draw.end());
  EXPECT_EQ(differing(painted(built, assets, renderer_painter({})),
                      painted(with_scene(backwards, scene), assets, renderer_painter({}))),
            0U);
}

TEST(SourceD, AFieldOfViewIsAFrustum) {
  Assets assets;
  const std::string object = "[[scene.object]]\nmesh = 'torus'\n";
  const double top = std::tan(std::acos(-1) / 8);  // of 45 degrees
  const Case by_angle =
      built_scene(parsed_scene("[scene]\nprojection = { fov_y = 45, near = 1, far = 9 }\n" + object), assets);
  Scene scene = *by_angle.scene;
  scene.projection.shape = FrustumProjection{-top, top, -top, top};
  const Case by_sides = built_scene(with_scene(by_angle, scene), assets);
  ASSERT_EQ(by_angle.draws[0].positions.size(), by_sides.draws[0].positions.size());
  for (size_t i = 0; i < by_angle.draws[0].positions.size(); ++i) {
    for (size_t c = 0; c < 4; ++c) {
      EXPECT_NEAR(by_angle.draws[0].positions[i][c], by_sides.draws[0].positions[i][c], 1e-6);
    }
  }
}

TEST(SourceE, DepthIsLinearInTheWindow) {
  // Down a column over a floor, within its nearer triangle: second differences of the stored depth vanish, though the
  // distance has none that do.
  const Planes planes = painted_scene("scenes/source_b_floor_perspective");
  const size_t x = 100;
  size_t inside = 0;
  for (size_t y = 1; y + 1 < planes.height; ++y) {
    const auto at = [&](size_t row) { return row * planes.width + x; };
    if (planes.owner[at(y)] != 0 || planes.owner[at(y - 1)] != 0 || planes.owner[at(y + 1)] != 0) continue;
    ++inside;
    const double bend =
        double{planes.depth[at(y - 1)]} - 2 * double{planes.depth[at(y)]} + double{planes.depth[at(y + 1)]};
    EXPECT_NEAR(bend, 0, 4e-7);
  }
  EXPECT_GT(inside, 15U);
}

// The table names files that are there, and of the scenes of source systems all.
TEST(SourceSystems, AreAllInTheTable) {
  const std::string harness = FILLRULE_SOURCE_DIR "/harness/";
  std::ifstream stream(harness + "README.md");
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  size_t links = 0;
  for (size_t at = text.find("](../"); at != std::string::npos; at = text.find("](../", at + 1)) {
    const std::string path = text.substr(at + 2, text.find(')', at) - at - 2);
    EXPECT_TRUE(std::filesystem::exists(harness + path)) << path;
    ++links;
  }
  EXPECT_GT(links, 60U);
  for (const auto& entry : std::filesystem::directory_iterator(kCases + "/scenes")) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(!name.starts_with("source_") || text.find(name) != std::string::npos) << name;
  }
}

}  // namespace
}  // namespace fillrule::scene
