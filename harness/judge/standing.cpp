#include "harness/judge/standing.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "harness/judge/line_rules.h"

namespace fillrule::judge {
namespace {

using Class = Standing::Class;
using exact::Expected;
using exact::Piece;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Standing integer_standing(bool right, bool only_answer, double expected) {
  if (!right) return {.level = Class::kOutside, .expected = expected, .severity = kInfinity};
  return {.level = only_answer ? Class::kExact : Class::kWithin, .expected = only_answer ? expected : kNaN};
}

Standing not_judged() {
  return {.level = Class::kWithin, .expected = kNaN, .tolerance = kInfinity};
}

// The best standing over the outcomes with the owner that the party shows: several, where pieces of one polygon meet
// or different depths may be stored. Without a right owner the owner plane tells, and nothing else is judged.
template <typename StandingOf>
Standing best_over_outcomes(const Possibilities& possible, uint32_t owner, const StandingOf& standing_of) {
  std::optional<Standing> best;
  for (const Outcome& outcome : possible.outcomes) {
    if (outcome.owner != owner) continue;
    const Standing standing = standing_of(outcome);
    if (!best || standing.level < best->level) best = standing;
  }
  return best ? *best : not_judged();
}

bool has_owner(const Possibilities& possible, uint32_t owner) {
  return std::ranges::any_of(possible.outcomes, [owner](const Outcome& outcome) { return outcome.owner == owner; });
}

Class classify(double error, double tolerance) {
  if (error <= tolerance) return Class::kWithin;
  return error <= exact::kImpreciseFactor * tolerance ? Class::kImprecise : Class::kOutside;
}

Standing value_standing(float value, const Expected& expected) {
  Standing standing{.expected = expected.value, .tolerance = expected.tolerance};
  if (value == static_cast<float>(expected.value)) return standing;
  const double error = std::abs(double{value} - expected.value);
  standing.severity = std::isfinite(value) ? error / expected.tolerance : kInfinity;
  standing.level = std::isfinite(value) ? classify(error, expected.tolerance) : Class::kOutside;
  return standing;
}

// Whether the value is outside whatever the exact value is within `error` of the expected one. Nobody is accused on
// the word of doubles alone; where this says false, rationals have to be asked.
bool certainly_outside(float value, const Standing& standing, double error) {
  return std::abs(double{value} - standing.expected) - error > exact::kImpreciseFactor * standing.tolerance;
}

// Nobody is accused on the word of doubles alone where it is close: they are within a millionth of the tolerance of
// the exact value (value_bound_test.cpp), so beyond twice the limit there is nothing to confirm.
bool needs_confirmation(const Standing& standing) {
  return standing.outside() && standing.severity <= 2 * exact::kImpreciseFactor;
}

// No finite input gives NaN or infinity, and where nothing is defined nothing is judged.
Standing undecided_value(float value, bool finite_input) {
  if (finite_input && !std::isfinite(value)) {
    return {.level = Class::kOutside, .expected = kNaN, .tolerance = kInfinity, .severity = kInfinity};
  }
  return not_judged();
}

bool has_finite_values(const Piece& piece) {
  return !piece.thin && !piece.shape->undefined();
}

}  // namespace

PartyJudge::PartyJudge(const Case& test_case, const Planes& planes, const exact::Expectation& expectation,
                       ValueCache& values)
    : case_(test_case),
      planes_(planes),
      expectation_(expectation),
      values_(values),
      broken_(broken_line_rules(test_case, expectation, planes)) {
  for (const Varying& varying : test_case.varyings) {
    interpolation_.insert(interpolation_.end(), varying.components, varying.interpolation);
  }
}

bool PartyJudge::breaks_line_rule(size_t index) const {
  return std::binary_search(broken_.begin(), broken_.end(), index);
}

Standing PartyJudge::coverage(const Possibilities& possible, size_t index) const {
  const bool covered = planes_.hits[index] != 0;
  const bool right = (covered ? possible.most_hits > 0 : possible.least_hits == 0) && !breaks_line_rule(index);
  const bool only_answer = possible.least_hits > 0 || possible.most_hits == 0;
  return integer_standing(right, only_answer, possible.least_hits > 0 ? 1 : 0);
}

Standing PartyJudge::hits(const Possibilities& possible, size_t index) const {
  const uint32_t hits = planes_.hits[index];
  const bool right = hits >= possible.least_hits && hits <= possible.most_hits && !breaks_line_rule(index);
  return integer_standing(right, possible.least_hits == possible.most_hits, possible.least_hits);
}

Standing PartyJudge::owner(const Possibilities& possible, size_t index) const {
  const uint32_t owner = planes_.owner[index];
  const auto& outcomes = possible.outcomes;
  const bool only_answer = std::all_of(outcomes.begin(), outcomes.end(), [&outcomes](const Outcome& outcome) {
    return outcome.owner == outcomes.front().owner;
  });
  return integer_standing(has_owner(possible, owner), only_answer, outcomes.front().owner);
}

Standing PartyJudge::front_facing(const Possibilities& possible, size_t index) const {
  const uint32_t owner = planes_.owner[index];
  return best_over_outcomes(possible, owner, [&](const Outcome& outcome) {
    if (owner == kNoOwner) return integer_standing(planes_.front_facing[index] == 0, true, 0);
    const Piece& piece = expectation_.pieces()[outcome.piece];
    if (piece.facing_in_doubt) return not_judged();
    const uint32_t expected = piece.front_facing ? 1 : 0;
    return integer_standing(planes_.front_facing[index] == expected, true, expected);
  });
}

Standing PartyJudge::depth(const Possibilities& possible, size_t index) const {
  return best_over_outcomes(possible, planes_.owner[index],
                            [&](const Outcome& outcome) { return depth_of(outcome, index); });
}

Standing PartyJudge::depth_of(const Outcome& outcome, size_t index) const {
  const float value = planes_.depth[index];
  if (outcome.depth_writer == kNoOwner) {
    const float clear = case_.target.clear_depth;
    return integer_standing(value == clear, true, double{clear});
  }
  const bool finite = has_finite_values(expectation_.pieces()[outcome.depth_writer]);
  if (!outcome.depth_certain) return undecided_value(value, finite);
  const exact::PieceValues& values = values_.values(outcome.depth_writer);
  const double x = x_of(index);
  const double y = y_of(index);
  const Standing standing = value_standing(value, values.depth_for(value, x, y));
  if (!needs_confirmation(standing) || certainly_outside(value, standing, values.depth_error(x, y))) return standing;
  return value_standing(value, {.value = values.exact_depth(x, y), .tolerance = standing.tolerance});
}

Standing PartyJudge::varying(const Possibilities& possible, size_t index, uint32_t component) const {
  return best_over_outcomes(possible, planes_.owner[index],
                            [&](const Outcome& outcome) { return varying_of(outcome, index, component); });
}

Standing PartyJudge::varying_of(const Outcome& outcome, size_t index, uint32_t component) const {
  const float value = planes_.varyings[component][index];
  if (outcome.owner == kNoOwner) return integer_standing(value == 0, true, 0);
  const Piece& piece = expectation_.pieces()[outcome.piece];
  if (piece.shape->undefined()) return not_judged();
  const exact::PieceValues& values = values_.values(outcome.piece);
  if (interpolation_[component] == Interpolation::kFlat) {
    // Equal to the bit; which NaN it is when a NaN is copied is not specified.
    const float provoking = values.provoking(component);
    const bool equal = std::bit_cast<uint32_t>(value) == std::bit_cast<uint32_t>(provoking);
    return integer_standing(equal || (std::isnan(value) && std::isnan(provoking)), true, double{provoking});
  }
  if (!outcome.owner_certain) return undecided_value(value, has_finite_values(piece) && values.judged(component));
  if (!values.judged(component)) return not_judged();
  const double x = x_of(index);
  const double y = y_of(index);
  const Standing standing = value_standing(value, values.varying_for(component, value, x, y));
  if (!needs_confirmation(standing) || certainly_outside(value, standing, values.varying_error(component, x, y))) {
    return standing;
  }
  return value_standing(value, {.value = values.exact_varying(component, x, y), .tolerance = standing.tolerance});
}

}  // namespace fillrule::judge
