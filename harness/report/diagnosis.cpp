#include "harness/report/diagnosis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/report/coverage_pattern.h"
#include "harness/report/value_pattern.h"
#include "harness/run/counted.h"

namespace fillrule::report {
namespace {

using judge::PlaneKind;
using judge::PlaneVerdict;

// The varying that is wrong at most of the samples of that class.
const PlaneVerdict* main_varying(const run::Drawing& drawing, bool reference) {
  const PlaneVerdict* most = nullptr;
  const auto faults = [reference](const PlaneVerdict& plane) {
    return reference ? plane.reference_faults() : plane.candidate_faults();
  };
  for (const PlaneVerdict& plane : drawing.verdict.planes) {
    if (plane.kind == PlaneKind::kVarying && (most == nullptr || faults(plane) > faults(*most))) most = &plane;
  }
  return most;
}

std::string what(SampleClass main, uint64_t count, const std::string& varying) {
  const std::string samples = run::counted(count, "sample");
  switch (main) {
    case SampleClass::kMissing:
      return fmt::format("leaves out {} that must be covered", samples);
    case SampleClass::kExtra:
      return fmt::format("covers {} that must not be covered", samples);
    case SampleClass::kOwner:
      return fmt::format("shows the wrong primitive at {}", samples);
    case SampleClass::kHits:
      return fmt::format("lands a wrong number of fragments at {}", samples);
    case SampleClass::kFacing:
      return fmt::format("takes front for back or back for front at {}", samples);
    case SampleClass::kDepth:
      return fmt::format("stores a wrong depth at {}", samples);
    case SampleClass::kVarying:
      return fmt::format("gives a wrong value to the varying {} at {}", varying, samples);
    default:
      return fmt::format("is imprecise at {}", samples);
  }
}

class Diagnoser {
 public:
  Diagnoser(const Case& test_case, const run::Drawing& drawing, std::span<const SampleMark> marks,
            std::span<const explain::Explanation> explanations)
      : case_(test_case), drawing_(drawing), marks_(marks), explanations_(explanations) {}

  Diagnosis run() {
    result_.of_reference = drawing_.verdict.candidate_faults() == 0 && drawing_.verdict.reference_faults() > 0;
    for (const SampleMark& mark : marks_) {
      const bool is_fault = mark.kind > SampleClass::kImprecise;
      if (!is_fault || mark.reference_alone == result_.of_reference) ++result_.counts[static_cast<size_t>(mark.kind)];
    }
    result_.main = gravest();
    if (result_.main == SampleClass::kRight) return result_;
    result_.sentence = sentence();
    return result_;
  }

 private:
  [[nodiscard]] uint64_t count(SampleClass of) const {
    return of == SampleClass::kRight ? 0 : result_.counts[static_cast<size_t>(of)];
  }

  // The class that the others follow from: what is not there has no depth. Of missing and extra samples, of hits and
  // owners whatever there is more of.
  [[nodiscard]] SampleClass gravest() const {
    using enum SampleClass;
    if (count(kMissing) + count(kExtra) > 0) return count(kMissing) >= count(kExtra) ? kMissing : kExtra;
    // Another owner's fragments may be more or fewer, too: it is the owner that tells what went wrong.
    if (owner_faults() > 0 && owner_faults() >= count(kHits) / 2) return kOwner;
    for (const SampleClass one : {kHits, kFacing, kDepth, kVarying}) {
      if (count(one) > 0) return one;
    }
    return kRight;
  }

  [[nodiscard]] uint64_t samples_of_main() const {
    return result_.main == SampleClass::kOwner ? owner_faults() : count(result_.main);
  }

  [[nodiscard]] uint64_t owner_faults() const {
    uint64_t faults = 0;
    for (const PlaneVerdict& plane : drawing_.verdict.planes) {
      if (plane.kind != PlaneKind::kOwner) continue;
      faults += result_.of_reference ? plane.reference_faults() : plane.candidate_faults();
    }
    return faults;
  }

  [[nodiscard]] std::string sentence() const {
    const PlaneVerdict* const varying = main_varying(drawing_, result_.of_reference);
    const std::string name = varying != nullptr ? varying->name : "";
    std::string text = fmt::format("The {} {}", result_.of_reference ? "reference" : "candidate",
                                   what(result_.main, samples_of_main(), name));
    const bool is_missing = result_.main == SampleClass::kMissing;
    const SampleClass other = is_missing ? SampleClass::kExtra : SampleClass::kMissing;
    if ((is_missing || result_.main == SampleClass::kExtra) && count(other) > 0) {
      text += fmt::format(", and {}", what(other, count(other), name));
    }
    const std::string pattern = pattern_text(varying);
    return text + (pattern.empty() ? "." : fmt::format(": {}.", pattern)) + rest_text();
  }

