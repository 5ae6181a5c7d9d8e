#include "harness/report/diagnosis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "harness/explain/explain.h"
#include "harness/report/html_case.h"
#include "harness/report/test_drawing.h"

namespace fillrule::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

template <typename Spoil>
Diagnosis diagnosis_of(const Case& test_case, const Spoil& spoil) {
  return html_case(test_case, {}, drawing_of(test_case, spoil), {.candidate = "c", .reference = "r"}).diagnosis;
}

TEST(Diagnosis, NothingIsWrong) {
  const Diagnosis diagnosis = diagnosis_of(small_case(), [](Planes&) {});
  EXPECT_EQ(diagnosis.main, SampleClass::kRight);
  EXPECT_EQ(diagnosis.sentence, "");
}

TEST(Diagnosis, APictureThatIsShifted) {
  const Diagnosis diagnosis = diagnosis_of(small_case(), [](Planes& planes) {
    std::rotate(planes.hits.begin(), planes.hits.end() - 1, planes.hits.end());
    std::rotate(planes.owner.begin(), planes.owner.end() - 1, planes.owner.end());
  });
  EXPECT_THAT(diagnosis.sentence, AllOf(HasSubstr("must be covered"), HasSubstr("shifted by a pixel to the right")));
}

TEST(Diagnosis, NothingIsDrawn) {
  const Diagnosis diagnosis =
      diagnosis_of(small_case(), [](Planes& planes) { planes = Planes::cleared(8, 8, 1, 2, 1.0F); });
  EXPECT_EQ(diagnosis.main, SampleClass::kMissing);
  EXPECT_THAT(diagnosis.sentence, HasSubstr("it draws nothing at all"));
}

TEST(Diagnosis, AVaryingThatIsInterpolatedInAnotherWay) {
  Case affine = small_case();
  affine.varyings[0].interpolation = Interpolation::kNoperspective;
  const Diagnosis diagnosis = diagnosis_of(
      small_case(), [&](Planes& planes) { planes.varyings = drawing_of(affine, [](Planes&) {}).candidate.varyings; });
  EXPECT_EQ(diagnosis.main, SampleClass::kVarying);
  EXPECT_THAT(diagnosis.sentence, HasSubstr("uv.x is interpolated without perspective correction"));
}

TEST(Diagnosis, ComponentsThatAreExchanged) {
  const Diagnosis diagnosis =
      diagnosis_of(small_case(), [](Planes& planes) { std::swap(planes.varyings[0], planes.varyings[1]); });
  EXPECT_THAT(diagnosis.sentence, HasSubstr("uv.x is what uv.y should hold"));
}

TEST(Diagnosis, ValuesThatAreNoNumbers) {
  const Diagnosis diagnosis = diagnosis_of(small_case(), [](Planes& planes) {
    std::ranges::fill(planes.varyings[1], std::numeric_limits<float>::quiet_NaN());
  });
  EXPECT_THAT(diagnosis.sentence, HasSubstr("uv.y is not a finite number there"));
}

// The case with another state drawn instead.
template <typename Change>
Diagnosis diagnosis_of_other(const Case& test_case, const Change& change) {
  Case other = test_case;
  change(other);
  return diagnosis_of(test_case, [&](Planes& planes) { planes = drawing_of(other, [](Planes&) {}).candidate; });
}

Case biased_case() {
  Case biased = small_case();
  biased.draws[0].state.depth_bias = DepthBias{.constant_factor = 0x1p17F, .slope_factor = 2};
  return biased;
}

TEST(Diagnosis, ADepthBiasThatIsMissing) {
  const Diagnosis diagnosis =
      diagnosis_of_other(biased_case(), [](Case& other) { other.draws[0].state.depth_bias.reset(); });
  EXPECT_EQ(diagnosis.main, SampleClass::kDepth);
  EXPECT_THAT(diagnosis.sentence, HasSubstr("depth is what is right before the depth bias is added"));
}

TEST(Diagnosis, ADepthBiasWithoutItsSlope) {
  const Diagnosis diagnosis =
      diagnosis_of_other(biased_case(), [](Case& other) { other.draws[0].state.depth_bias->slope_factor = 0; });
  EXPECT_THAT(diagnosis.sentence, HasSubstr("points to the depth bias"));
}

TEST(Diagnosis, ADepthBiasThatIsSubtracted) {
  const Diagnosis diagnosis = diagnosis_of_other(biased_case(), [](Case& other) {
    DepthBias& bias = *other.draws[0].state.depth_bias;
    bias.constant_factor = -bias.constant_factor;
    bias.slope_factor = -bias.slope_factor;
  });
  EXPECT_THAT(diagnosis.sentence, HasSubstr("with the depth bias subtracted"));
}

TEST(Diagnosis, ADepthThatIsOffUnderABiasIsNotCalledPerspective) {
  const Diagnosis diagnosis = diagnosis_of(biased_case(), [](Planes& planes) {
    for (size_t i = 0; i < planes.depth.size(); ++i) {
      if (planes.hits[i] != 0) planes.depth[i] += 0.125F;
    }
  });
  EXPECT_THAT(diagnosis.sentence, Not(HasSubstr("perspective correction")));
  EXPECT_THAT(diagnosis.sentence, HasSubstr("off by the same amount"));
}

TEST(Diagnosis, ADepthTestThatLetsThroughWhatMustFail) {
  Case behind = small_case();
  behind.target.clear_depth = 0.25F;
  behind.draws[0].state.depth_compare = VK_COMPARE_OP_LESS;
  const Diagnosis diagnosis =
      diagnosis_of_other(behind, [](Case& other) { other.draws[0].state.depth_compare = VK_COMPARE_OP_GREATER; });
  EXPECT_EQ(diagnosis.main, SampleClass::kExtra);
  EXPECT_THAT(diagnosis.sentence, HasSubstr("fail the depth test"));
}

TEST(Diagnosis, APointOfAnotherSize) {
  Case point = small_case();
  point.varyings.clear();
  point.draws[0].topology = VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
  point.draws[0].positions = {{0, 0, 0.5F, 1}};
  point.draws[0].varyings.clear();
  point.draws[0].point_sizes = {2};
  const Diagnosis diagnosis = diagnosis_of_other(point, [](Case& other) { other.draws[0].point_sizes = {4}; });
  EXPECT_THAT(diagnosis.sentence, HasSubstr("the size of the points"));
}

TEST(Diagnosis, TheReferenceIsToldOfOnlyIfTheCandidateIsRight) {
  const Case test_case = small_case();
  run::Drawing drawing = drawing_of(test_case, [](Planes&) {});
  std::ranges::fill(drawing.reference->depth, 0.5F);
  drawing.verdict = drawing_of(test_case, [](Planes& planes) { std::ranges::fill(planes.depth, 0.5F); }).verdict;
  for (judge::PlaneVerdict& plane : drawing.verdict.planes) {
    for (judge::Verdict& one : plane.map) {
      if (one == judge::Verdict::kCandidateFault) one = judge::Verdict::kReferenceFault;
    }
    std::swap(plane.counts[static_cast<size_t>(judge::Verdict::kCandidateFault)],
              plane.counts[static_cast<size_t>(judge::Verdict::kReferenceFault)]);
  }
  const Diagnosis diagnosis = html_case(test_case, {}, drawing, {}).diagnosis;
  EXPECT_TRUE(diagnosis.of_reference);
  EXPECT_THAT(diagnosis.sentence, HasSubstr("The reference stores a wrong depth"));
}

}  // namespace
}  // namespace fillrule::report
