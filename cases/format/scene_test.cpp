// [scene]: what is read, and how mistakes are told.
#include <gmock/gmock.h>

#include "cases/format/test_files.h"
#include "cases/model/scene.h"

namespace fillrule::format {
namespace {

Scene scene_of(const std::string& text) {
  const CaseFile file = parse(kHead + text, "scene.toml", "scene");
  for (const Error& error : file.errors) ADD_FAILURE() << to_string(error);
  if (file.cases.size() != 1 || !file.cases[0].scene) {
    ADD_FAILURE() << "no scene";
    return {};
  }
  return *file.cases[0].scene;
}

std::string error_of(const std::string& text) {
  const CaseFile file = parse(kHead + text, "scene.toml", "scene");
  EXPECT_TRUE(file.cases.empty());
  return file.errors.empty() ? std::string() : to_string(file.errors.front());
}

TEST(SceneFormat, ReadsEveryKey) {
  const Scene scene = scene_of(R"(
[state]
cull_mode = "back"
[scene]
order = "painter"
uv_interpolation = "noperspective"
transform_on = "both"
background = [0.25, 0.5, 1]
camera = { eye = [1, 2, 3], target = [0, 0, 1], up = [0, 0, 1], handedness = "left" }
projection = { frustum = [-1, 2, -3, 4], near = 0.5, far = "10 * 2" }
light = { ambient = [0.1, 0.2, 0.3], directional = [{ direction = [0, -2, 0], color = [1, 1, 0] }] }
[[scene.object]]
mesh = "cube"
normals = "smooth"
transform = [{ translate = [1, 0, 0] }, { rotate_y = 90 }, { rotate = { axis = [1, 1, 0], degrees = 30 } }, { scale = 2 }]
material = { texture = "a.png", filter = "nearest", wrap = ["repeat", "clamp_to_border"], border = "white", mipmaps = "linear", color = [1, 0, 0], specular = [0.5, 0.5, 0.5], shininess = 8 }
)");
  EXPECT_EQ(scene.state.cull_mode, VkCullModeFlags{VK_CULL_MODE_BACK_BIT});
  EXPECT_FALSE(scene.state.depth_test);
  EXPECT_EQ(scene.order, DrawOrder::kPainter);
  EXPECT_TRUE(scene.affine_texture);
  EXPECT_EQ(scene.transform_on, TransformOn::kBoth);
  EXPECT_EQ(scene.background, (Color{0.25, 0.5, 1}));
  EXPECT_EQ(scene.camera.handedness, Handedness::kLeft);
  const auto& look = std::get<LookAt>(scene.camera.placement);
  EXPECT_EQ(look.eye, (Vector3{1, 2, 3}));
  EXPECT_EQ(look.up, (Vector3{0, 0, 1}));
  EXPECT_EQ(std::get<FrustumProjection>(scene.projection.shape).top, 4);
  EXPECT_EQ(scene.projection.far, 20);
  ASSERT_TRUE(scene.lighting.has_value());
  EXPECT_EQ(scene.lighting->ambient, (Color{0.1, 0.2, 0.3}));
  ASSERT_EQ(scene.lighting->directional.size(), 1U);
  EXPECT_EQ(scene.lighting->directional[0].color, (Color{1, 1, 0}));
  ASSERT_EQ(scene.objects.size(), 1U);
  const SceneObject& object = scene.objects[0];
  EXPECT_EQ(object.mesh.text, "cube");
  EXPECT_EQ(object.mesh.line, 16U);
  EXPECT_EQ(object.normals, Normals::kSmooth);
  EXPECT_EQ(object.transform,
            (Transform{Translate{{1, 0, 0}}, Rotate{{0, 1, 0}, 90}, Rotate{{1, 1, 0}, 30}, Scale{{2, 2, 2}}}));
  EXPECT_EQ(object.material.shininess, 8U);
  EXPECT_EQ(object.material.sampling,
            (Sampling2D{VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_REPEAT, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER,
                        VK_BORDER_COLOR_FLOAT_OPAQUE_WHITE, Mipmaps::kLinear}));
}

TEST(SceneFormat, HasADepthTestUnlessThePainterOrders) {
  EXPECT_TRUE(scene_of("[[scene.object]]\nmesh = \"cube\"\n").state.depth_test);
  EXPECT_FALSE(scene_of("[scene]\norder = \"painter\"\n[[scene.object]]\nmesh = \"cube\"\n").state.depth_test);
  EXPECT_FALSE(scene_of("[state]\ndepth_test = false\n[[scene.object]]\nmesh = \"cube\"\n").state.depth_test);
}

TEST(SceneFormat, SweepsAsEveryCaseDoes) {
  const CaseFile file = parse(kHead + R"(
[sweep]
angle = [0, 90]
[[scene.object]]
mesh = "cube"
transform = [{ rotate_x = "angle / 2" }]
)",
                              "scene.toml", "scene");
  ASSERT_EQ(file.cases.size(), 2U);
  EXPECT_EQ(file.cases[1].name, "scene[angle=90]");
  EXPECT_EQ(file.cases[1].scene->objects[0].transform, (Transform{Rotate{{1, 0, 0}, 45}}));
}

TEST(SceneFormat, TellsMistakesWithTheirPlace) {
  using ::testing::AllOf;
  using ::testing::HasSubstr;
  const std::string object = "[[scene.object]]\nmesh = \"cube\"\n";
  EXPECT_THAT(error_of("[scene]\n"), HasSubstr("scene.toml:4:1: a scene without an object"));
  EXPECT_THAT(error_of("[[scene.object]]\n"), HasSubstr("an object without a mesh"));
  EXPECT_THAT(error_of("[scene]\ncamra = {}\n" + object),
              AllOf(HasSubstr("scene.toml:5:1: unknown key \"camra\""), HasSubstr("did you mean \"camera\"?")));
  EXPECT_THAT(error_of("[scene]\norder = \"paintr\"\n" + object), HasSubstr("did you mean \"painter\"?"));
  EXPECT_THAT(error_of("[scene]\ncamera = { eye = [1, 2] }\n" + object), HasSubstr("eye must be 3 numbers, not 2"));
  EXPECT_THAT(error_of("[scene]\ncamera = { eye = [0, 1, 0], target = [0, 0, 0] }\n" + object),
              HasSubstr("looks along up"));
  EXPECT_THAT(error_of("[scene]\nprojection = { fov_y = 180 }\n" + object), HasSubstr("below 180 degrees, not 180"));
  EXPECT_THAT(error_of("[scene]\nprojection = { near = 2, far = 1 }\n" + object),
              HasSubstr("near = 2 is not before"));
  EXPECT_THAT(error_of("[scene]\nprojection = { near = 0 }\n" + object), HasSubstr("near must be above 0"));
  EXPECT_THAT(error_of("[scene]\nprojection = { fov_y = 40, frustum = [-1, 1, -1, 1] }\n" + object),
              HasSubstr("more than one kind"));
  EXPECT_THAT(error_of("[scene]\nprojection = { frustum = [1, 1, -1, 1] }\n" + object), HasSubstr("without area"));
  EXPECT_THAT(error_of(object + "transform = [{ rotate_w = 1 }]\n"),
              AllOf(HasSubstr("unknown key \"rotate_w\""), HasSubstr("did you mean")));
  EXPECT_THAT(error_of(object + "transform = [{ rotate = { degrees = 1 } }]\n"), HasSubstr("without \"axis\""));
  EXPECT_THAT(error_of(object + "transform = [{ scale = [1, 0, 1] }]\n"), HasSubstr("a scale of 0"));
  EXPECT_THAT(error_of(object + "material = { wrap = \"repeat\" }\n"), HasSubstr("\"wrap\" without a texture"));
  EXPECT_THAT(error_of(object + "material = { shininess = 0 }\n"), HasSubstr("shininess must be 1 to 1024"));
  EXPECT_THAT(error_of(object + "[[draw]]\npositions = [[0, 0]]\n"), HasSubstr("\"draw\" beside [scene]"));
}

}  // namespace
}  // namespace fillrule::format