  // The other classes of fault, those that are graver than depth left aside, as they belong to the main one.
  [[nodiscard]] std::string rest_text() const {
    using enum SampleClass;
    std::string text;
    for (const SampleClass one : {kFacing, kDepth, kVarying}) {
      if (one == result_.main || count(one) == 0) continue;
      text += fmt::format("{} {} at {}", text.empty() ? " Wrong besides:" : ",", name_of(one),
                          run::counted(count(one), "sample"));
    }
    return text.empty() ? text : text + ".";
  }

  [[nodiscard]] std::string pattern_text(const PlaneVerdict* varying) const {
    switch (result_.main) {
      case SampleClass::kMissing:
      case SampleClass::kExtra:
        return coverage_pattern(case_, drawing_, result_.of_reference, marks_, explanations_);
      case SampleClass::kOwner:
        return owner_pattern();
      case SampleClass::kHits:
        return hits_pattern();
      case SampleClass::kDepth:
        return value_text("depth");
      case SampleClass::kVarying:
        return varying_text(*varying);
      default:
        return "";
    }
  }

  [[nodiscard]] std::string owner_pattern() const {
    if (std::string text = displacement_of(drawing_, result_.of_reference); !text.empty()) return text;
    if (shows_culled_ones()) return "the primitives that it shows are culled: culling the wrong way round";
    return depth_tested() ? "it is the other one that the depth test lets through"
                          : "primitives are to land in the order in which they are submitted";
  }

  // At all samples that were looked into.
  [[nodiscard]] bool shows_culled_ones() const {
    return std::ranges::all_of(explanations_, [this](const explain::Explanation& one) {
      if (one.parties.size() <= party()) return false;
      const explain::PartyFacts& facts = one.parties[party()];
      const auto& primitives = one.views[facts.view].primitives;
      const auto shown = std::ranges::find(primitives, facts.owner, &explain::PrimitiveFacts::number);
      return shown != primitives.end() && shown->exclusion == explain::Exclusion::kCulledByFacing;
    });
  }

  [[nodiscard]] bool depth_tested() const {
    return std::ranges::any_of(case_.draws, [](const Draw& draw) { return draw.state.depth_test; });
  }

  [[nodiscard]] size_t party() const { return result_.of_reference ? 1 : 0; }

  [[nodiscard]] std::string hits_pattern() const {
    bool more = false;
    bool fewer = false;
    for (const explain::Explanation& one : explanations_) {
      if (one.parties.size() <= party()) continue;
      const explain::PartyFacts& facts = one.parties[party()];
      more = more || facts.hits > one.views[facts.view].possible.most_hits;
      fewer = fewer || facts.hits < one.views[facts.view].possible.least_hits;
    }
    if (more && !fewer) return "more than are right, as where a shared edge is hit twice or a test does not reject";
    if (fewer && !more) return "fewer than are right, as where a test rejects too much";
    return "";
  }

  // What the wrong values of that name have in common.
  [[nodiscard]] std::string value_text(const std::string& name) const {
    std::vector<WrongValue> wrong;
    bool finite = true;
    bool equal = true;
    float first = 0;
    for (const explain::Explanation& one : explanations_) {
      if (one.parties.size() <= party()) continue;
      for (const explain::Value& value : one.parties[party()].values) {
        if (value.name != name || !value.standing.outside()) continue;
        if (wrong.empty()) first = value.value;
        finite = finite && std::isfinite(value.value);
        equal = equal && value.value == first;
        wrong.push_back({.explanation = &one, .party = party()});
      }
    }
    if (wrong.empty()) return "";
    if (!finite) return fmt::format("{} is not a finite number there", name);
    if (const auto pattern = pattern_of(case_, name, wrong)) return fmt::format("{} is {}", name, *pattern);
    if (equal && wrong.size() > 2) {
      const bool cleared = name == "depth" && first == case_.target.clear_depth;
      return cleared ? "it is the clear value, as if nothing had been written"
                     : fmt::format("{} is {:.9g} at all that were looked into", name, first);
    }
    return "";
  }

  // Of the first component of which something can be said.
  [[nodiscard]] std::string varying_text(const PlaneVerdict& plane) const {
    for (uint32_t c = 0; c < plane.components; ++c) {
      const std::string name = plane.components == 1 ? plane.name : fmt::format("{}.{}", plane.name, "xyzw"[c]);
      if (std::string text = value_text(name); !text.empty()) return text;
    }
    return "";
  }

  const Case& case_;
  const run::Drawing& drawing_;
  std::span<const SampleMark> marks_;
  std::span<const explain::Explanation> explanations_;
  Diagnosis result_;
};

}  // namespace

Diagnosis diagnose(const Case& test_case, const run::Drawing& drawing, std::span<const SampleMark> marks,
                   std::span<const explain::Explanation> explanations) {
  return Diagnoser(test_case, drawing, marks, explanations).run();
}

}  // namespace fillrule::report
