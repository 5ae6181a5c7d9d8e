#include "harness/judge/possibilities.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "harness/judge/stored_depth.h"
#include "harness/judge/watertight.h"

namespace fillrule::judge {
namespace {

using exact::Coverage;
using exact::Entry;
using exact::Piece;

// Two ways to the same end.
void unite(Outcome& known, const Outcome& other) {
  known.owner_certain = known.owner_certain && other.owner_certain;
  known.depth_certain = known.depth_certain && other.depth_certain;
}

void add_unique(std::vector<Outcome>& outcomes, const Outcome& outcome) {
  for (Outcome& known : outcomes) {
    if (known.piece != outcome.piece || known.depth_writer != outcome.depth_writer) continue;
    unite(known, outcome);
    return;
  }
  outcomes.push_back(outcome);
}

bool has_values(const Piece& piece) {
  return !piece.thin && !piece.shape->undefined();
}

// Whether what is stored decides about what lands.
bool depends_on_depth(const Draw& draw) {
  return draw.state.depth_test || draw.state.depth_bounds.has_value();
}

// Whether its own depth decides about a fragment.
bool compares_depth(const RasterState& state) {
  return state.depth_test && state.depth_compare != VK_COMPARE_OP_ALWAYS &&
         state.depth_compare != VK_COMPARE_OP_NEVER;
}

// Drawn from the same bits with the same state, two triangles have the same depth to the bit.
bool same_geometry(const Case& test_case, const Piece& a, const Piece& b) {
  if (a.triangle() == nullptr || b.triangle() == nullptr) return false;
  if (a.triangle()->vertices() != b.triangle()->vertices()) return false;
  const RasterState& sa = test_case.draws[a.draw].state;
  const RasterState& sb = test_case.draws[b.draw].state;
  const VkViewport& va = sa.viewport;
  const VkViewport& vb = sb.viewport;
  return sa.depth_bias == sb.depth_bias && sa.depth_clamp == sb.depth_clamp &&
         sa.negative_one_to_one == sb.negative_one_to_one && va.x == vb.x && va.y == vb.y && va.width == vb.width &&
         va.height == vb.height && va.minDepth == vb.minDepth && va.maxDepth == vb.maxDepth;
}

}  // namespace

const exact::PieceValues& ValueCache::values(uint32_t piece) {
  std::unique_ptr<exact::PieceValues>& slot = values_[piece];
  if (!slot) slot = exact::values_of(case_, expectation_.pieces()[piece]);
  return *slot;
}

Replay::Replay(const Case& test_case, const exact::Expectation& expectation, ValueCache& values,
               uint32_t subpixel_bits, Rules rules)
    : case_(test_case),
      expectation_(expectation),
      values_(values),
      subpixel_bits_(subpixel_bits),
      rules_(rules),
      on_grid_(expectation.pieces().size(), 0),
      depths_(expectation.pieces().size()) {}

const Possibilities& Replay::at(size_t index) {
  if (asked_ > 0 && index == index_) return possibilities_;
  index_ = index;
  find_class(index);
  if (asked_ > 0 && class_.same_everywhere && class_.number == class_of_answer_) return possibilities_;
  class_of_answer_ = class_.number;
  entries_ = class_.entries;
  used_rules_ = false;
  decided_by_relations_ = class_.by_depths;
  relations_.clear();
  ++asked_;
  possibilities_.least_hits = 0;
  possibilities_.most_hits = 0;
  possibilities_.in_doubt = false;
  possibilities_.undefined = false;
  possibilities_.outcomes.assign(1, Outcome{.owner_certain = true, .depth_certain = true});
  stored_.reset();
  const auto [x, y] = exact::sample_place(case_.target, index).position;
  if (rules_.top_left || rules_.diamond_exit) resolve_ties(x, y);
  for (const Entry& entry : entries_) {
    possibilities_.in_doubt = possibilities_.in_doubt || entry.coverage == Coverage::kMay;
    possibilities_.undefined = possibilities_.undefined || expectation_.pieces()[entry.piece].shape->undefined();
  }
  if (!possibilities_.in_doubt) {
    replay(0, entries_.size(), x, y);
  } else if (!replay_watertight(0, entries_.size(), x, y)) {
    // Layers drawn one after the other may each be watertight.
    for (size_t begin = 0, end = 0; begin < entries_.size(); begin = end) {
      const auto draw_of = [this](size_t i) { return expectation_.pieces()[entries_[i].piece].draw; };
      for (end = begin; end < entries_.size() && draw_of(end) == draw_of(begin);) ++end;
      if (!replay_watertight(begin, end, x, y)) replay(begin, end, x, y);
    }
  }
  return possibilities_;
}

void Replay::find_class(size_t index) {
  const uint32_t number = expectation_.classes()[index];
  if (number == class_.number) return;
  class_.number = number;
  expectation_.collect(index, class_.entries);
  const auto all = [this](bool (Replay::*is)(const Entry&) const) {
    return std::ranges::all_of(class_.entries, [&](const Entry& entry) { return (this->*is)(entry); });
  };
  class_.same_everywhere = all(&Replay::same_everywhere_of);
  // The samples of several pixels are on no line.
  class_.by_depths = case_.target.samples == VK_SAMPLE_COUNT_1_BIT && all(&Replay::by_depths_of);
}

// Whether what the entry does is the same at all samples that have it and others of the kind: it has no depth that is
// stored, or any at all, and no rule (resolve_ties(), watertight.h) decides by the place.
bool Replay::same_everywhere_of(const Entry& entry) const {
  const Piece& piece = expectation_.pieces()[entry.piece];
  return piece.shape->undefined() ||
         (entry.coverage == Coverage::kMust && !depends_on_depth(case_.draws[piece.draw]));
}

// Whether depths that are compared and stored as they are interpolated decide about what the entry does, or nothing.
bool Replay::by_depths_of(const Entry& entry) const {
  const Piece& piece = expectation_.pieces()[entry.piece];
  const RasterState& state = case_.draws[piece.draw].state;
  if (entry.coverage != Coverage::kMust || piece.triangle() == nullptr || !has_values(piece)) return false;
  return !state.depth_bounds && (!state.depth_test || has_plain_depth(state, case_.target.depth_format));
}

bool Replay::may_tell_between(size_t index) {
  find_class(index);
  return class_.same_everywhere || class_.by_depths;
}

bool Replay::is_same_between(size_t first, size_t last) {
  at(first);
  if (first == last) return true;
  if (!class_.same_everywhere) {
    if (!decided_by_relations_) return false;
    relations_before_ = relations_;
  }
  at(last);
  return class_.same_everywhere || (decided_by_relations_ && relations_ == relations_before_);
}

void Replay::replay(size_t begin, size_t end, double x, double y) {
  for (size_t i = begin; i < end; ++i) land(entries_[i], entries_[i].coverage == Coverage::kMust, x, y);
}

// Where the rule says that exactly one of the entries in doubt covers the sample, each of them is tried in turn, and
// where it says that none does, none is. Returns false where the rule says nothing of the kind.
bool Replay::replay_watertight(size_t begin, size_t end, double x, double y) {
  const std::span<const Entry> entries = entries_.subspan(begin, end - begin);
  const WatertightHits hits = watertight_hits(case_, expectation_, entries, x, y);
  if (hits.primitives == 0 || hits.hits > 1) return false;
  const Possibilities before = possibilities_;
  Possibilities united = before;
  united.outcomes.clear();
  const auto replay_with = [&](const Entry* chosen) {
    possibilities_ = before;
    stored_.reset();
    for (const Entry& entry : entries) {
      if (entry.coverage == Coverage::kMust || &entry == chosen) land(entry, true, x, y);
    }
    for (const Outcome& outcome : possibilities_.outcomes) add_unique(united.outcomes, outcome);
    united.least_hits = std::min(united.least_hits, possibilities_.least_hits);
    united.most_hits = std::max(united.most_hits, possibilities_.most_hits);
  };
  united.least_hits = std::numeric_limits<uint32_t>::max();
  if (hits.hits == 0) replay_with(nullptr);
  for (const Entry& entry : entries) {
    if (hits.hits == 1 && entry.coverage == Coverage::kMay) replay_with(&entry);
  }
  possibilities_ = std::move(united);
  stored_.reset();
  return true;
}

void Replay::resolve_ties(double x, double y) {
  resolved_ = class_.entries;
  for (Entry& entry : resolved_) {
    if (entry.coverage == Coverage::kMust || !resolved_on_grid(entry)) continue;
    used_rules_ = true;
    // Nothing is rounded, so the facing is certain too.
    const Piece& piece = expectation_.pieces()[entry.piece];
    entry.coverage = !piece.culled && piece.shape->owns(x, y) ? Coverage::kMust : Coverage::kMustNot;
  }
  std::erase_if(resolved_, [](const Entry& entry) { return entry.coverage == Coverage::kMustNot; });
  entries_ = resolved_;
}

bool Replay::resolved_on_grid(const Entry& entry) {
  const Piece& piece = expectation_.pieces()[entry.piece];
  const exact::Shape& shape = *piece.shape;
  const bool is_bresenham = piece.kind == Piece::Kind::kBresenhamLine;
  if (!(is_bresenham ? rules_.diamond_exit : rules_.top_left) || piece.open) return false;
  const auto resolvable = is_bresenham ? exact::kDoubtShape : exact::kDoubtEdges;
  if ((entry.doubt & ~resolvable) != 0 || shape.undefined() || !shape.inside_volume()) return false;
  uint8_t& known = on_grid_[entry.piece];
  if (known == 0) known = shape.on_grid(subpixel_bits_) ? 2 : 1;
  return known == 2;
}

void Replay::land(const Entry& entry, bool must, double x, double y) {
  const Piece& piece = expectation_.pieces()[entry.piece];
  const RasterState& state = case_.draws[piece.draw].state;
  // Wherever a Bresenham line has a fragment, its values are those of the place.
  const bool is_bresenham = piece.kind == Piece::Kind::kBresenhamLine;
  const bool certain = (entry.coverage == Coverage::kMust || is_bresenham) && has_values(piece);
  const bool writes = state.depth_test && state.depth_write && case_.target.depth_format != VK_FORMAT_UNDEFINED;
  Layer layer{.number = entry.piece, .piece = piece, .state = state, .is_inside = entry.coverage == Coverage::kMust};
  const auto land_over = [&](const Outcome& before) {
    Outcome after = before;
    after.owner = piece.owner;
    after.piece = entry.piece;
    after.owner_certain = certain;
    if (writes) {
      after.depth_writer = entry.piece;
      after.depth_certain = certain;
    }
    return after;
  };
  const std::optional<bool> passes = passes_everywhere(layer, x, y);
  relations_.push_back(layer.to_stored);
  decided_by_relations_ = decided_by_relations_ && passes;
  if (passes && !*passes) return;
  std::vector<Outcome>& outcomes = possibilities_.outcomes;
  if (passes && (writes || outcomes.size() == 1)) {
    // Whatever was there, the same is on top and stored.
    const Outcome after = land_over(outcomes.front());
    if (must) outcomes.clear();
    outcomes.push_back(after);
    possibilities_.least_hits += must ? 1 : 0;
    ++possibilities_.most_hits;
    if (writes) store(layer, must);
    return;
  }
  if (compares_depth(state)) layer.depth = depth_of(entry.piece, x, y);
  bool lands_always = must;
  bool lands_ever = false;
  before_.swap(outcomes);
  outcomes.clear();
  landed_.clear();
  stored_.reset();
  for (const Outcome& before : before_) {
    const DepthResult result = tests(layer, before.depth_writer, x, y);
    const bool lands = result != DepthResult::kFails;
    lands_ever = lands_ever || lands;
    lands_always = lands_always && result == DepthResult::kPasses;
    // In which order a polygon's edges or corners are drawn is left open: the one before may have been the last.
    const bool was_first = before.piece != kNoOwner && any_order(layer, before.piece);
    // The outcomes before differ from each other, and this piece was drawn by none of them.
    if (!must || result != DepthResult::kPasses || was_first) outcomes.push_back(before);
    if (!lands) continue;
    if (writes && !landed_.empty()) continue;
    add_landed(land_over(before));
  }
  possibilities_.least_hits += lands_always ? 1 : 0;
  possibilities_.most_hits += lands_ever ? 1 : 0;
}

// Outcomes that the piece being drawn landed in differ by what is stored alone: nearly always by nothing.
void Replay::add_landed(const Outcome& outcome) {
  for (const size_t place : landed_) {
    Outcome& known = possibilities_.outcomes[place];
    if (known.depth_writer == outcome.depth_writer) {
      unite(known, outcome);
      return;
    }
  }
  landed_.push_back(possibilities_.outcomes.size());
  possibilities_.outcomes.push_back(outcome);
}

// What may be stored after the layer landed in every outcome; or else, if it may be left out, too.
void Replay::store(const Layer& layer, bool must) {
  if (!compares_depth(layer.state)) {
    stored_.reset();
  } else if (must) {
    stored_ = layer.depth;
  } else if (stored_) {
    stored_ = {.low = std::min(stored_->low, layer.depth.low), .high = std::max(stored_->high, layer.depth.high)};
  }
}

// Whether the tests pass, or fail, whatever is stored; none where that decides.
std::optional<bool> Replay::passes_everywhere(Layer& layer, double x, double y) {
  if (layer.piece.of_polygon || layer.state.depth_bounds) return std::nullopt;
  if (case_.target.depth_format == VK_FORMAT_UNDEFINED || !layer.state.depth_test) return true;
  if (!compares_depth(layer.state)) return layer.state.depth_compare == VK_COMPARE_OP_ALWAYS;
  if (!stored_) find_stored(x, y);
  if (layer.is_inside) {
    layer.depth = depth_range_inside(layer.number, x, y);
    if (const std::optional<bool> passes = passes_all_stored(layer)) {
      stored_is_rough_ = true;
      return passes;
    }
  }
  layer.depth = depth_of(layer.number, x, y);
  if (stored_is_rough_) find_stored(x, y);
  return passes_all_stored(layer);
}

// The same, if both depths tell.
std::optional<bool> Replay::passes_all_stored(Layer& layer) const {
  const VkCompareOp op = layer.state.depth_compare;
  if (layer.depth.high < stored_->low) {
    layer.to_stored = Relation::kLess;
    return (op & VK_COMPARE_OP_LESS) != 0;
  }
  if (layer.depth.low > stored_->high) {
    layer.to_stored = Relation::kGreater;
    return (op & VK_COMPARE_OP_GREATER) != 0;
  }
  return std::nullopt;
}

void Replay::find_stored(double x, double y) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  exact::DepthRange all{.low = kInfinity, .high = -kInfinity};
  for (const Outcome& outcome : possibilities_.outcomes) {
    const exact::DepthRange one = depth_of(outcome.depth_writer, x, y);
    all = {.low = std::min(all.low, one.low), .high = std::max(all.high, one.high)};
  }
  stored_ = all;
  stored_is_rough_ = false;
}

