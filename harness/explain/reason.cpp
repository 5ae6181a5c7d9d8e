// The one plain sentence: what is wrong at the sample and how far, or why nothing is.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "harness/explain/internal.h"

namespace fillrule::explain {
namespace {

using exact::Coverage;
using judge::PlaneKind;
using judge::Verdict;

const PrimitiveFacts* find_primitive(const View& view, uint32_t number) {
  const auto found = std::ranges::find(view.primitives, number, &PrimitiveFacts::number);
  return found == view.primitives.end() ? nullptr : &*found;
}

std::string owner_text(uint32_t owner) {
  return owner == kNoOwner ? "none" : fmt::format("primitive {}", owner);
}

// "0.31 subpixels inside edge v1-v2 of primitive 0"
std::string place_text(const PrimitiveFacts& primitive, const Boundary& boundary) {
  if (boundary.value == 0) return fmt::format("exactly on {} of primitive {}", boundary.name, primitive.number);
  return fmt::format("{} {} {} of primitive {}", subpixels(std::abs(boundary.distance)),
                     boundary.distance < 0 ? "outside" : "inside", boundary.name, primitive.number);
}

// Why a sample that is within what rounding may do is a fault all the same.
constexpr std::string_view kStricter =
    "within what rounding may do, but a shared edge or the profile leaves no choice";

std::string extra_sample(const View& view, const PartyFacts& party) {
  const PrimitiveFacts* const primitive = find_primitive(view, party.owner);
  if (primitive == nullptr) return fmt::format("The {} shows a primitive that is not in the case", party.role);
  if (primitive->culled && !primitive->facing_in_doubt) {
    return fmt::format("The {} draws primitive {}, which is culled", party.role, primitive->number);
  }
  if (primitive->scissored) {
    return fmt::format("The {} draws primitive {} outside of the scissor", party.role, primitive->number);
  }
  const Boundary* const boundary = primitive->deciding();
  if (boundary == nullptr || primitive->coverage.coverage == Coverage::kMust) {
    return fmt::format("The {} draws primitive {} where it fails the depth test", party.role, primitive->number);
  }
  std::string text = fmt::format("The {} covers a sample {}", party.role, place_text(*primitive, *boundary));
  if (primitive->coverage.coverage == Coverage::kMay) text += fmt::format(", {}", kStricter);
  return text;
}

std::string lost_sample(const View& view, const PartyFacts& party) {
  const auto owner = std::ranges::find_if(view.possible.outcomes,
                                          [](const judge::Outcome& outcome) { return outcome.owner != kNoOwner; });
  const PrimitiveFacts* const primitive =
      owner == view.possible.outcomes.end() ? nullptr : find_primitive(view, owner->owner);
  const Boundary* const boundary = primitive == nullptr ? nullptr : primitive->deciding();
  if (boundary == nullptr) return fmt::format("The {} leaves out a sample that must be covered", party.role);
  std::string text = fmt::format("The {} leaves out a sample {}", party.role, place_text(*primitive, *boundary));
  if (primitive->coverage.coverage == Coverage::kMay) text += fmt::format(", {}", kStricter);
  return text;
}

std::string times(uint32_t hits) {
  return hits == 1 ? "once" : fmt::format("{} times", hits);
}

std::string wrong_hits(const View& view, const PartyFacts& party) {
  const auto [least, most] = std::pair(view.possible.least_hits, view.possible.most_hits);
  const std::string right = least == most ? times(least) : fmt::format("{} to {} times", least, most);
  return fmt::format("The {} hits the sample {} where {} is right", party.role, times(party.hits), right);
}

std::string wrong_owner(const View& view, const PartyFacts& party) {
  std::string right;
  for (const judge::Outcome& outcome : view.possible.outcomes) {
    const std::string text = owner_text(outcome.owner);
    if (right.find(text) == std::string::npos) right += (right.empty() ? "" : " or ") + text;
  }
  return fmt::format("The {} shows {} where {} is right", party.role, owner_text(party.owner), right);
}

std::string wrong_value(const PartyFacts& party, const PlaneFacts& plane) {
  // The worst component of the plane.
  const Value* worst = nullptr;
  for (const Value& value : party.values) {
    const bool belongs = value.name == plane.name || value.name.starts_with(plane.name + ".");
    if (belongs &&
        (worst == nullptr || value.standing.level > worst->standing.level ||
         (value.standing.level == worst->standing.level && value.standing.severity > worst->standing.severity))) {
      worst = &value;
    }
  }
  if (worst == nullptr) return fmt::format("The {}'s {} is wrong", party.role, plane.name);
  std::string text = fmt::format("The {}'s {} is {:.9g}", party.role, worst->name, worst->value);
  const judge::Standing& standing = worst->standing;
  if (std::isnan(standing.expected)) return text + ", which no finite input can give";
  if (std::isfinite(standing.severity)) text += fmt::format(", {:.3g} tolerances", standing.severity);
  return text +
         fmt::format("{} from the exact {:.9g}", std::isfinite(standing.severity) ? "" : ", far", standing.expected);
}

std::string wrong_facing(const PartyFacts& party) {
  return fmt::format("The {} takes primitive {} for {}-facing", party.role, party.owner,
                     party.front_facing ? "front" : "back");
}

std::string fault_text(const Explanation& explanation, const PlaneFacts& plane) {
  // Of an imprecise value the side that is further off.
  size_t side = plane.verdict == Verdict::kReferenceFault ? 1 : 0;
  if (plane.verdict == Verdict::kImprecise && explanation.parties.size() > 1) {
    const auto is_imprecise = [](const Value& value) {
      return value.standing.level == judge::Standing::Class::kImprecise;
    };
    side = std::ranges::any_of(explanation.parties[0].values, is_imprecise) ? 0 : 1;
  }
  const PartyFacts& party = explanation.parties[side];
  const View& view = explanation.views[party.view];
  switch (plane.kind) {
    case PlaneKind::kCoverage:
      return party.hits > 0 ? extra_sample(view, party) : lost_sample(view, party);
    case PlaneKind::kHits:
      return wrong_hits(view, party);
    case PlaneKind::kOwner:
      return wrong_owner(view, party);
    case PlaneKind::kFrontFacing:
      return wrong_facing(party);
    case PlaneKind::kDepth:
    case PlaneKind::kVarying:
      return wrong_value(party, plane);
  }
  return {};
}

// The line nearest to a sample of which that line leaves open whether it is covered.
const Boundary* doubtful_boundary(const PrimitiveFacts& primitive) {
  const Boundary* nearest = nullptr;
  for (const Boundary& boundary : primitive.boundaries) {
    if (boundary.answer != Coverage::kMay) continue;
    if (nearest == nullptr || std::abs(boundary.distance) < std::abs(nearest->distance)) nearest = &boundary;
  }
  return nearest;
}

std::string doubt_text(const View& view) {
  for (const PrimitiveFacts& primitive : view.primitives) {
    if (primitive.undefined && primitive.coverage.coverage == Coverage::kMay) {
      return fmt::format("Vulkan leaves primitive {} undefined: whatever it does here is nobody's fault.",
                         primitive.number);
    }
  }
  for (const PrimitiveFacts& primitive : view.primitives) {
    if (primitive.coverage.coverage != Coverage::kMay) continue;
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

std::string certain_text(const Explanation& explanation) {
  const View& view = explanation.views.front();
  const auto covers = [](const PrimitiveFacts& primitive) {
    return primitive.coverage.coverage == Coverage::kMust && !primitive.culled && !primitive.scissored;
  };
  const uint32_t owner = view.possible.outcomes.front().owner;
  if (owner == kNoOwner) {
    const auto behind = std::ranges::find_if(view.primitives, covers);
    if (behind != view.primitives.end()) {
      return fmt::format("Primitive {} covers the sample and fails the depth test.", behind->number);
    }
    const PrimitiveFacts* nearest = nullptr;
    for (const PrimitiveFacts& primitive : view.primitives) {
      if (primitive.deciding() == nullptr || primitive.culled || primitive.scissored) continue;
      if (nearest == nullptr || primitive.deciding()->distance > nearest->deciding()->distance) nearest = &primitive;
    }
    if (nearest == nullptr) return "No primitive that is drawn comes within a pixel of the sample.";
    return fmt::format("No primitive may cover the sample, which lies {}.",
                       place_text(*nearest, *nearest->deciding()));
  }
  const bool identical = std::ranges::all_of(
      explanation.planes, [](const PlaneFacts& plane) { return plane.verdict == Verdict::kIdentical; });
  const char* const rest = identical ? "every plane is identical" : "what differs is within its tolerance";
  const PrimitiveFacts* const primitive = find_primitive(view, owner);
  const Boundary* const boundary = primitive == nullptr ? nullptr : primitive->deciding();
  if (boundary == nullptr) return fmt::format("Primitive {} lands here last; {}.", owner, rest);
  return fmt::format("The sample lies {}, which must cover it; {}.", place_text(*primitive, *boundary), rest);
}

}  // namespace

std::string subpixels(double distance) {
  const std::string number = std::abs(distance) >= 1e6   ? fmt::format("{:.3g}", distance)
                             : std::abs(distance) >= 100 ? fmt::format("{:.0f}", distance)
                                                         : fmt::format("{:.3g}", distance);
  return number + (number == "1" ? " subpixel" : " subpixels");
}

std::string reason_of(const Explanation& explanation) {
  const auto gravest = std::ranges::max_element(explanation.planes, {}, &PlaneFacts::verdict);
  if (gravest != explanation.planes.end() && gravest->verdict >= Verdict::kImprecise) {
    return fmt::format("{}: {}.", fault_text(explanation, *gravest), word_for(gravest->verdict));
  }
  const View& view = explanation.views.front();
  return view.possible.in_doubt ? doubt_text(view) : certain_text(explanation);
}

}  // namespace fillrule::explain
