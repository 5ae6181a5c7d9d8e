#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "harness/explain/explain.h"
#include "harness/explain/internal.h"

namespace fillrule::explain {
namespace {

using exact::Coverage;
using judge::Verdict;

std::string_view coverage_text(Coverage coverage) {
  switch (coverage) {
    case Coverage::kMust:
      return "must";
    case Coverage::kMay:
      return "may";
    case Coverage::kMustNot:
      return "must not";
  }
  return "";
}

std::string boundary_text(const Boundary& boundary) {
  std::string name = boundary.name;
  if (boundary.top) name += " (top)";
  if (boundary.left) name += " (left)";
  const auto& [a, b, c] = boundary.form;
  return fmt::format(
      "    {:<28}{:>+12.4g} subpixels, rounding {:.3g}: {:<8}  E = {:.6g} = {:.6g} dx {:+.6g} dy {:+.6g}\n", name,
      boundary.distance, boundary.latitude, coverage_text(boundary.answer), boundary.value, a, b, c);
}

std::string facing_text(const PrimitiveFacts& primitive) {
  if (primitive.orientation == 0) return "without area";
  return fmt::format("{}, {}-facing{}", primitive.orientation > 0 ? "clockwise" : "counter-clockwise",
                     primitive.front_facing ? "front" : "back",
                     primitive.facing_in_doubt ? " (rounding may turn it over)" : "");
}

std::string primitive_text(const PrimitiveFacts& primitive) {
  const auto& [v0, v1, v2] = primitive.vertices;
  std::string text = fmt::format("  primitive {} (draw {}, vertices {} {} {}): {}", primitive.number, primitive.draw,
                                 v0, v1, v2, facing_text(primitive));
  if (primitive.undefined) text += ", undefined";
  if (primitive.thin && !primitive.undefined) text += ", thinner than a subpixel";
  if (primitive.clipped) text += ", to be clipped";
  if (primitive.culled) text += ", culled";
  if (primitive.scissored) text += ", outside of the scissor";
  text += fmt::format("; {} cover the sample\n", coverage_text(primitive.coverage.coverage));
  for (const Boundary& boundary : primitive.boundaries) text += boundary_text(boundary);
  return text;
}

std::string owner_text(uint32_t owner) {
  return owner == kNoOwner ? "none" : fmt::format("{}", owner);
}

std::string possible_text(const judge::Possibilities& possible) {
  std::string text = possible.least_hits == possible.most_hits
                         ? fmt::format("  right: hits {}", possible.least_hits)
                         : fmt::format("  right: hits {} to {}", possible.least_hits, possible.most_hits);
  for (const judge::Outcome& outcome : possible.outcomes) {
    text += fmt::format(
        "; owner {}, {}", owner_text(outcome.owner),
        outcome.depth_writer == kNoOwner ? "the clear depth" : fmt::format("the depth of {}", outcome.depth_writer));
  }
  return text + "\n";
}

std::string value_text(const Value& value) {
  std::string text =
      fmt::format("  {:<16}{:>16.9g}  0x{:08x}", value.name, value.value, std::bit_cast<uint32_t>(value.value));
  const judge::Standing& standing = value.standing;
  if (std::isnan(standing.expected)) return text + "  not judged\n";
  text += fmt::format("  exact {:.12g}", standing.expected);
  if (!value.tolerance) {
    return text + (standing.outside()                  ? "  wrong\n"
                   : std::isfinite(standing.tolerance) ? "  right\n"
                                                       : "  not judged\n");
  }
  text += fmt::format(" +- {:.3g} (snapping {:.3g}, rounding {:.3g}); off by {:.3g} tolerances, {:.3g} ULP\n",
                      standing.tolerance, value.tolerance->snapping, value.tolerance->rounding, standing.severity,
                      value.ulps);
  return text;
}

std::string party_text(const PartyFacts& party, uint32_t subpixel_bits) {
  std::string text = fmt::format("{} {} ({} subpixel bits): hits {}, owner {}", party.role, party.name, subpixel_bits,
                                 party.hits, owner_text(party.owner));
  if (party.owner != kNoOwner) text += fmt::format(", {}-facing", party.front_facing ? "front" : "back");
  text += "\n";
  for (const Value& value : party.values) text += value_text(value);
  return text;
}

}  // namespace

std::string_view word_for(Verdict verdict) {
  switch (verdict) {
    case Verdict::kIdentical:
      return "identical";
    case Verdict::kPermitted:
      return "permitted";
    case Verdict::kImprecise:
      return "imprecise";
    case Verdict::kReferenceFault:
      return "reference fault";
    case Verdict::kCandidateFault:
      return "candidate fault";
    case Verdict::kBothFault:
      return "both at fault";
  }
  return "";
}

std::string to_text(const Explanation& explanation) {
  std::string text = fmt::format("{}, pixel {},{} sample {}, at ({}, {})\n", explanation.case_name, explanation.x,
                                 explanation.y, explanation.sample, explanation.position[0], explanation.position[1]);
  for (const View& view : explanation.views) {
    text += fmt::format("the oracle, for {} subpixel bits; dx, dy are pixels from the viewport's centre:\n",
                        view.subpixel_bits);
    for (const PrimitiveFacts& primitive : view.primitives) text += primitive_text(primitive);
    if (view.primitives.empty()) text += "  no primitive comes within a pixel\n";
    text += possible_text(view.possible);
  }
  for (const PartyFacts& party : explanation.parties) {
    text += party_text(party, explanation.views[party.view].subpixel_bits);
  }
  std::string_view separator = "verdicts: ";
  for (const PlaneFacts& plane : explanation.planes) {
    text += fmt::format("{}{} {}", separator, plane.name, word_for(plane.verdict));
    separator = ", ";
  }
  return text + "\n" + explanation.reason + "\n";
}

}  // namespace fillrule::explain
