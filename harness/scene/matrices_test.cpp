#include "harness/scene/matrices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace fillrule::scene {
namespace {

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-12) << a.x << ' ' << a.y << ' ' << a.z;
}

glm::dvec3 point(const Transform& transform, const glm::dvec3& position) {
  return {transform_matrix(transform) * glm::dvec4(position, 1)};
}

Scene scene_with(const Projection& projection, Handedness handedness = Handedness::kRight) {
  Scene scene;
  scene.projection = projection;
  scene.camera.handedness = handedness;
  scene.state.viewport = {.width = 200, .height = 100, .maxDepth = 1};
  return scene;
}

// In normalized device coordinates, of a position in eye space.
glm::dvec3 projected(const Scene& scene, const glm::dvec3& position_eye) {
  const glm::dvec4 clip = projection_matrix(scene) * glm::dvec4(position_eye, 1);
  return glm::dvec3(clip) / clip.w;
}

TEST(Matrices, TurnCounterClockwise) {
  expect_near(point({Rotate{{1, 0, 0}, 90}}, {0, 1, 0}), {0, 0, 1});
  expect_near(point({Rotate{{0, 1, 0}, 90}}, {0, 0, 1}), {1, 0, 0});
  expect_near(point({Rotate{{0, 0, 1}, 90}}, {1, 0, 0}), {0, 1, 0});
  expect_near(point({Rotate{{1, 1, 1}, 120}}, {1, 0, 0}), {0, 1, 0});
}

TEST(Matrices, ApplyTheFirstStepFirst) {
  expect_near(point({Scale{{2, 3, 4}}, Translate{{1, 0, 0}}}, {1, 1, 1}), {3, 3, 4});
  expect_near(point({Translate{{1, 0, 0}}, Scale{{2, 3, 4}}}, {1, 1, 1}), {4, 3, 4});
  // RotateZ * RotateY * RotateX.
  expect_near(point({Rotate{{1, 0, 0}, 90}, Rotate{{0, 1, 0}, 90}, Rotate{{0, 0, 1}, 90}}, {0, 1, 0}), {0, 1, 0});
  expect_near(point({}, {1, 2, 3}), {1, 2, 3});
}

TEST(Matrices, MovePointsButNoDirections) {
  const glm::dmat4 matrix = transform_matrix({Translate{{5, 6, 7}}});
  EXPECT_EQ(glm::dvec3(matrix * glm::dvec4(1, 2, 3, 0)), glm::dvec3(1, 2, 3));
  EXPECT_EQ(glm::dvec3(matrix * glm::dvec4(1, 2, 3, 1)), glm::dvec3(6, 8, 10));
}

TEST(Matrices, LookFromTheEyeToTheTarget) {
  for (const Handedness handedness : {Handedness::kRight, Handedness::kLeft}) {
    const Camera camera{.placement = LookAt{.eye = {1, 2, 3}, .target = {1, 2, -7}}, .handedness = handedness};
    const double forwards = handedness == Handedness::kRight ? -1 : 1;
    const auto eye_space = [&](const glm::dvec3& world) {
      return glm::dvec3(view_matrix(camera) * glm::dvec4(world, 1));
    };
    expect_near(eye_space({1, 2, 3}), {0, 0, 0});
    expect_near(eye_space({1, 2, -7}), {0, 0, 10 * forwards});
    expect_near(eye_space({1, 5, 3}), {0, 3, 0});
    // The right-handed world's x is to the right; seen along -z, the left-handed one's is to the left.
    expect_near(eye_space({2, 2, 3}), {-forwards, 0, 0});
  }
}

TEST(Matrices, InvertTheCamerasOwnTransform) {
  const Camera looks{.placement = LookAt{.eye = {0, 0, 5}, .target = {0, 0, 0}}};
  const Camera stands{.placement = Transform{Translate{{0, 0, 5}}}};
  EXPECT_EQ(view_matrix(looks), view_matrix(stands));
  const Camera turned{.placement = Transform{Translate{{0, 0, 5}}, Rotate{{0, 1, 0}, 90}}};
  expect_near(glm::dvec3(view_matrix(turned) * glm::dvec4(5, 0, 0, 1)), {0, 0, 0});
}

TEST(Matrices, ProjectTheVolumeToTheCube) {
  for (const bool symmetric : {false, true}) {
    for (const Handedness handedness : {Handedness::kRight, Handedness::kLeft}) {
      const double forwards = handedness == Handedness::kRight ? -1 : 1;
      const double near_depth = symmetric ? -1 : 0;
      Scene scene = scene_with({FrustumProjection{-1, 3, -2, 5}, 2, 10}, handedness);
      scene.state.negative_one_to_one = symmetric;
      expect_near(projected(scene, {-1, -2, 2 * forwards}), {-1, 1, near_depth});
      expect_near(projected(scene, {3, 5, 2 * forwards}), {1, -1, near_depth});
      expect_near(projected(scene, {15, 25, 10 * forwards}), {1, -1, 1});
      scene.projection.shape = OrthographicProjection{-1, 3, -2, 5};
      expect_near(projected(scene, {-1, -2, 2 * forwards}), {-1, 1, near_depth});
      expect_near(projected(scene, {3, 5, 10 * forwards}), {1, -1, 1});
    }
  }
}

TEST(Matrices, KeepWAsTheDistance) {
  const Scene scene = scene_with({PerspectiveProjection{90, 1.0}, 1, 10});
  EXPECT_NEAR((projection_matrix(scene) * glm::dvec4(0, 0, -7, 1)).w, 7, 1e-12);
}

TEST(Matrices, TakeTheAspectOfTheViewport) {
  const Scene scene = scene_with({PerspectiveProjection{90, {}}, 1, 10});
  expect_near(projected(scene, {2, 1, -1}), {1, -1, 0});
  const Scene square = scene_with({PerspectiveProjection{90, 1.0}, 1, 10});
  expect_near(projected(square, {1, 1, -1}), {1, -1, 0});
}

TEST(Matrices, LeaveAViewportThatTurnsYOver) {
  Scene scene = scene_with({PerspectiveProjection{90, 1.0}, 1, 10});
  scene.state.viewport.height = -100;
  expect_near(projected(scene, {1, 1, -1}), {1, 1, 0});
}

TEST(Matrices, FindTheEye) {
  Scene scene;
  scene.camera.placement = LookAt{.eye = {1, 2, 3}, .target = {1, 2, 0}};
  EXPECT_EQ(eye_of(scene).w, 1);
  expect_near(glm::dvec3(eye_of(scene)), {1, 2, 3});
  scene.projection.shape = OrthographicProjection{};
  EXPECT_EQ(eye_of(scene).w, 0);
  expect_near(glm::dvec3(eye_of(scene)), {0, 0, 1});
  scene.camera.handedness = Handedness::kLeft;
  expect_near(glm::dvec3(eye_of(scene)), {0, 0, 1});
}

}  // namespace
}  // namespace fillrule::scene
