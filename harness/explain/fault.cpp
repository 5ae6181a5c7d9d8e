// What is wrong at a sample, and how far.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "harness/explain/internal.h"

namespace fillrule::explain {
namespace {

using exact::Coverage;
using judge::PlaneKind;
using judge::Verdict;

std::string owner_text(uint32_t owner) {
  return owner == kNoOwner ? "none" : fmt::format("primitive {}", owner);
}

// Why a sample that is within what rounding may do is a fault all the same.
std::string stricter_text(const PrimitiveFacts& primitive) {
  if (!primitive.bresenham) return ", within what rounding may do, but a shared edge or the profile leaves no choice";
  if (primitive.bresenham->diamond_exit) {
    return fmt::format(", where the diamond-exit rule makes {}",
                       *primitive.bresenham->diamond_exit ? "a fragment" : "none");
  }
  return ", where the rules for the line as a whole leave no choice";
}

std::string extra_sample(const View& view, const PartyFacts& party) {
  const PrimitiveFacts* const primitive = find_primitive(view, party.owner);
  if (primitive == nullptr) return fmt::format("The {} shows a primitive that is not in the case", party.role);
  if (primitive->exclusion != Exclusion::kNone) {
    return fmt::format("The {} {}", party.role, excluded_text(*primitive));
  }
  const Boundary* const boundary = primitive->deciding();
  if (primitive->answer == Coverage::kMust) {
    return fmt::format("The {} draws {} where it fails the depth test", party.role, name_of(*primitive));
  }
  if (boundary == nullptr) return fmt::format("The {} draws {}, which is not there", party.role, name_of(*primitive));
  if (primitive->bresenham && primitive->answer == Coverage::kMay) {
    return fmt::format("The {} makes a fragment of {}{}", party.role, name_of(*primitive), stricter_text(*primitive));
  }
  std::string text = fmt::format("The {} covers a sample {}", party.role, place_text(*primitive, *boundary));
  return primitive->answer == Coverage::kMay ? text + stricter_text(*primitive) : text;
}

std::string lost_sample(const View& view, const PartyFacts& party) {
  // The rules for lines as a whole are asked apart from the possible outcomes.
  const auto is_right = [&](const PrimitiveFacts& primitive) {
    return std::ranges::find(view.possible.outcomes, primitive.number, &judge::Outcome::owner) !=
           view.possible.outcomes.end();
  };
  const auto found = std::ranges::find_if(view.primitives, is_right);
  const PrimitiveFacts* const primitive =
      found == view.primitives.end() ? nullptr : find_primitive(view, found->number);
  const Boundary* const boundary = primitive == nullptr ? nullptr : primitive->deciding();
  if (boundary == nullptr) return fmt::format("The {} leaves out a sample that must be covered", party.role);
  if (primitive->bresenham) {
    return fmt::format("The {} leaves out a pixel of {}{}", party.role, name_of(*primitive),
                       stricter_text(*primitive));
  }
  std::string text = fmt::format("The {} leaves out a sample {}", party.role, place_text(*primitive, *boundary));
  return primitive->answer == Coverage::kMay ? text + stricter_text(*primitive) : text;
}

std::string times(uint32_t hits) {
  return hits == 1 ? "once" : fmt::format("{} times", hits);
}

// ", 0.2 subpixels inside edge v0-v1 of primitive 0, which primitive 1 shares": where rounding leaves open who covers
// the sample.
std::string doubt_place(const View& view) {
  std::string text;
  for (const PrimitiveFacts& primitive : view.primitives) {
    if (primitive.answer != Coverage::kMay) continue;
    const Boundary* const boundary = doubtful_boundary(primitive);
    if (boundary == nullptr) continue;
    if (!text.empty()) return fmt::format("{}, beside {}", text, name_of(primitive));
    text = ", " + place_text(primitive, *boundary);
  }
  return text;
}

std::string wrong_hits(const View& view, const PartyFacts& party) {
  const auto [least, most] = std::pair(view.possible.least_hits, view.possible.most_hits);
  const std::string right = least == most ? times(least) : fmt::format("{} to {} times", least, most);
  return fmt::format("The {} hits the sample {} where {} is right{}", party.role, times(party.hits), right,
                     doubt_place(view));
}

std::string wrong_owner(const View& view, const PartyFacts& party) {
  std::vector<uint32_t> owners;
  for (const judge::Outcome& outcome : view.possible.outcomes) {
    if (std::ranges::find(owners, outcome.owner) == owners.end()) owners.push_back(outcome.owner);
  }
  std::string right;
  for (const uint32_t owner : owners) right += (right.empty() ? "" : " or ") + owner_text(owner);
  std::string text = fmt::format("The {} shows {} where {} is right", party.role, owner_text(party.owner), right);
  const PrimitiveFacts* const shown = find_primitive(view, party.owner);
  if (shown == nullptr || owners.size() > 1) return text;
  if (shown->exclusion != Exclusion::kNone) return fmt::format("{}: it {}", text, excluded_text(*shown));
  if (shown->answer == Coverage::kMust) {
    return text +
           (owners.front() > party.owner ? ", which is drawn over it" : ", which the depth test keeps in front");
  }
  const Boundary* const boundary = shown->deciding();
  return boundary == nullptr ? text : fmt::format("{}; the sample lies {}", text, place_text(*shown, *boundary));
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
  // The sign of a NaN says nothing.
  const float value = std::isnan(worst->value) ? std::abs(worst->value) : worst->value;
  std::string text = fmt::format("The {}'s {} is {:.9g}", party.role, worst->name, value);
  const judge::Standing& standing = worst->standing;
  if (std::isnan(standing.expected)) return text + ", which no finite input can give";
  if (standing.tolerance == 0) return fmt::format("{} instead of exactly {:.9g}", text, standing.expected);
  if (std::isfinite(standing.severity)) text += fmt::format(", {:.3g} tolerances", standing.severity);
  return text +
         fmt::format("{} from the exact {:.9g}", std::isfinite(standing.severity) ? "" : ", far", standing.expected);
}

std::string wrong_facing(const View& view, const PartyFacts& party) {
  if (party.owner == kNoOwner) return fmt::format("The {} shows a facing where nothing landed", party.role);
  std::string text = fmt::format("The {} takes primitive {} for {}-facing", party.role, party.owner,
                                 party.front_facing ? "front" : "back");
  const PrimitiveFacts* const primitive = find_primitive(view, party.owner);
  if (primitive == nullptr) return text;
  const bool of_polygon = primitive->kind == exact::Piece::Kind::kTriangle || !primitive->polygon.empty();
  if (!of_polygon) return text + ", as lines and points never are";
  if (primitive->orientation == 0) return text;
  return fmt::format("{}, which is {} in the framebuffer and {}-facing", text,
                     primitive->orientation > 0 ? "clockwise" : "counter-clockwise",
                     primitive->front_facing ? "front" : "back");
}

}  // namespace

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
      return wrong_facing(view, party);
    case PlaneKind::kDepth:
    case PlaneKind::kVarying:
      return wrong_value(party, plane);
  }
  return {};
}

}  // namespace fillrule::explain
