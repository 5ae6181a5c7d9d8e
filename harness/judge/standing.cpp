#include "harness/judge/standing.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "harness/judge/line_rules.h"
#include "harness/judge/stored_depth.h"
#include "reference/exact/point_values.h"

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

// How far the value is from all that the exact one may be.
double error_of(float value, const Expected& expected) {
  return std::max(std::abs(double{value} - expected.value) - expected.spread, 0.0);
}

Standing value_standing(float value, const Expected& expected) {
  Standing standing{
      .expected = expected.value, .tolerance = expected.tolerance + expected.spread, .spread = expected.spread};
  if (value == static_cast<float>(expected.value)) return standing;
  const double error = error_of(value, expected);
  standing.severity = std::isfinite(value) ? error / expected.tolerance : kInfinity;
  standing.level = std::isfinite(value) ? classify(error, expected.tolerance) : Class::kOutside;
  return standing;
}

// Whether the value is outside whatever the exact value is within `error` of the expected one. Nobody is accused on
// the word of doubles alone; where this says false, rationals have to be asked.
bool certainly_outside(float value, const Expected& expected, double error) {
  return error_of(value, expected) - error > exact::kImpreciseFactor * expected.tolerance;
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

// A standing from doubles, confirmed by the exact value where it is close to an accusation. `error()` bounds what the
// doubles err, `exact_value()` gives the exact value.
template <typename ErrorBound, typename ExactValue>
Standing confirmed(float value, const Expected& expected, const ErrorBound& error, const ExactValue& exact_value) {
  const Standing standing = value_standing(value, expected);
  if (!needs_confirmation(standing) || certainly_outside(value, expected, error())) return standing;
  return value_standing(value, {.value = exact_value(), .tolerance = expected.tolerance, .spread = expected.spread});
}

bool is_better(const Standing& a, const Standing& b) {
  return a.level < b.level || (a.level == b.level && a.severity < b.severity);
}

exact::Block pixel_block(const exact::SamplePlace& place) {
  return {.x = place.x + 0.5, .y = place.y + 0.5, .half_width = 0.5, .half_height = 0.5};
}

// A value that may be evaluated anywhere between the corners; inside of them it lies between those at the corners.
template <typename ExpectedAt>
Expected expected_between(const std::vector<exact::Position>& corners, const ExpectedAt& expected_at) {
  double low = kInfinity;
  double high = -kInfinity;
  double tolerance = 0;
  for (const exact::Position& corner : corners) {
    const Expected expected = expected_at(corner);
    low = std::min(low, expected.value - expected.spread);
    high = std::max(high, expected.value + expected.spread);
    tolerance = std::max(tolerance, expected.tolerance);
  }
  if (!(high >= low) || !std::isfinite(low) || !std::isfinite(high)) tolerance = kInfinity;
  return {.value = low + (high - low) / 2, .tolerance = tolerance, .spread = (high - low) / 2};
}

}  // namespace

PartyJudge::PartyJudge(const Case& test_case, const Planes& planes, const exact::Expectation& expectation,
                       ValueCache& values)
    : case_(test_case),
      planes_(planes),
      expectation_(expectation),
      values_(values),
      sources_(component_sources(test_case.varyings)),
      shades_samples_(shades_samples(test_case)),
      broken_(broken_line_rules(test_case, expectation, planes)) {}

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
  const VkFormat format = case_.target.depth_format;
  if (!exact::is_depth_of(format, value)) {
    return {.level = Class::kOutside, .expected = kNaN, .tolerance = kInfinity, .severity = kInfinity};
  }
  if (outcome.depth_writer == kNoOwner) {
    const float clear = case_.target.clear_depth;
    const exact::DepthRange stored = exact::stored_clear(format, clear, false);
    const bool right = static_cast<float>(stored.low) <= value && value <= static_cast<float>(stored.high);
    return integer_standing(right, true, double{exact::nearest_depth(format, double{clear})});
  }
  const Piece& piece = expectation_.pieces()[outcome.depth_writer];
  if (!outcome.depth_certain) return undecided_value(value, has_finite_values(piece));
  const exact::PieceValues& values = values_.values(outcome.depth_writer);
  const RasterState& state = case_.draws[piece.draw].state;
  const exact::Position at = exact::sample_place(case_.target, index).position;
  const Expected depth = values.depth(at.x, at.y);
  const Expected expected = expected_in(format, state, depth);
  if (depth.spread == 0 && value == exact::nearest_depth(format, expected.value)) {
    return {.level = Class::kExact,
            .expected = expected.value,
            .tolerance = expected.tolerance + expected.spread,
            .spread = expected.spread};
  }
  const bool open = leaves_range(state, format, depth) && (depth.value < -depth.tolerance - depth.spread ||
                                                           depth.value > 1 + depth.tolerance + depth.spread);
  if (open) return undecided_value(value, true);
  const auto exact_depth = [&] {
    Expected exactly = depth;
    exactly.value = values.exact_depth(at.x, at.y);
    return expected_in(format, state, exactly).value;
  };
  return confirmed(
      value, expected, [&] { return values.depth_error(at.x, at.y); }, exact_depth);
}