// What may be stored for the piece, or, for none, what the target was cleared to. Asked for again by each layer.
exact::DepthRange Replay::depth_of(uint32_t piece, double x, double y) {
  if (piece == kNoOwner) return exact::stored_clear(case_.target.depth_format, case_.target.clear_depth, false);
  SampleDepth& known = depths_[piece];
  if (known.asked != asked_) known = {.asked = asked_, .range = depth_range_of(piece, x, y)};
  return known.range;
}

exact::DepthRange Replay::depth_range_of(uint32_t piece, double x, double y) {
  if (!has_values(expectation_.pieces()[piece])) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {.low = -kInfinity, .high = kInfinity};
  }
  const RasterState& state = case_.draws[expectation_.pieces()[piece].draw].state;
  return range_in(case_.target.depth_format, state, values_.values(piece).depth(x, y));
}

// A wider range of a piece that must cover the sample, which is cheaper to tell, and nearly always tells enough.
exact::DepthRange Replay::depth_range_inside(uint32_t piece, double x, double y) {
  if (!has_values(expectation_.pieces()[piece])) return depth_range_of(piece, x, y);
  const RasterState& state = case_.draws[expectation_.pieces()[piece].draw].state;
  return range_in(case_.target.depth_format, state, values_.values(piece).depth_inside(x, y));
}

