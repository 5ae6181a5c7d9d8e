// What the specification says of a whole case, for a party of given subpixel bits: at each sample the pieces of
// primitives that must or may land there, in submission order, culling and scissor applied, the depth test not yet.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "cases/model/case.h"
#include "reference/exact/piece_values.h"
#include "reference/exact/shape.h"
#include "reference/exact/triangle.h"

namespace fillrule::exact {

// What is rasterized on its own: a triangle, a line or a point, or an edge or a corner of a polygon that is drawn as
// lines or points. The pieces of a polygon have one owner.
struct Piece {
  enum class Kind : uint8_t { kTriangle, kLine, kBresenhamLine, kPoint, kClipEdges };

  uint32_t owner = 0;  // the primitive, counted over all draws of the case: what the planes show
  uint32_t draw = 0;   // index into Case::draws
  Kind kind = Kind::kTriangle;
  std::array<uint32_t, 3> vertices{};  // of the draw
  uint32_t provoking = 0;              // the vertex of the draw that flat varyings come from
  std::unique_ptr<const Shape> shape;
  Latitude latitude;
  bool front_facing = false;
  bool facing_in_doubt = false;       // rounding may turn it over
  bool culled = false;                // if rounding does not turn it over
  bool thin = false;                  // its values are undefined ground
  bool open = false;                  // whether it is drawn at all is left open: it must not cover anything, but may
  bool of_polygon = false;            // an edge or a corner: in which order a polygon's are drawn is left open
  std::array<uint32_t, 3> polygon{};  // ... and the vertices of that polygon

  // The shape of a triangle; null for any other kind.
  [[nodiscard]] const Triangle* triangle() const {
    return kind == Kind::kTriangle ? static_cast<const Triangle*>(shape.get()) : nullptr;
  }
};

// One piece at one sample.
struct Entry {
  uint32_t piece = 0;                  // index into Expectation::pieces()
  Coverage coverage = Coverage::kMay;  // kMay or kMust
  DoubtBits doubt = 0;
  bool operator==(const Entry&) const = default;
};

// The class of samples at which nothing can land.
inline constexpr uint32_t kNothing = 0;

class Expectation {
 public:
  Expectation(const Case& test_case, uint32_t subpixel_bits);
  // Of these samples alone, ascending: cheap for a few. Nothing is to be asked of others.
  Expectation(const Case& test_case, uint32_t subpixel_bits, std::span<const size_t> samples);

  // In the order in which they are drawn.
  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }

  // For each sample the number of its class: all samples of a class have the same entries. Neighbours with the same
  // entries are of one class, with few exceptions.
  [[nodiscard]] const std::vector<uint32_t>& classes() const { return classes_; }

  // The number of the piece that must cover the samples of a class while no other one may, if it is like that.
  [[nodiscard]] std::optional<uint32_t> sole(uint32_t number) const;

  // All entries of a sample, in submission order.
  void collect(size_t sample, std::vector<Entry>& entries) const;

 private:
  // What makes a class: the entries of another one, and this one after them. kNothing has none.
  struct Class {
    uint32_t before = kNothing;
    Entry last;
  };
  // Samples [begin, end) that are classified alike.
  struct Classified {
    size_t begin = 0;
    size_t end = 0;
    Classification classification;
  };
  void add_all(const Case& test_case, uint32_t subpixel_bits);
  void add_draw(const Case& test_case, uint32_t draw, uint32_t first_primitive, uint32_t subpixel_bits);
  void add_piece(const Case& test_case, Piece added);
  // Each calls visit(Classified) for what the piece must or may cover of the pixels.
  template <typename Visit>
  void classify_pixels(const Case& test_case, const Piece& piece, const VkRect2D& pixels, const Visit& visit) const;
  template <typename Visit>
  void classify_rows(const Case& test_case, const Piece& piece, const VkRect2D& pixels, DoubtBits undecided,
                     const Visit& visit) const;
  template <typename Visit>
  void classify_block(const Case& test_case, const Piece& piece, const VkRect2D& block, DoubtBits undecided,
                      const Visit& visit) const;
  template <typename Visit>
  void classify_samples(const Case& test_case, const Piece& piece, const VkRect2D& block, DoubtBits undecided,
                        const Visit& visit) const;
  void append(const Classified& classified, uint32_t number);
  [[nodiscard]] uint32_t class_after(uint32_t before, const Entry& entry);

  std::vector<VkOffset2D> some_pixels_;  // that are asked about alone; empty: all
  std::vector<Piece> pieces_;
  std::vector<uint32_t> classes_;
  std::vector<Class> made_of_;  // for each class
};

// A polygon with everything that it is clipped to.
Triangle triangle_of(const Draw& draw, const std::array<uint32_t, 3>& vertices);

// The exact values of a piece, which has to stay where it is. Not for pieces that are undefined or have no area.
std::unique_ptr<PieceValues> values_of(const Case& test_case, const Piece& piece);

}  // namespace fillrule::exact
