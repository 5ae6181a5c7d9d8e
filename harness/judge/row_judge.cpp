#include "harness/judge/row_judge.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "harness/judge/stored_depth.h"

namespace fillrule::judge {
namespace {

// Counts with integers as wide as the doubles, so that the loop vectorises. NaN is outside.
bool all_within(const float* values, std::span<const double> expected, std::span<const double> least) {
  int64_t outside = 0;
  for (size_t i = 0; i < expected.size(); ++i) {
    outside += std::abs(static_cast<double>(values[i]) - expected[i]) <= least[i] ? 0 : 1;
  }
  return outside == 0;
}

bool all_equal(const float* values, size_t size, float expected) {
  uint32_t difference = 0;
  for (size_t i = 0; i < size; ++i) {
    difference |= std::bit_cast<uint32_t>(values[i]) ^ std::bit_cast<uint32_t>(expected);
  }
  return difference == 0;
}

// True if `op` holds for every depth in [low, high] against the stored one.
bool passes_throughout(VkCompareOp op, double low, double high, double stored) {
  switch (op) {
    case VK_COMPARE_OP_ALWAYS:
      return true;
    case VK_COMPARE_OP_LESS:
      return high < stored;
    case VK_COMPARE_OP_LESS_OR_EQUAL:
      return high <= stored;
    case VK_COMPARE_OP_GREATER:
      return low > stored;
    case VK_COMPARE_OP_GREATER_OR_EQUAL:
      return low >= stored;
    case VK_COMPARE_OP_NOT_EQUAL:
      return high < stored || low > stored;
    default:
      return false;
  }
}

}  // namespace

RowJudge::Landing RowJudge::landing_of(uint32_t number) {
  if (landing_.empty()) landing_.assign(expectation_.pieces().size(), Landing::kUnknown);
  Landing& landing = landing_[number];
  if (landing != Landing::kUnknown) return landing;
  landing = Landing::kUncertain;
  const exact::Piece& piece = expectation_.pieces()[number];
  const RasterState& state = case_.draws[piece.draw].state;
  if (piece.triangle() == nullptr || piece.thin || piece.shape->undefined() || piece.facing_in_doubt) return landing;
  if (state.depth_bounds) return landing;
  if (!state.depth_test) return landing = Landing::kCertain;
  if (!piece.triangle()->in_front()) return landing;
  if (!has_plain_depth(state, case_.target.depth_format)) return landing;
  const auto range = values_.triangle(number).depth_range();
  // Depths are clamped before they are compared.
  const double low = std::clamp(range.low, 0.0, 1.0);
  const double high = std::clamp(range.high, 0.0, 1.0);
  if (passes_throughout(state.depth_compare, low, high, double{case_.target.clear_depth}))
    landing = Landing::kCertain;
  return landing;
}

bool RowJudge::start(size_t begin, size_t end) {
  const uint32_t number = expectation_.classes()[begin];
  if (number == exact::kNothing) {
    begin_run(kNoOwner, 0, begin, end);
    return true;
  }
  const std::optional<uint32_t> sole = expectation_.sole(number);
  if (!sole || landing_of(*sole) != Landing::kCertain) return false;
  begin_run(*sole, 1, begin, end);
  return true;
}

bool RowJudge::start_top(const Landed& landed, size_t begin, size_t end) {
  if (landed.piece == kNoOwner) {
    begin_run(kNoOwner, 0, begin, end);
    return true;
  }
  const exact::Piece& piece = expectation_.pieces()[landed.piece];
  if (piece.triangle() == nullptr || piece.facing_in_doubt) return false;
  const RasterState& state = case_.draws[piece.draw].state;
  const uint32_t writer = state.depth_test && state.depth_write ? landed.piece : kNoOwner;
  if (landed.depth_writer != writer && case_.target.depth_format != VK_FORMAT_UNDEFINED) return false;
  begin_run(landed.piece, landed.hits, begin, end);
  return true;
}

void RowJudge::begin_run(uint32_t top, uint32_t hits, size_t begin, size_t end) {
  if (top != kNoOwner) {
    const exact::Position position = exact::sample_place(case_.target, begin).position;
    x_ = position.x;
    y_ = position.y;
  }
  top_ = top;
  hits_ = hits;
  begin_ = begin;
  size_ = end - begin;
  has_w_ = false;
}

bool RowJudge::integers_right(const Planes& planes) const {
  const bool nothing = top_ == kNoOwner;
  const uint32_t owner = nothing ? kNoOwner : expectation_.pieces()[top_].owner;
  const uint32_t front_facing = !nothing && expectation_.pieces()[top_].front_facing ? 1 : 0;
  uint32_t difference = 0;
  for (size_t i = begin_; i < begin_ + size_; ++i) {
    difference |= (planes.hits[i] ^ hits_) | (planes.owner[i] ^ owner) | (planes.front_facing[i] ^ front_facing);
  }
  return difference == 0;
}

bool RowJudge::expect(PlaneKind kind, uint32_t component) {
  kind_ = kind;
  component_ = component;
  constant_.reset();
  if (kind == PlaneKind::kDepth) return expect_depth();
  return top_ == kNoOwner ? expect_constant(0) : expect_varying(component);
}

// Room for the run's samples. Never made smaller: a vector clears whatever is added to it again.
std::span<double> RowJudge::first_of(std::vector<double>& values) const {
  if (values.size() < size_) values.resize(size_);
  return std::span(values).first(size_);
}

bool RowJudge::expect_constant(float value) {
  constant_ = value;
  return true;
}

bool RowJudge::expect_depth() {
  const RasterState* const state = top_ == kNoOwner ? nullptr : &case_.draws[expectation_.pieces()[top_].draw].state;
  if (state == nullptr || !state->depth_test || !state->depth_write) {
    return expect_constant(exact::nearest_depth(case_.target.depth_format, double{case_.target.clear_depth}));
  }
  if (has_several_samples() || !has_plain_depth(*state, case_.target.depth_format)) return false;
  const std::span<double> expected = first_of(expected_);
  values_.triangle(top_).depth_row(x_, y_, expected, first_of(least_));
  for (double& depth : expected) depth = std::clamp(depth, 0.0, 1.0);
  return true;
}

bool RowJudge::expect_varying(uint32_t component) {
  if (sources_[component].source != VaryingSource::kVertices) return false;
  const exact::TriangleValues& triangle = values_.triangle(top_);
  const exact::TriangleValues::Component& prepared = triangle.component(sources_[component].number);
  if (prepared.interpolation == Interpolation::kFlat) return expect_constant(prepared.provoking);
  if (!prepared.judged || has_several_samples()) return false;
  if (!has_w_ && prepared.interpolation == Interpolation::kSmooth) {
    triangle.w_row(x_, y_, first_of(w_));
    has_w_ = true;
  }
  triangle.varying_row(prepared, x_, y_, w_, first_of(expected_), first_of(least_));
  return true;
}

bool RowJudge::within(const Planes& planes) const {
  const float* const row = values(planes);
  if (constant_) return all_equal(row, size_, *constant_);
  return all_within(row, std::span(expected_).first(size_), std::span(least_).first(size_));
}

bool RowJudge::differ(const Planes& a, const Planes& b) const {
  return std::memcmp(values(a), values(b), size_ * sizeof(float)) != 0;
}

void RowJudge::mark_different(const Planes& planes, const Planes* other, std::span<uint32_t> marks) const {
  const float* const row = values(planes);
  if (other != nullptr) {
    const float* const others = values(*other);
    for (size_t i = 0; i < size_; ++i) {
      marks[i] |= std::bit_cast<uint32_t>(row[i]) ^ std::bit_cast<uint32_t>(others[i]);
    }
  } else if (!constant_) {
    for (size_t i = 0; i < size_; ++i) marks[i] |= row[i] == static_cast<float>(expected_[i]) ? 0U : 1U;
  } else if (std::isnan(*constant_)) {
    // All values have its bits; NaN is no value.
    std::ranges::fill(marks, 1U);
  }
}

const float* RowJudge::values(const Planes& planes) const {
  return (kind_ == PlaneKind::kDepth ? planes.depth.data() : planes.varyings[component_].data()) + begin_;
}

}  // namespace fillrule::judge
