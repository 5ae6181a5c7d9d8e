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
