#include "harness/view/model_control.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "harness/scene/matrices.h"

namespace fillrule::view {
namespace {

using Mode = ModelControl::Mode;
using Axis = ModelControl::Axis;

const glm::dvec3 kCentre{1, 0.5, -2};

// In worlds of either handedness; the first of two objects is moved.
class ModelControlTest : public ::testing::TestWithParam<Handedness> {
 protected:
  ModelControlTest() {
    const double z = GetParam() == Handedness::kLeft ? -6 : 6;
    scene_.camera = {.placement = LookAt{.eye = {1, 2, z}}, .handedness = GetParam()};
    scene_.projection = {.shape = PerspectiveProjection{}, .near = 1, .far = 20};
    scene_.state.viewport = {.width = 200, .height = 100, .maxDepth = 1};
    scene_.objects.resize(2);
    scene_.objects[0].transform = {Scale{{2, 2, 2}}, Translate{{1, 0.5, -2}}};
    lens_ = lens_of(scene_);
    models_.emplace(scene_);
  }

  // Where a point of the object, given as it was in the world, is now.
  [[nodiscard]] glm::dvec3 now(const glm::dvec3& world) const {
    Scene scene = scene_;
    models_->apply(scene);
    const glm::dmat4 before = scene::transform_matrix(scene_.objects[0].transform);
    const glm::dmat4 after = scene::transform_matrix(scene.objects[0].transform);
    return {after * glm::inverse(before) * glm::dvec4(world, 1)};
  }
  [[nodiscard]] glm::dvec2 centre_pixel() const { return lens_.project(kCentre); }

