#include "harness/report/sample_class.h"

#include <array>
#include <cctype>
#include <utility>

namespace fillrule::report {
namespace {

using judge::PlaneKind;
using judge::Verdict;

struct ClassWords {
  char letter;
  std::string_view name;
};
constexpr std::array<ClassWords, kSampleClassCount> kWords{{{'.', "right"},
                                                            {'~', "permitted"},
                                                            {'I', "imprecise"},
                                                            {'V', "varying"},
                                                            {'D', "depth"},
                                                            {'F', "facing"},
                                                            {'O', "wrong owner"},
                                                            {'H', "hits"},
                                                            {'E', "extra"},
                                                            {'M', "missing"}}};

bool is_fault(SampleClass kind) {
  return kind > SampleClass::kImprecise;
}

SampleClass fault_class(PlaneKind kind, bool covered) {
  switch (kind) {
    case PlaneKind::kCoverage:
      return covered ? SampleClass::kExtra : SampleClass::kMissing;
    case PlaneKind::kHits:
      return SampleClass::kHits;
    case PlaneKind::kOwner:
      return SampleClass::kOwner;
    case PlaneKind::kFrontFacing:
      return SampleClass::kFacing;
    case PlaneKind::kDepth:
      return SampleClass::kDepth;
    case PlaneKind::kVarying:
      return SampleClass::kVarying;
  }
  return SampleClass::kRight;
}

}  // namespace

bool SampleMark::graver_than(const SampleMark& other) const {
  const auto rank = [](const SampleMark& mark) {
    return std::pair(is_fault(mark.kind) && !mark.reference_alone, mark.kind);
  };
  return rank(*this) > rank(other);
}

char SampleMark::letter() const {
  const char letter = kWords[static_cast<size_t>(kind)].letter;
  if (kind == SampleClass::kRight) return covered ? '#' : '.';
  return reference_alone ? static_cast<char>(std::tolower(static_cast<unsigned char>(letter))) : letter;
}

std::string_view name_of(SampleClass kind) {
  return kWords[static_cast<size_t>(kind)].name;
}

SampleMark mark_of(const run::Drawing& drawing, size_t index) {
  SampleMark gravest{.covered = drawing.candidate.hits[index] != 0};
  for (const judge::PlaneVerdict& plane : drawing.verdict.planes) {
    const Verdict verdict = plane.map[index];
    SampleMark mark = gravest;
    mark.reference_alone = verdict == Verdict::kReferenceFault;
    if (verdict >= Verdict::kReferenceFault) {
      const Planes& at_fault = mark.reference_alone ? *drawing.reference : drawing.candidate;
      mark.kind = fault_class(plane.kind, at_fault.hits[index] != 0);
    } else {
      mark.kind = verdict == Verdict::kImprecise   ? SampleClass::kImprecise
                  : verdict == Verdict::kPermitted ? SampleClass::kPermitted
                                                   : SampleClass::kRight;
    }
    if (mark.graver_than(gravest)) gravest = mark;
  }
  return gravest;
}

}  // namespace fillrule::report
