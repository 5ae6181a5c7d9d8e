// What may be found at one sample after everything has been drawn: the oracle's entries for it, replayed through
// the depth test with every outcome that the specification allows.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "harness/judge/verdict.h"
#include "reference/exact/expectation.h"
#include "reference/exact/value_bound.h"

namespace fillrule::judge {

// One way in which the sample may end up.
struct Outcome {
  uint32_t owner = kNoOwner;         // the primitive that landed last, as the planes number them
  uint32_t piece = kNoOwner;         // the piece of it (Expectation::pieces())
  uint32_t depth_writer = kNoOwner;  // the piece whose depth is stored; none: the clear value
  bool owner_certain = false;        // that piece must cover the sample
  bool depth_certain = false;
  bool operator==(const Outcome&) const = default;
};

struct Possibilities {
  uint32_t least_hits = 0;
  uint32_t most_hits = 0;
  bool in_doubt = false;   // the coverage of some piece is left open here
  bool undefined = false;  // ... because the piece is undefined
  std::vector<Outcome> outcomes;
};

// What has landed where everything is certain.
struct Landed {
  uint32_t piece = kNoOwner;         // on top
  uint32_t depth_writer = kNoOwner;  // as in Outcome
  uint32_t hits = 0;
  bool operator==(const Landed&) const = default;
};
std::optional<Landed> landed_of(const Possibilities& possible);

// The same in short.
OracleAnswer answer_of(const Possibilities& possible);

// Caches the exact values of a case's pieces while its samples are judged.
class ValueCache {
 public:
  ValueCache(const Case& test_case, const exact::Expectation& expectation)
      : case_(test_case), expectation_(expectation), values_(expectation.pieces().size()) {}

  [[nodiscard]] const exact::PieceValues& values(uint32_t piece);
  // Those of a triangle.
  [[nodiscard]] const exact::TriangleValues& triangle(uint32_t piece) {
    return static_cast<const exact::TriangleValues&>(values(piece));
  }

 private:
  const Case& case_;
  const exact::Expectation& expectation_;
  std::vector<std::unique_ptr<exact::PieceValues>> values_;
};

class Replay {
 public:
  // Where the vertices are exactly on the subpixel grid more may be asked for than the specification does: ties by
  // the top-left rule, Bresenham lines by the diamond-exit rule.
  struct Rules {
    bool top_left = false;
    bool diamond_exit = false;
  };
  Replay(const Case& test_case, const exact::Expectation& expectation, ValueCache& values, uint32_t subpixel_bits,
         Rules rules);

  // `index` is that of Planes. The result is valid until the next call.
  const Possibilities& at(size_t index);
  // The number of a replay: where it is the same as for the sample before, so is the result.
  [[nodiscard]] uint64_t number() const { return asked_; }
  // Whether the rules above decided about the sample asked for last; if not, they make no difference there.
  [[nodiscard]] bool used_rules() const { return used_rules_; }

  // Whether what is possible is the same at all samples from the first to the last, which are of one class
  // (Expectation::classes()) and row; at() is then asked for the last one. Only the ends are looked at: either
  // nothing depends on the place, or depths alone do. A depth, its tolerance added, is a convex function of the
  // place, and a concave one where it is taken away. So of two depths one is the less from end to end if it is at
  // both. (Doubles are within a millionth of the tolerance of all that, value_bound_test.cpp, as where a
  // sample is asked by itself.)
  bool is_same_between(size_t first, size_t last);
  // False where that cannot be told of any two samples of this one's class.
  [[nodiscard]] bool may_tell_between(size_t index);

 private:
  enum class DepthResult : uint8_t { kFails, kPasses, kEither };
  // Of a piece's depth to what is stored, whatever that is.
  enum class Relation : uint8_t { kNotAsked, kLess, kGreater };
  // The piece that is being drawn over what is there.
  struct Layer {
    uint32_t number = 0;
    const exact::Piece& piece;
    const RasterState& state;
    bool is_inside = false;     // it must cover the sample
    exact::DepthRange depth{};  // that it may have, once it is tested
    Relation to_stored = Relation::kNotAsked;
  };
  // What a piece may store, at the sample of this number.
  struct SampleDepth {
    uint64_t asked = 0;
    exact::DepthRange range;
  };

  void find_class(size_t index);
  [[nodiscard]] bool same_everywhere_of(const exact::Entry& entry) const;
  [[nodiscard]] bool by_depths_of(const exact::Entry& entry) const;
  void resolve_ties(double x, double y);
  // What the entries [begin, end) of the sample do to the outcomes so far.
  void replay(size_t begin, size_t end, double x, double y);
  bool replay_watertight(size_t begin, size_t end, double x, double y);
  void land(const exact::Entry& entry, bool must, double x, double y);
  [[nodiscard]] std::optional<bool> passes_everywhere(Layer& layer, double x, double y);
  [[nodiscard]] std::optional<bool> passes_all_stored(Layer& layer) const;
  void find_stored(double x, double y);
  void store(const Layer& layer, bool must);
  // Whether the stored piece is another part of the layer's outline: of two of them either may be drawn first.
  [[nodiscard]] bool any_order(const Layer& layer, uint32_t stored) const;
  [[nodiscard]] DepthResult depth_test(const Layer& layer, uint32_t stored, double x, double y);
  [[nodiscard]] bool resolved_on_grid(const exact::Entry& entry);
  [[nodiscard]] DepthResult bounds_test(const DepthBounds& bounds, uint32_t stored, double x, double y);
  // The depth test and the depth bounds test.
  [[nodiscard]] DepthResult tests(const Layer& layer, uint32_t stored, double x, double y);
  [[nodiscard]] exact::DepthRange depth_of(uint32_t piece, double x, double y);
  [[nodiscard]] exact::DepthRange depth_range_of(uint32_t piece, double x, double y);
  [[nodiscard]] exact::DepthRange depth_range_inside(uint32_t piece, double x, double y);
  void add_landed(const Outcome& outcome);

  const Case& case_;
  const exact::Expectation& expectation_;
  ValueCache& values_;
  uint32_t subpixel_bits_;
  Rules rules_;
  std::vector<uint8_t> on_grid_;     // for each piece: 0 not asked yet, 1 no, 2 yes
  std::vector<SampleDepth> depths_;  // for each piece
  uint64_t asked_ = 0;               // samples replayed so far
  size_t index_ = 0;                 // the last of them
  // Of the class of samples that was asked about last.
  struct Class {
    uint32_t number = exact::kNothing;
    std::vector<exact::Entry> entries;
    bool same_everywhere = true;  // nothing depends on the place
    bool by_depths = true;        // ... but comparisons of depths
  };
  Class class_;
  uint32_t class_of_answer_ = exact::kNothing;
  std::vector<exact::Entry> resolved_;     // by the rules
  std::span<const exact::Entry> entries_;  // of the sample
  std::vector<Outcome> before_;
  std::optional<exact::DepthRange> stored_;  // in any of the outcomes so far, if it was asked for
  bool stored_is_rough_ = false;             // ... and is wider than need be (depth_range_inside())
  std::vector<size_t> landed_;               // the outcomes in which the piece being drawn landed
  Possibilities possibilities_;
  bool used_rules_ = false;
  // Whether relations of depths decided about all entries of the sample, and which it was for each entry:
  // VkCompareOp's unequal passes with either, and what is less at one end and greater at the other is equal between.
  bool decided_by_relations_ = false;
  std::vector<Relation> relations_;
  std::vector<Relation> relations_before_;
};

}  // namespace fillrule::judge