  Scene scene_;
  Lens lens_;
  std::optional<ModelControl> models_;
};

TEST_P(ModelControlTest, MovesWithTheMouse) {
  models_->begin(Mode::kMove, kCentre, lens_, {40, 40});
  models_->drag({45, 33});
  models_->drag({47, 37});
  const glm::dvec2 moved = lens_.project(now(kCentre)) - centre_pixel();
  EXPECT_NEAR(moved.x, 7, 1e-9);
  EXPECT_NEAR(moved.y, -3, 1e-9);
}

TEST_P(ModelControlTest, MovesAlongAnAxisAlone) {
  models_->begin(Mode::kMove, kCentre, lens_, {40, 40});
  models_->drag({45, 33});
  models_->constrain(Axis::kX);
  const glm::dvec3 moved = now(kCentre) - kCentre;
  EXPECT_GT(moved.x, 0.1) << "what was dragged before counts";
  EXPECT_EQ(moved.y, 0);
  EXPECT_EQ(moved.z, 0);
  models_->constrain(Axis::kY);
  EXPECT_EQ((now(kCentre) - kCentre).x, 0);
  EXPECT_GT((now(kCentre) - kCentre).y, 0.1);
  models_->constrain(Axis::kY);
  EXPECT_FALSE(models_->axis()) << "the same once more: freely";
}

TEST_P(ModelControlTest, NudgesByOneSubpixel) {
  models_->nudge(kCentre, lens_, {1, 0});
  EXPECT_NEAR(lens_.project(now(kCentre)).x - centre_pixel().x, 1.0 / 256, 1e-9);
  models_->nudge(kCentre, lens_, {-1, 256});
  const glm::dvec2 moved = lens_.project(now(kCentre)) - centre_pixel();
  EXPECT_NEAR(moved.x, 0, 1e-9);
  EXPECT_NEAR(moved.y, -1, 1e-9) << "upwards";
  Scene scene = scene_;
  models_->apply(scene);
  EXPECT_EQ(scene.objects[0].transform.size(), 2U) << "translations are joined";
}

TEST_P(ModelControlTest, StepsByArrows) {
  models_->begin(Mode::kMove, kCentre, lens_, {40, 40});
  models_->step({1, 0});
  EXPECT_NEAR(lens_.project(now(kCentre)).x - centre_pixel().x, 1.0 / 256, 1e-9);
  models_->begin(Mode::kRotate, kCentre, lens_, {40, 40});
  models_->constrain(Axis::kY);
  models_->step({30, 0});
  const double sign = GetParam() == Handedness::kLeft ? -1 : 1;
  const glm::dvec3 turned = now(kCentre + glm::dvec3(1, 0, 0)) - kCentre;
  EXPECT_NEAR(turned.x, std::cos(glm::radians(30.0)), 1e-9);
  EXPECT_NEAR(turned.z, -sign * 0.5, 1e-9) << "counter-clockwise, seen from the tip";
  models_->begin(Mode::kScale, kCentre, lens_, {40, 40});
  models_->step({2, 0});
  EXPECT_NEAR((now(kCentre + glm::dvec3(0, 1, 0)) - kCentre).y, 1.01 * 1.01, 1e-9);
}

TEST_P(ModelControlTest, RotatesWithTheMouseAboutItsCentre) {
  const glm::dvec2 centre = centre_pixel();
  models_->begin(Mode::kRotate, kCentre, lens_, centre + glm::dvec2(20, 0));
  models_->drag(centre + glm::dvec2(0, -20));  // a quarter, counter-clockwise
  EXPECT_NEAR(glm::distance(now(kCentre), kCentre), 0, 1e-9);
  EXPECT_NEAR(glm::distance(now(kCentre + lens_.right), kCentre + lens_.up), 0, 1e-9);
  // From behind, the picture turns with the mouse all the same.
  models_->begin(Mode::kRotate, kCentre, lens_, centre + glm::dvec2(20, 0));
  models_->constrain(Axis::kZ);
  models_->drag(centre + glm::dvec2(0, -20));
  EXPECT_GT(glm::dot(now(kCentre + lens_.right) - kCentre, lens_.up), 0.8);
}

TEST_P(ModelControlTest, ScalesWithTheDistanceFromItsCentre) {
  const glm::dvec2 centre = centre_pixel();
  models_->begin(Mode::kScale, kCentre, lens_, centre + glm::dvec2(10, 0));
  models_->drag(centre + glm::dvec2(0, 25));
  EXPECT_NEAR(now(kCentre + glm::dvec3(0, 0, 1)).z - kCentre.z, 2.5, 1e-9);
  models_->constrain(Axis::kX);
  EXPECT_NEAR(now(kCentre + glm::dvec3(1, 1, 0)).x - kCentre.x, 2.5, 1e-9);
  EXPECT_NEAR(now(kCentre + glm::dvec3(1, 1, 0)).y - kCentre.y, 1, 1e-9);
}

TEST_P(ModelControlTest, ConfirmsCancelsAndResets) {
  models_->begin(Mode::kMove, kCentre, lens_, {0, 0});
  models_->drag({10, 0});
  models_->cancel();
  EXPECT_EQ(now(kCentre), kCentre);
  models_->begin(Mode::kMove, kCentre, lens_, {0, 0});
  models_->drag({10, 0});
  const glm::dvec3 moved = now(kCentre);
  models_->confirm();
  EXPECT_EQ(models_->mode(), Mode::kNone);
  models_->drag({50, 50});
  EXPECT_NEAR(glm::distance(now(kCentre), moved), 0, 1e-12);
  EXPECT_GT(glm::distance(moved, kCentre), 0.1);
  models_->reset();
  EXPECT_EQ(now(kCentre), kCentre);
}

TEST_P(ModelControlTest, MovesTheObjectThatIsChosen) {
  models_->next_object();
  models_->nudge(kCentre, lens_, {100, 0});
  EXPECT_EQ(now(kCentre), kCentre);
  models_->next_object();
  EXPECT_EQ(models_->object(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Worlds, ModelControlTest, ::testing::Values(Handedness::kRight, Handedness::kLeft),
                         [](const auto& info) {
                           return info.param == Handedness::kLeft ? "left_handed" : "right_handed";
                         });

}  // namespace
}  // namespace fillrule::view
