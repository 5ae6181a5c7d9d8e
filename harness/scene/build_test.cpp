#include "harness/scene/build.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <set>

#include "cases/format/writer.h"
#include "cases/model/temporary_folder.h"
#include "harness/scene/model_scene.h"
#include "harness/scene/test_scenes.h"
#include "harness/scene/view.h"

namespace fillrule::scene {
namespace {

using ::testing::HasSubstr;

const std::string kCube = "[[scene.object]]\nmesh = 'cube'\n";

TEST(BuildScene, MakesADrawForEachObject) {
  Assets assets;
  const Case built = built_scene(parsed_scene(kCube + "[[scene.object]]\nmesh = 'quad'\n"), assets);
  ASSERT_EQ(built.draws.size(), 2U);
  EXPECT_EQ(primitive_count(built.draws[0]), 12U);
  EXPECT_EQ(primitive_count(built.draws[1]), 2U);
  EXPECT_THAT(built.scene->object_of_draw, ::testing::ElementsAre(0, 1));
  EXPECT_EQ(vertex_component_count(built.varyings), 8U);
  EXPECT_TRUE(built.draws[0].state.depth_test);
  EXPECT_EQ(built.draws[0].state.viewport.width, 64);
}

TEST(BuildScene, TransformsPositionsAndNormals) {
  Assets assets;
  const Case built = built_scene(
      parsed_scene("[scene]\nprojection = { orthographic = [-4, 4, -4, 4], near = 1, far = 9 }\n"
                   "[[scene.object]]\nmesh = 'quad'\n"
                   "transform = [{ scale = [1, 1, 5] }, { rotate_x = -90 }, { translate = [1, 2, 3] }]\n"),
      assets);
  ASSERT_EQ(built.draws.size(), 1U);
  const Draw& draw = built.draws[0];
  // The quad's first corner, (-1, -1, 0), turned upwards: (-1, 0, 1).
  EXPECT_NEAR(draw.varyings[0], 0, 1e-6);
  EXPECT_NEAR(draw.varyings[1], 2, 1e-6);
  EXPECT_NEAR(draw.varyings[2], 4, 1e-6);
  EXPECT_NEAR(draw.varyings[4], 1, 1e-6) << "the normal points up, and has length 1";
  EXPECT_EQ(draw.varyings[6], 0) << "u";
  EXPECT_EQ(draw.varyings[7], 1) << "v of the image's lower edge";
  EXPECT_NEAR(draw.positions[0][0], 0, 1e-6);
  EXPECT_NEAR(draw.positions[0][1], -0.5, 1e-6) << "y is down in clip space";
  EXPECT_NEAR(draw.positions[0][2], 0, 1e-6);
  EXPECT_EQ(draw.positions[0][3], 1);
}

TEST(BuildScene, TransformsNormalsOfSlopesByTheInverse) {
  Assets assets;
  const Case built = built_scene(
      parsed_scene("[[scene.object]]\nmesh = 'quad'\ntransform = [{ rotate_x = -45 }, { scale = [1, 4, 1] }]\n"),
      assets);
  const float* const normal = &built.draws[0].varyings[3];
  // Along the scaled slope: (0, 4, -1); the normal is at right angles to it.
  EXPECT_NEAR(normal[1] * 4 - normal[2], 0, 1e-6);
  EXPECT_NEAR(std::hypot(normal[1], normal[2]), 1, 1e-6);
}

TEST(BuildScene, SortsTrianglesForThePainter) {
  Assets assets;
  const Case built =
      built_scene(parsed_scene("[scene]\norder = 'painter'\ncamera = { eye = [0, 0, 9] }\n"
                               "[[scene.object]]\nmesh = 'quad'\ntransform = [{ translate = [0, 0, 2] }]\n"
                               "[[scene.object]]\nmesh = 'quad'\n"
                               "[[scene.object]]\nmesh = 'quad'\ntransform = [{ translate = [0, 0, 3] }]\n"),
                  assets);
  EXPECT_THAT(built.scene->object_of_draw, ::testing::ElementsAre(1, 0, 2));
  EXPECT_FALSE(built.draws[0].state.depth_test);
  EXPECT_EQ(primitive_count(built.draws[0]), 2U);
}

TEST(BuildScene, KeepsSharedVerticesEqual) {
  Assets assets;
  const Case built =
      built_scene(parsed_scene("[[scene.object]]\nmesh = 'torus'\ntransform = [{ rotate_x = 33 }]\n"), assets);
  std::set<ClipPosition> distinct(built.draws[0].positions.begin(), built.draws[0].positions.end());
  EXPECT_EQ(distinct.size(), 24U * 12U) << "the seam of the torus is closed";
}

TEST(BuildScene, TellsWhatIsMissingAndWhere) {
  Assets assets;
  const auto error_of = [&](const std::string& text) {
    const Result<Case> built = build(parsed_scene(text), assets);
    return built ? std::string("no error") : to_string(built.error());
  };
  EXPECT_THAT(
      error_of("[[scene.object]]\nmesh = 'cubw'\n"),
      ::testing::AllOf(HasSubstr("a.toml:5:8: there is no model \"cubw\""), HasSubstr("did you mean \"cube\"?")));
  EXPECT_THAT(error_of("[[scene.object]]\nmesh = 'no/such.obj'\n"),
              HasSubstr("a.toml:5:8: there is no file no/such.obj"));
  EXPECT_THAT(error_of(kCube + "material = { texture = 'gird.png' }\n"),
              ::testing::AllOf(HasSubstr("a.toml:6:24: there is no image \"gird.png\""), HasSubstr("\"grid.png\"")));
  EXPECT_THAT(error_of(kCube + "transform = [{ scale = 1e38 }, { scale = 1e38 }]\n"), HasSubstr("beyond float32"));
  EXPECT_EQ(error_of(kCube), "no error");
}

TEST(BuildScene, TakesTheFilesOutThatCannotBeBuilt) {
  const TemporaryFolder folder;
  std::ofstream(folder.path("bad.obj")) << "v 0 0 0\nf 1 2 3\n";
  std::ofstream(folder.path("a.toml")) << "title = 't'\nwhy = 'w'\nspec = 's'\n[sweep]\nx = [1, 2]\n"
                                       << "[[scene.object]]\nmesh = 'bad.obj'\n";
  format::Suite suite = format::load_suite(folder.path(), {});
  ASSERT_EQ(suite.cases.size(), 2U);
  Assets assets;
  build_scenes(suite, assets);
  EXPECT_TRUE(suite.cases.empty());
  ASSERT_EQ(suite.errors.size(), 1U);
  EXPECT_THAT(to_string(suite.errors[0]), HasSubstr("bad.obj:2:5: 2 in \"2\" names no \"v\""));
}

TEST(BuildScene, IsWrittenAndReadBackAsAnOrdinaryCase) {
  Assets assets;
  for (const char* const name : {"scenes/textured_cube", "scenes/source_a_cycle_by_painter"}) {
    for (const Case& built : suite_scenes(name, assets)) {
      const std::string written = format::write(built);
      const format::CaseFile file = format::parse(written, built.file, built.name);
      for (const Error& error : file.errors) ADD_FAILURE() << to_string(error);
      ASSERT_EQ(file.cases.size(), 1U);
      EXPECT_FALSE(file.cases[0].scene);
      ASSERT_EQ(file.cases[0].draws.size(), built.draws.size());
      EXPECT_EQ(file.cases[0].draws[0].positions, built.draws[0].positions);
      EXPECT_EQ(file.cases[0].draws[0].varyings, built.draws[0].varyings);
    }
  }
}

TEST(View, TurnsModelsAboutWhatTheCameraLooksAt) {
  Assets assets;
  const Case scene = parsed_scene("[scene]\ncamera = { eye = [1, 0, 9], target = [1, 0, 0] }\n" + kCube);
  const Case turned_case = built_scene(turned(scene, 90), assets);
  // A corner (1, 1, 1) is turned about x = 1: to (2, 1, 0).
  bool found = false;
  for (size_t i = 0; i < turned_case.draws[0].positions.size(); ++i) {
    const float* const p = &turned_case.draws[0].varyings[i * 8];
    found = found || glm::distance(glm::vec3(p[0], p[1], p[2]), glm::vec3(2, 1, 0)) < 1e-5F;
  }
  EXPECT_TRUE(found);
}

TEST(View, IsTheSameAtAnotherSize) {
  Assets assets;
  const Case scene = parsed_scene("[state]\nviewport = { x = 8, width = 48 }\n" + kCube);
  const Case large = built_scene(resized(scene, 128, 256), assets);
  EXPECT_EQ(large.target.height, 256U);
  EXPECT_EQ(large.draws[0].state.viewport.x, 16);
  EXPECT_EQ(large.draws[0].state.viewport.width, 96);
  EXPECT_EQ(large.draws[0].state.scissor.extent.height, 256U);
}

TEST(ModelScene, ShowsTheWholeModel) {
  Assets assets;
  const Result<Case> scene = scene_of_model(kCases + "/meshes/torus.obj", assets);
  ASSERT_TRUE(scene) << to_string(scene.error());
  const Case built = built_scene(*scene, assets);
  for (const auto& [x, y, z, w] : built.draws[0].positions) {
    EXPECT_GT(w, 0);
    EXPECT_LT(std::max(std::abs(x), std::abs(y)), w);
    EXPECT_TRUE(z > 0 && z < w);
  }
  EXPECT_THAT(to_string(scene_of_model("no.obj", assets).error()), HasSubstr("no.obj"));
}

}  // namespace
}  // namespace fillrule::scene