// What is stored has to be within the bounds; a fixed-point format may round them too.
Replay::DepthResult Replay::bounds_test(const DepthBounds& bounds, uint32_t stored, double x, double y) {
  const exact::DepthRange present = depth_of(stored, x, y);
  const double step = 2 * exact::half_step(case_.target.depth_format);
  const double min{bounds.min};
  const double max{bounds.max};
  if (present.low >= min + step && present.high <= max - step) return DepthResult::kPasses;
  if (present.high < min - step || present.low > max + step) return DepthResult::kFails;
  return DepthResult::kEither;
}

Replay::DepthResult Replay::tests(const Layer& layer, uint32_t stored, double x, double y) {
  // Without a depth attachment both tests pass.
  if (case_.target.depth_format == VK_FORMAT_UNDEFINED) return DepthResult::kPasses;
  DepthResult result = DepthResult::kPasses;
  if (layer.state.depth_bounds) result = bounds_test(*layer.state.depth_bounds, stored, x, y);
  if (!layer.state.depth_test || result == DepthResult::kFails) return result;
  const DepthResult by_depth = depth_test(layer, stored, x, y);
  return by_depth == DepthResult::kPasses ? result : by_depth;
}

bool Replay::any_order(const Layer& layer, uint32_t stored) const {
  return layer.piece.of_polygon && stored != kNoOwner && layer.piece.owner == expectation_.pieces()[stored].owner;
}

