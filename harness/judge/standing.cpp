#include "harness/judge/standing.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "reference/exact/rational_triangle.h"

namespace fillrule::judge {
namespace {

using Class = Standing::Class;
using exact::Expected;
using exact::Primitive;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Standing integer_standing(bool right, bool only_answer, double expected) {
  if (!right) return {.level = Class::kOutside, .expected = expected, .severity = kInfinity};
  return {.level = only_answer ? Class::kExact : Class::kWithin, .expected = only_answer ? expected : kNaN};
}

Standing not_judged() {
  return {.level = Class::kWithin, .expected = kNaN, .tolerance = kInfinity};
}

const Outcome* find_owner(const Possibilities& possible, uint32_t owner) {
  for (const Outcome& outcome : possible.outcomes) {
    if (outcome.owner == owner) return &outcome;
  }
  return nullptr;
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

bool has_finite_values(const Primitive& primitive) {
  return !primitive.thin && !primitive.triangle.undefined();
}

}  // namespace

Standing PartyJudge::coverage(const Possibilities& possible, size_t index) const {
  const bool covered = planes_.hits[index] != 0;
  const bool right = covered ? possible.most_hits > 0 : possible.least_hits == 0;
  const bool only_answer = possible.least_hits > 0 || possible.most_hits == 0;
  return integer_standing(right, only_answer, possible.least_hits > 0 ? 1 : 0);
}

Standing PartyJudge::hits(const Possibilities& possible, size_t index) const {
  const uint32_t hits = planes_.hits[index];
  const bool right = hits >= possible.least_hits && hits <= possible.most_hits;
  return integer_standing(right, possible.least_hits == possible.most_hits, possible.least_hits);
}

Standing PartyJudge::owner(const Possibilities& possible, size_t index) const {
  const uint32_t owner = planes_.owner[index];
  const auto& outcomes = possible.outcomes;
  const bool only_answer = std::all_of(outcomes.begin(), outcomes.end(), [&outcomes](const Outcome& outcome) {
    return outcome.owner == outcomes.front().owner;
  });
  return integer_standing(find_owner(possible, owner) != nullptr, only_answer, outcomes.front().owner);
}

Standing PartyJudge::front_facing(const Possibilities& possible, size_t index) const {
  const uint32_t owner = planes_.owner[index];
  const Outcome* outcome = find_owner(possible, owner);
  if (outcome == nullptr) return not_judged();  // the owner plane tells
  if (owner == kNoOwner) return integer_standing(planes_.front_facing[index] == 0, true, 0);
  const Primitive& primitive = expectation_.primitives()[owner];
  if (primitive.facing_in_doubt) return not_judged();
  const uint32_t expected = primitive.front_facing ? 1 : 0;
  return integer_standing(planes_.front_facing[index] == expected, true, expected);
}

Standing PartyJudge::depth_of(const Outcome& outcome, size_t index) const {
  const float value = planes_.depth[index];
  if (outcome.depth_writer == kNoOwner) {
    const float clear = case_.target.clear_depth;
    return integer_standing(value == clear, true, double{clear});
  }
  const bool finite = has_finite_values(expectation_.primitives()[outcome.depth_writer]);
  if (!outcome.depth_certain) return undecided_value(value, finite);
  const exact::TriangleValues& values = values_.values(outcome.depth_writer);
  Standing standing = value_standing(value, values.depth_for(value, x_of(index), y_of(index)));
  if (!needs_confirmation(standing)) return standing;
  if (certainly_outside(value, standing, values.depth_error(x_of(index), y_of(index)))) return standing;
  Expected confirmed{.value = exact::exact_depth(values.triangle(), x_of(index), y_of(index)),
                     .tolerance = standing.tolerance};
  confirmed.value = std::clamp(confirmed.value, 0.0, 1.0);
  return value_standing(value, confirmed);
}

Standing PartyJudge::depth(const Possibilities& possible, size_t index) const {
  Standing best{.level = Class::kOutside};
  bool found = false;
  for (const Outcome& outcome : possible.outcomes) {
    if (outcome.owner != planes_.owner[index]) continue;
    const Standing standing = depth_of(outcome, index);
    if (!found || standing.level < best.level) best = standing;
    found = true;
  }
  return found ? best : not_judged();  // without a right owner the owner plane tells
}

Standing PartyJudge::varying(const Possibilities& possible, size_t index, uint32_t component) const {
  const float value = planes_.varyings[component][index];
  const uint32_t owner = planes_.owner[index];
  const Outcome* outcome = find_owner(possible, owner);
  if (outcome == nullptr) return not_judged();
  if (owner == kNoOwner) return integer_standing(value == 0, true, 0);
  const Primitive& primitive = expectation_.primitives()[owner];
  if (primitive.triangle.undefined()) return not_judged();
  const exact::TriangleValues::Component& prepared = values_.component(owner, component);
  if (prepared.interpolation == Interpolation::kFlat) {
    // Equal to the bit; which NaN it is when a NaN is copied is not specified.
    const bool equal = std::bit_cast<uint32_t>(value) == std::bit_cast<uint32_t>(prepared.provoking);
    const bool both_nan = std::isnan(value) && std::isnan(prepared.provoking);
    return integer_standing(equal || both_nan, true, double{prepared.provoking});
  }
  if (!outcome->owner_certain) return undecided_value(value, has_finite_values(primitive) && prepared.judged);
  if (!prepared.judged) return not_judged();
  const exact::TriangleValues& values = values_.values(owner);
  Standing standing = value_standing(value, values.varying_for(prepared, value, x_of(index), y_of(index)));
  if (!needs_confirmation(standing)) return standing;
  if (certainly_outside(value, standing, values.varying_error(prepared, x_of(index), y_of(index)))) return standing;
  const bool smooth = prepared.interpolation == Interpolation::kSmooth;
  const auto exactly = smooth ? exact::exact_smooth : exact::exact_noperspective;
  return value_standing(value, {.value = exactly(primitive.triangle, prepared.values, x_of(index), y_of(index)),
                                .tolerance = standing.tolerance});
}

}  // namespace fillrule::judge
