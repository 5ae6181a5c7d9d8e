#include "harness/view/camera_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace fillrule::view {
namespace {

constexpr Ball kBall{.centre = {0, 0, 0}, .radius = 1};

Scene scene_of(Handedness handedness) {
  Scene scene;
  const double z = handedness == Handedness::kLeft ? -5 : 5;
  scene.camera = {.placement = LookAt{.eye = {0, 0, z}}, .handedness = handedness};
  scene.projection = {.shape = PerspectiveProjection{}, .near = 1, .far = 10};
  scene.state.viewport = {.width = 200, .height = 100, .maxDepth = 1};
  return scene;
}

Scene seen(const Scene& scene, const CameraControl& camera) {
  Scene result = scene;
  camera.apply(result);
  return result;
}

glm::dvec2 pixel(const Scene& scene, const CameraControl& camera, const glm::dvec3& world) {
  return lens_of(seen(scene, camera)).project(world);
}

void drag(CameraControl& camera, Grab grab, const glm::dvec2& by) {
  camera.grab_begin(grab, {50, 50});
  camera.grab_update(glm::dvec2(50, 50) + by);
  camera.grab_end();
}

double distance_of(const Scene& scene) {
  const auto& look = std::get<LookAt>(scene.camera.placement);
  const glm::dvec3 eye(look.eye[0], look.eye[1], look.eye[2]);
  return glm::distance(eye, glm::dvec3(look.target[0], look.target[1], look.target[2]));
}

// In worlds of either handedness.
class CameraControlTest : public ::testing::TestWithParam<Handedness> {
 protected:
  const Scene scene_ = scene_of(GetParam());
  const double towards_ = GetParam() == Handedness::kLeft ? -1 : 1;
  const glm::dvec3 front_{0, 0, towards_};  // of the ball
  CameraControl camera_{scene_, kBall};
};

TEST_P(CameraControlTest, LeavesTheSceneAsItIsUntilItIsMoved) {
  Scene odd = scene_;
  odd.camera.placement = Transform{Rotate{{1, 2, 3}, 40}, Translate{{0.1, 0.7, 3}}};
  const CameraControl camera(odd, kBall);
  EXPECT_TRUE(std::holds_alternative<Transform>(seen(odd, camera).camera.placement));
  camera_.grab_begin(Grab::kOrbit, {3, 4});
  camera_.grab_update({3, 4});
  EXPECT_EQ(camera_.changes(), 0U);
}

TEST_P(CameraControlTest, OrbitsSoThatTheFrontFollowsTheMouse) {
  drag(camera_, Grab::kOrbit, {10, 0});
  EXPECT_GT(pixel(scene_, camera_, front_).x, 105);
  EXPECT_NEAR(pixel(scene_, camera_, front_).y, 50, 1e-9);
  EXPECT_NEAR(pixel(scene_, camera_, {0, 0, 0}).x, 100, 1e-9) << "the target stays";
  EXPECT_NEAR(distance_of(seen(scene_, camera_)), 5, 1e-9);
  camera_.reset();
  drag(camera_, Grab::kOrbit, {0, 10});
  EXPECT_GT(pixel(scene_, camera_, front_).y, 55);
  EXPECT_NEAR(pixel(scene_, camera_, front_).x, 100, 1e-9);
}

TEST_P(CameraControlTest, OrbitsNoFurtherThanStraightAbove) {
  drag(camera_, Grab::kOrbit, {30, 1000});
  drag(camera_, Grab::kOrbit, {0, 20});
  const Lens lens = lens_of(seen(scene_, camera_));
  EXPECT_NEAR(lens.back.y, 1, 1e-9);
  EXPECT_NEAR(glm::dot(lens.right, lens.up), 0, 1e-9);
  // And back, without being turned over.
  drag(camera_, Grab::kOrbit, {-30, -50});
  EXPECT_NEAR(lens_of(seen(scene_, camera_)).back.z, towards_, 1e-9);
  EXPECT_GT(lens_of(seen(scene_, camera_)).up.y, 0.99);
}

TEST_P(CameraControlTest, PansByWhatIsUnderTheMouse) {
  drag(camera_, Grab::kPan, {13, -7});
  EXPECT_NEAR(pixel(scene_, camera_, {0, 0, 0}).x, 113, 1e-9);
  EXPECT_NEAR(pixel(scene_, camera_, {0, 0, 0}).y, 43, 1e-9);
}

TEST_P(CameraControlTest, DolliesAndBringsTheNearPlaneAlong) {
  camera_.scroll(2);
  const Scene now = seen(scene_, camera_);
  EXPECT_NEAR(distance_of(now), 5 * 0.81, 1e-9);
  EXPECT_NEAR(now.projection.near, 0.81, 1e-9);
  camera_.scroll(-12);
  const Scene far = seen(scene_, camera_);
  EXPECT_EQ(far.projection.near, 1);
  EXPECT_GE(far.projection.far, distance_of(far) + 1) << "behind the models";
  camera_.scroll(-1e6);
  EXPECT_EQ(distance_of(seen(scene_, camera_)), distance_of(far)) << "not out of the world";
}

TEST_P(CameraControlTest, FliesWhileItIsGrabbedForIt) {
  camera_.hold(FlyDirection::kForward, true);
  camera_.update(1);
  EXPECT_EQ(camera_.changes(), 0U) << "not grabbed";
  camera_.grab_begin(Grab::kFly, {50, 50});
  camera_.update(1);
  EXPECT_EQ(camera_.changes(), 0U) << "what was held before is forgotten";
  camera_.hold(FlyDirection::kForward, true);
  camera_.hold(FlyDirection::kRight, true);
  camera_.update(0.5);
  const auto look = std::get<LookAt>(seen(scene_, camera_).camera.placement);
  EXPECT_NEAR(look.eye[2], 4.5 * towards_, 1e-9);
  EXPECT_NEAR(look.eye[0], 0.5, 1e-9);
  camera_.hold(FlyDirection::kForward, false);
  camera_.hold(FlyDirection::kUp, true);
  camera_.update(0.25);
  EXPECT_NEAR(std::get<LookAt>(seen(scene_, camera_).camera.placement).eye[1], 0.25, 1e-9);
}

TEST_P(CameraControlTest, LooksAroundFromWhereItIs) {
  drag(camera_, Grab::kFly, {10, 0});
  const auto look = std::get<LookAt>(seen(scene_, camera_).camera.placement);
  EXPECT_NEAR(look.eye[2], 5 * towards_, 1e-9);
  EXPECT_LT(pixel(scene_, camera_, {0, 0, 0}).x, 100) << "to the right";
}

TEST_P(CameraControlTest, LooksFromTheSides) {
  const auto looks_along = [&](Side side) {
    camera_.look_from(side);
    return lens_of(seen(scene_, camera_));
  };
  EXPECT_NEAR(looks_along(Side::kRight).back.x, 1, 1e-12);
  EXPECT_NEAR(looks_along(Side::kRight).right.z, -towards_, 1e-12);
  EXPECT_NEAR(looks_along(Side::kTop).back.y, 1, 1e-12);
  EXPECT_NEAR(looks_along(Side::kTop).up.z, -towards_, 1e-12);
  EXPECT_NEAR(looks_along(Side::kTop).right.x, 1, 1e-12);
  EXPECT_NEAR(looks_along(Side::kFront).back.z, towards_, 1e-12);
}

TEST_P(CameraControlTest, FramesABall) {
  const Ball ball{.centre = {3, 1, 2}, .radius = 0.5};
  for (int i = 0; i < 2; ++i) {  // in perspective, then orthographic
    camera_.frame(ball);
    const Lens lens = lens_of(seen(scene_, camera_));
    EXPECT_NEAR(lens.project(ball.centre).x, 100, 1e-9);
    const double top = 50 - lens.project(ball.centre + lens.up * ball.radius).y;
    EXPECT_GT(top, 40);
    EXPECT_LT(top, 50);
    camera_.toggle_orthographic();
  }
}

TEST_P(CameraControlTest, KeepsTheSizeAtTheTargetWhenOrthographic) {
  const glm::dvec3 beside(0.7, 0.2, 0);
  const glm::dvec2 before = pixel(scene_, camera_, beside);
  camera_.toggle_orthographic();
  EXPECT_TRUE(std::holds_alternative<OrthographicProjection>(seen(scene_, camera_).projection.shape));
  EXPECT_NEAR(glm::distance(pixel(scene_, camera_, beside), before), 0, 1e-9);
  EXPECT_NEAR(glm::distance(pixel(scene_, camera_, beside + front_), before), 0, 1e-9) << "parallel";
  camera_.scroll(3);
  const glm::dvec2 magnified = pixel(scene_, camera_, beside);
  EXPECT_GT(glm::distance(magnified, {100, 50}), glm::distance(before, {100, 50}) * 1.3);
  camera_.toggle_orthographic();
  EXPECT_NEAR(glm::distance(pixel(scene_, camera_, beside), magnified), 0, 1e-9);
}

TEST_P(CameraControlTest, KeepsPixelsSquareWhenThePictureIsResized) {
  camera_.toggle_orthographic();
  camera_.resize(100, 100);
  const auto box = std::get<OrthographicProjection>(seen(scene_, camera_).projection.shape);
  EXPECT_NEAR(box.right - box.left, box.top - box.bottom, 1e-12);
}

TEST_P(CameraControlTest, MovesAFrustumAndACameraThatATransformPlaces) {
  Scene scene = scene_;
  scene.camera.placement = Transform{Rotate{{0, 1, 0}, 30}, Translate{{2, 0, 4 * towards_}}};
  scene.projection.shape = FrustumProjection{.left = -0.2, .right = 0.4, .bottom = -0.1, .top = 0.2};
  CameraControl camera(scene, kBall);
  const glm::dvec2 before = lens_of(scene).project({0, 0, 0});
  drag(camera, Grab::kPan, {0, 0.25});
  drag(camera, Grab::kPan, {0, -0.25});
  EXPECT_NEAR(glm::distance(pixel(scene, camera, {0, 0, 0}), before), 0, 1e-6) << "taken over as it was";
  camera.scroll(2);
  const Scene now = seen(scene, camera);
  const auto& frustum = std::get<FrustumProjection>(now.projection.shape);
  EXPECT_NEAR(frustum.right / now.projection.near, 0.4, 1e-9) << "the same angle";
}

INSTANTIATE_TEST_SUITE_P(Worlds, CameraControlTest, ::testing::Values(Handedness::kRight, Handedness::kLeft),
                         [](const auto& info) {
                           return info.param == Handedness::kLeft ? "left_handed" : "right_handed";
                         });

}  // namespace
}  // namespace fillrule::view
