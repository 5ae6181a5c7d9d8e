#include "harness/report/sample_class.h"

#include <gtest/gtest.h>

namespace fillrule::report {
namespace {

using judge::PlaneKind;
using judge::Verdict;

// One sample with these verdicts; whether the candidate and the reference cover it.
SampleMark mark(const std::vector<std::pair<PlaneKind, Verdict>>& verdicts, bool candidate_covers = true,
                bool reference_covers = true) {
  run::Drawing drawing{.candidate = Planes::cleared(1, 1, 1, 0, 1), .reference = Planes::cleared(1, 1, 1, 0, 1)};
  drawing.candidate.hits[0] = candidate_covers ? 1 : 0;
  drawing.reference->hits[0] = reference_covers ? 1 : 0;
  for (const auto& [kind, verdict] : verdicts) drawing.verdict.planes.push_back({.kind = kind, .map = {verdict}});
  return mark_of(drawing, 0);
}

TEST(SampleClass, ALetterForEachKindOfFault) {
  EXPECT_EQ(mark({}).letter(), '#');
  EXPECT_EQ(mark({}, false).letter(), '.');
  EXPECT_EQ(mark({{PlaneKind::kDepth, Verdict::kPermitted}}).letter(), '~');
  EXPECT_EQ(mark({{PlaneKind::kDepth, Verdict::kImprecise}}).letter(), 'I');
  EXPECT_EQ(mark({{PlaneKind::kVarying, Verdict::kCandidateFault}}).letter(), 'V');
  EXPECT_EQ(mark({{PlaneKind::kDepth, Verdict::kBothFault}}).letter(), 'D');
  EXPECT_EQ(mark({{PlaneKind::kFrontFacing, Verdict::kCandidateFault}}).letter(), 'F');
  EXPECT_EQ(mark({{PlaneKind::kOwner, Verdict::kCandidateFault}}).letter(), 'O');
  EXPECT_EQ(mark({{PlaneKind::kHits, Verdict::kCandidateFault}}).letter(), 'H');
  EXPECT_EQ(mark({{PlaneKind::kCoverage, Verdict::kCandidateFault}}, true, false).letter(), 'E');
  EXPECT_EQ(mark({{PlaneKind::kCoverage, Verdict::kCandidateFault}}, false, true).letter(), 'M');
}

TEST(SampleClass, ItIsTheReferenceThatMissesWhereItAloneIsAtFault) {
  const SampleMark missing = mark({{PlaneKind::kCoverage, Verdict::kReferenceFault}}, true, false);
  EXPECT_EQ(missing.letter(), 'm');
  EXPECT_TRUE(missing.reference_alone);
  EXPECT_EQ(mark({{PlaneKind::kCoverage, Verdict::kReferenceFault}}, false, true).letter(), 'e');
}

TEST(SampleClass, TheGravestPlaneCountsAndTheCandidateFirst) {
  EXPECT_EQ(mark({{PlaneKind::kCoverage, Verdict::kReferenceFault}, {PlaneKind::kDepth, Verdict::kCandidateFault}},
                 true, false)
                .letter(),
            'D');
  EXPECT_EQ(
      mark({{PlaneKind::kVarying, Verdict::kCandidateFault}, {PlaneKind::kOwner, Verdict::kCandidateFault}}).letter(),
      'O');
  EXPECT_EQ(mark({{PlaneKind::kVarying, Verdict::kImprecise}, {PlaneKind::kOwner, Verdict::kPermitted}}).letter(),
            'I');
  EXPECT_EQ(
      mark({{PlaneKind::kVarying, Verdict::kImprecise}, {PlaneKind::kOwner, Verdict::kReferenceFault}}).letter(),
      'o');
}

}  // namespace
}  // namespace fillrule::report
