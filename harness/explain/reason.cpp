// The one plain sentence: why nothing is wrong at the sample; fault.cpp says what is.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "harness/explain/internal.h"

namespace fillrule::explain {
namespace {

using exact::Coverage;
using judge::Verdict;

std::string doubt_text(const View& view) {
  const auto in_doubt = [](const PrimitiveFacts& primitive) { return primitive.answer == Coverage::kMay; };
  for (const PrimitiveFacts& primitive : view.primitives) {
    if (primitive.undefined && in_doubt(primitive)) {
      return fmt::format("Vulkan leaves {} undefined: whatever it does here is nobody's fault.", name_of(primitive));
    }
  }
  for (const PrimitiveFacts& primitive : view.primitives) {
    if (!in_doubt(primitive)) continue;
    if (primitive.open) return fmt::format("Whether {} is drawn at all is left open.", name_of(primitive));
    if (primitive.bresenham) {
      return fmt::format(
          "The sample is within a pixel of the fragments of {}: the rules for Bresenham lines leave "
          "open which pixels beside them are covered.",
          name_of(primitive));
    }
    const Boundary* const boundary = doubtful_boundary(primitive);
    if (boundary == nullptr) continue;
    const bool one_way = view.possible.least_hits == view.possible.most_hits;
    return fmt::format("The sample lies {}, which rounding may move by {}: {}.", place_text(primitive, *boundary),
                       subpixels(boundary->latitude),
                       one_way ? "whoever of the primitives at that edge covers it, exactly so many do"
                               : "both answers are permitted");
  }
  return "Whether the sample is covered is left open.";
}

std::string capitalised(std::string text) {
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

// Nothing lands, for certain.
std::string uncovered_text(const View& view) {
  const auto covers = [](const PrimitiveFacts& primitive) { return primitive.answer == Coverage::kMust; };
  const auto behind = std::ranges::find_if(view.primitives, covers);
  if (behind != view.primitives.end()) {
    return fmt::format("{} covers the sample and fails the depth test.", capitalised(name_of(*behind)));
  }
  const PrimitiveFacts* nearest = nullptr;
  for (const PrimitiveFacts& primitive : view.primitives) {
    if (primitive.deciding() == nullptr || primitive.exclusion != Exclusion::kNone) continue;
    if (nearest == nullptr || primitive.deciding()->distance > nearest->deciding()->distance) nearest = &primitive;
  }
  if (nearest != nullptr) {
    return fmt::format("No primitive may cover the sample, which lies {}.",
                       place_text(*nearest, *nearest->deciding()));
  }
  const auto is_excluded = [](const PrimitiveFacts& primitive) {
    return primitive.coverage.coverage != Coverage::kMustNot && primitive.exclusion != Exclusion::kNone;
  };
  const auto excluded = std::ranges::find_if(view.primitives, is_excluded);
  if (excluded == view.primitives.end()) return "No primitive that is drawn comes within a pixel of the sample.";
  return fmt::format("Nothing may cover the sample: whoever {} is wrong.", excluded_text(*excluded));
}

std::string certain_text(const Explanation& explanation) {
  const View& view = explanation.views.front();
  const uint32_t owner = view.possible.outcomes.front().owner;
  if (owner == kNoOwner) return uncovered_text(view);
  const bool identical = std::ranges::all_of(
      explanation.planes, [](const PlaneFacts& plane) { return plane.verdict == Verdict::kIdentical; });
  const char* const rest = identical ? "every plane is identical" : "what differs is within its tolerance";
  const PrimitiveFacts* const primitive = find_primitive(view, owner);
  const Boundary* const boundary = primitive == nullptr ? nullptr : primitive->deciding();
  if (boundary == nullptr) return fmt::format("Primitive {} lands here last; {}.", owner, rest);
  return fmt::format("The sample lies {}, which must cover it; {}.", place_text(*primitive, *boundary), rest);
}

}  // namespace

std::string reason_of(const Explanation& explanation) {
  const auto gravest = std::ranges::max_element(explanation.planes, {}, &PlaneFacts::verdict);
  if (gravest != explanation.planes.end() && gravest->verdict >= Verdict::kImprecise) {
    const char* const others = gravest->verdict == Verdict::kBothFault ? ", and the reference is wrong too" : "";
    return fmt::format("{}{}: {}.", fault_text(explanation, *gravest), others, word_for(gravest->verdict));
  }
  const View& view = explanation.views.front();
  return view.possible.in_doubt ? doubt_text(view) : certain_text(explanation);
}

}  // namespace fillrule::explain