Replay::DepthResult Replay::depth_test(const Layer& layer, uint32_t stored, double x, double y) {
  const VkCompareOp op = layer.state.depth_compare;
  if (op == VK_COMPARE_OP_ALWAYS) return DepthResult::kPasses;
  if (op == VK_COMPARE_OP_NEVER) return DepthResult::kFails;
  if (any_order(layer, stored)) return DepthResult::kEither;
  const exact::DepthRange present = depth_of(stored, x, y);
  bool may_be_less = layer.depth.low < present.high;
  bool may_be_greater = layer.depth.high > present.low;
  const bool may_be_equal = layer.depth.low <= present.high && layer.depth.high >= present.low;
  if (stored != kNoOwner && may_be_equal && same_geometry(case_, layer.piece, expectation_.pieces()[stored])) {
    may_be_less = false;
    may_be_greater = false;
  }
  const auto bit = static_cast<uint32_t>(op);  // less 1, equal 2, greater 4: VkCompareOp is made of them
  const bool passes_ever =
      (may_be_less && (bit & 1U) != 0) || (may_be_equal && (bit & 2U) != 0) || (may_be_greater && (bit & 4U) != 0);
  const bool fails_ever =
      (may_be_less && (bit & 1U) == 0) || (may_be_equal && (bit & 2U) == 0) || (may_be_greater && (bit & 4U) == 0);
  if (passes_ever && fails_ever) return DepthResult::kEither;
  return passes_ever ? DepthResult::kPasses : DepthResult::kFails;
}

