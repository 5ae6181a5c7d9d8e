#include <fmt/format.h>
#include <fmt/ranges.h>

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
  std::string text;
  if (primitive.kind == exact::Piece::Kind::kTriangle) {
    if (primitive.orientation == 0) return "without area";
    text = primitive.orientation > 0 ? "clockwise, " : "counter-clockwise, ";
  }
  return text + fmt::format("{}-facing{}", primitive.front_facing ? "front" : "back",
                            primitive.facing_in_doubt ? " (rounding may turn it over)" : "");
}

std::string_view exclusion_text(Exclusion exclusion) {
  switch (exclusion) {
    case Exclusion::kNone:
      return "";
    case Exclusion::kCulledByFacing:
      return ", culled";
    case Exclusion::kCulledByDistances:
      return ", dropped by its cull distances";
    case Exclusion::kOutsideVolume:
      return ", its vertex outside of the clip volume";
    case Exclusion::kScissored:
      return ", outside of the scissor";
    case Exclusion::kMasked:
      return ", taken away by the sample mask";
  }
  return "";
}

std::string bresenham_text(const BresenhamFacts& facts) {
  const char* const columns = facts.x_major ? "columns" : "rows";
  std::string text =
      fmt::format("    Bresenham, {}-major, {} wide; the pixel's centre is {:.6g} pixels from it in {}",
                  facts.x_major ? 'x' : 'y', facts.width, std::abs(facts.distance), facts.x_major ? 'y' : 'x');
  if (facts.columns && facts.columns->least == facts.columns->most) {
    text += fmt::format("; fragments in {} {}", facts.columns->least, columns);
  } else if (facts.columns) {
    text += fmt::format("; fragments in {} to {} {}", facts.columns->least, facts.columns->most, columns);
  }
  if (facts.diamond_exit) {
    text += fmt::format("; the diamond-exit rule makes {} here", *facts.diamond_exit ? "a fragment" : "none");
  }
  return text + "\n";
}

// "may cover the sample", and what its shape would do where something else decides.
std::string answer_text(const PrimitiveFacts& primitive) {
  std::string text = fmt::format("{} cover the sample", coverage_text(primitive.answer));
  if (primitive.coverage.coverage != primitive.answer) {
    text += fmt::format(" (its shape {})", coverage_text(primitive.coverage.coverage));
  }
  return text;
}

std::string primitive_text(const PrimitiveFacts& primitive) {
  std::string text = fmt::format("  {} (draw {}, {} {}): {}", name_of(primitive), primitive.draw,
                                 primitive.vertices.size() == 1 ? "vertex" : "vertices",
                                 fmt::join(primitive.vertices, " "), facing_text(primitive));
  if (primitive.undefined) text += ", undefined";
  if (primitive.thin && !primitive.undefined) text += ", too small to have values";
  if (primitive.clipped) text += ", to be clipped";
  if (primitive.open) text += ", may be dropped";
  text += fmt::format("{}; {}\n", exclusion_text(primitive.exclusion), answer_text(primitive));
  if (primitive.bresenham) text += bresenham_text(*primitive.bresenham);
  for (const Boundary& boundary : primitive.boundaries) text += boundary_text(boundary);
  return text;
}

std::string owner_text(uint32_t owner) {
  return owner == kNoOwner ? "none" : fmt::format("{}", owner);
}

std::string possible_text(const View& view) {
  const judge::Possibilities& possible = view.possible;
  std::string text = possible.least_hits == possible.most_hits
                         ? fmt::format("  right: hits {}", possible.least_hits)
                         : fmt::format("  right: hits {} to {}", possible.least_hits, possible.most_hits);
  for (size_t i = 0; i < possible.outcomes.size(); ++i) {
    const uint32_t writer = view.depth_owners[i];
    text += fmt::format("; owner {}, {}", owner_text(possible.outcomes[i].owner),
                        writer == kNoOwner ? "the clear depth" : fmt::format("the depth of {}", writer));
  }
  return text + "\n";
}

std::string value_text(const Value& value) {
  std::string text =
      fmt::format("  {:<16}{:>16.9g}  0x{:08x}", value.name, value.value, std::bit_cast<uint32_t>(value.value));
  const judge::Standing& standing = value.standing;
  if (std::isnan(standing.expected)) {
    return text + (standing.outside() ? "  wrong, no finite input can give it\n" : "  not judged\n");
  }
  text += fmt::format("  exact {:.12g}", standing.expected);
  if (!std::isfinite(standing.tolerance) || standing.tolerance == 0) {
    return text + (standing.outside()                  ? "  wrong\n"
                   : std::isfinite(standing.tolerance) ? "  right\n"
                                                       : "  not judged\n");
  }
  const double rounded = standing.tolerance - standing.spread;
  text += fmt::format(" +- {:.3g}", rounded);
  if (value.tolerance) {
    text += fmt::format(" (snapping {:.3g}, rounding {:.3g})", value.tolerance->snapping, value.tolerance->rounding);
  }
  if (standing.spread > 0)
    text += fmt::format(" or {:.3g} more, as {} is left open", standing.spread, value.left_open);
  text += fmt::format("; off by {:.3g} tolerances, {:.3g} ULP", standing.severity, value.ulps);
  return text + (value.place.empty() ? "\n" : fmt::format(", {}\n", value.place));
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
  std::string text =
      fmt::format("{}, pixel {},{} sample {}{}, at ({}, {})\n", explanation.case_name, explanation.x, explanation.y,
                  explanation.sample, explanation.samples > 1 ? fmt::format(" of {}", explanation.samples) : "",
                  explanation.position[0], explanation.position[1]);
  for (const View& view : explanation.views) {
    text += fmt::format("the oracle, for {} subpixel bits; dx, dy are pixels from the viewport's centre:\n",
                        view.subpixel_bits);
    for (const PrimitiveFacts& primitive : view.primitives) text += primitive_text(primitive);
    if (view.primitives.empty()) text += "  no primitive comes within a pixel\n";
    text += possible_text(view);
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