Standing PartyJudge::varying(const Possibilities& possible, size_t index, uint32_t component) const {
  return best_over_outcomes(possible, planes_.owner[index],
                            [&](const Outcome& outcome) { return varying_of(outcome, index, component); });
}

template <typename StandingAt>
Standing PartyJudge::best_place(const exact::SamplePlace& place, const StandingAt& standing_at) const {
  const Standing at_centre = standing_at({.x = place.x + 0.5, .y = place.y + 0.5});
  if (!shades_samples_) return at_centre;
  const Standing at_sample = standing_at(place.position);
  return is_better(at_sample, at_centre) ? at_sample : at_centre;
}

Standing PartyJudge::varying_of(const Outcome& outcome, size_t index, uint32_t component) const {
  const float value = planes_.varyings[component][index];
  if (outcome.owner == kNoOwner) return integer_standing(value == 0, true, 0);
  const Piece& piece = expectation_.pieces()[outcome.piece];
  const ComponentSource& source = sources_[component];
  if (piece.shape->undefined()) return not_judged();
  const exact::PieceValues& values = values_.values(outcome.piece);
  const uint32_t number = source.number;
  const bool of_vertices = source.source == VaryingSource::kVertices;
  if (of_vertices && source.interpolation == Interpolation::kFlat) {
    // Equal to the bit; which NaN it is when a NaN is copied is not specified.
    const float provoking = values.provoking(number);
    const bool equal = std::bit_cast<uint32_t>(value) == std::bit_cast<uint32_t>(provoking);
    return integer_standing(equal || (std::isnan(value) && std::isnan(provoking)), true, double{provoking});
  }
  const bool judged = !of_vertices || values.judged(number);
  if (!outcome.owner_certain) return undecided_value(value, has_finite_values(piece) && judged);
  if (!judged) return not_judged();
  const exact::SamplePlace place = exact::sample_place(case_.target, index);
  if (source.source == VaryingSource::kFragCoord) return frag_coord(piece, values, source, value, place);
  if (source.source == VaryingSource::kPointCoord) return point_coord(piece, values, source, value, place);
  const auto standing_at = [&](const exact::Position& at) {
    return confirmed(
        value, values.varying_for(number, value, at.x, at.y),
        [&] { return values.varying_error(number, at.x, at.y); },
        [&] { return values.exact_varying(number, at.x, at.y); });
  };
  if (source.sampling == Sampling::kSample) return standing_at(place.position);
  if (source.sampling == Sampling::kCenter || planes_.samples == 1) return best_place(place, standing_at);
  const Expected centroid =
      expected_between(piece.shape->part_in(pixel_block(place), piece.latitude), [&](const exact::Position& at) {
        return values.varying_for(number, std::numeric_limits<float>::quiet_NaN(), at.x, at.y);
      });
  if (!std::isfinite(centroid.tolerance)) return undecided_value(value, true);
  return value_standing(value, centroid);
}

// x and y are the place's to the bit, z is the depth before or after it is clamped, and w is 1/w.
Standing PartyJudge::frag_coord(const Piece& piece, const exact::PieceValues& values, const ComponentSource& source,
                                float value, const exact::SamplePlace& place) const {
  constexpr uint32_t kZ = 2;
  constexpr uint32_t kW = 3;
  if (source.number < kZ) {
    return best_place(place, [&](const exact::Position& at) {
      const double expected = source.number == 0 ? at.x : at.y;
      return integer_standing(double{value} == expected, true, expected);
    });
  }
  const auto expected_at = [&](const exact::Position& at) {
    return source.number == kW ? values.reciprocal_w(at.x, at.y) : values.depth(at.x, at.y);
  };
  const RasterState& state = case_.draws[piece.draw].state;
  const auto either = [&](const Expected& expected) {
    const Standing standing = value_standing(value, expected);
    if (source.number == kW) return standing;
    const Standing clamped = value_standing(value, expected_in(VK_FORMAT_D32_SFLOAT, state, expected));
    return is_better(clamped, standing) ? clamped : standing;
  };
  // For which sample of the fragment they hold is not said.
  if (planes_.samples > 1 && !shades_samples_) {
    const Expected anywhere = expected_between(exact::corners(pixel_block(place)), expected_at);
    return std::isfinite(anywhere.tolerance) ? either(anywhere) : undecided_value(value, true);
  }
  return best_place(place, [&](const exact::Position& at) { return either(expected_at(at)); });
}

// Only points have it.
Standing PartyJudge::point_coord(const Piece& piece, const exact::PieceValues& values, const ComponentSource& source,
                                 float value, const exact::SamplePlace& place) const {
  if (piece.kind != Piece::Kind::kPoint) return not_judged();
  const auto& point = static_cast<const exact::PointValues&>(values);
  return best_place(place, [&](const exact::Position& at) {
    return value_standing(value, point.point_coord_for(source.number, value, at.x, at.y));
  });
}

}  // namespace fillrule::judge