std::optional<Landed> landed_of(const Possibilities& possible) {
  if (possible.in_doubt || possible.undefined || possible.outcomes.size() != 1) return std::nullopt;
  const Outcome& only = possible.outcomes.front();
  if (!only.owner_certain || !only.depth_certain || possible.least_hits != possible.most_hits) return std::nullopt;
  return Landed{.piece = only.piece, .depth_writer = only.depth_writer, .hits = possible.least_hits};
}

OracleAnswer answer_of(const Possibilities& possible) {
  OracleAnswer answer;
  const auto covers = std::ranges::count_if(possible.outcomes, [](const Outcome& o) { return o.owner != kNoOwner; });
  if (covers > 0) {
    const bool always = static_cast<size_t>(covers) == possible.outcomes.size();
    answer.coverage = always ? OracleAnswer::Coverage::kMust : OracleAnswer::Coverage::kMay;
  }
  if (possible.undefined) answer.coverage = OracleAnswer::Coverage::kUndefined;
  const auto is_first = [&](const Outcome& outcome) { return outcome.owner == possible.outcomes.front().owner; };
  if (!possible.outcomes.empty() && std::ranges::all_of(possible.outcomes, is_first)) {
    answer.owner = possible.outcomes.front().owner;
  }
  return answer;
}

}  // namespace fillrule::judge
