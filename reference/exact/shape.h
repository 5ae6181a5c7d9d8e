// What a piece of a primitive covers: the questions that the oracle answers for a triangle, a line or a point alike.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "reference/exact/latitude.h"
#include "reference/exact/samples.h"

namespace fillrule::exact {

enum class Coverage : uint8_t { kMustNot, kMay, kMust };

// How a distance inside of a boundary, known but for `slack`, compares with what rounding reaches, if it can be told.
inline std::optional<Coverage> decided(double inside, double reach, double slack) {
  if (inside > reach + slack) return Coverage::kMust;
  if (inside < -reach - slack) return Coverage::kMustNot;
  if (std::abs(inside) <= reach - slack) return Coverage::kMay;
  return std::nullopt;
}

// Which boundaries of a piece leave a sample in doubt. Bits 0 to 2 of a triangle: the edge opposite of vertex 0,
// 1, 2.
using DoubtBits = uint16_t;
inline constexpr DoubtBits kDoubtEdge0 = 1;
inline constexpr DoubtBits kDoubtEdges = 7;
// Lines and points do not tell their boundaries apart.
inline constexpr DoubtBits kDoubtShape = 8;
inline constexpr DoubtBits kDoubtNear = 0x10;
inline constexpr DoubtBits kDoubtFar = 0x20;
inline constexpr DoubtBits kDoubtViewport = 0x40;
inline constexpr DoubtBits kDoubtCull = 0x80;         // whether the piece is drawn at all
inline constexpr DoubtBits kDoubtClipPlane0 = 0x100;  // the user clip distances: this bit and those above
inline constexpr DoubtBits kDoubtClipPlanes = 0xFF00;

struct Classification {
  Coverage coverage = Coverage::kMustNot;
  DoubtBits doubt = 0;  // nonzero exactly if coverage is kMay
};

inline constexpr DoubtBits kEveryBoundary = 0xFFFF;

// What holds for every sample of a block; `undecided` are the boundaries that each sample has to be asked
// about where coverage is kMay. All others are further away than the latitude, on the inside.
struct BlockClassification {
  Coverage coverage = Coverage::kMay;
  DoubtBits undecided = kEveryBoundary;
};

// A rectangle of the framebuffer: a centre and half its size, in pixels.
struct Block {
  double x = 0;
  double y = 0;
  double half_width = 0;
  double half_height = 0;
};

inline std::vector<Position> corners(const Block& block) {
  const double left = block.x - block.half_width;
  const double right = block.x + block.half_width;
  const double top = block.y - block.half_height;
  const double bottom = block.y + block.half_height;
  return {{.x = left, .y = top}, {.x = right, .y = top}, {.x = right, .y = bottom}, {.x = left, .y = bottom}};
}

class Shape {
 public:
  virtual ~Shape() = default;

  // True where Vulkan says nothing: NaN, infinity, or coordinates whose products leave float32. The shape may then
  // cover anything inside the viewport, and has no values.
  [[nodiscard]] virtual bool undefined() const = 0;

  // True if no implementation has to clip it: every vertex is inside the view volume.
  [[nodiscard]] virtual bool inside_volume() const = 0;

  // The coverage of the sample at framebuffer position (x, y), culling and scissor left aside. Only the boundaries in
  // `undecided` are asked.
  [[nodiscard]] virtual Classification classify(double x, double y, const Latitude& latitude,
                                                DoubtBits undecided = kEveryBoundary) const = 0;

  // What is cheap to tell of all samples in the block at once. Only the boundaries in `undecided` are asked.
  [[nodiscard]] virtual BlockClassification classify_block(const Block& block, const Latitude& latitude,
                                                           DoubtBits undecided = kEveryBoundary) const = 0;

  // True if the sample is inside with ties resolved by the top-left rule on the exact edges: exactly one of two
  // triangles that share an edge owns a sample on it.
  [[nodiscard]] virtual bool owns(double x, double y) const = 0;

  // True if every vertex lies exactly on the grid of 2^-subpixel_bits pixels, and in front of the eye.
  [[nodiscard]] virtual bool on_grid(uint32_t subpixel_bits) const = 0;

  // The smallest rectangle (min x, min y, max x, max y; pixels) outside of which every sample is kMustNot.
  [[nodiscard]] virtual std::array<double, 4> bounds(const Latitude& latitude) const = 0;

  // The corners of a convex part of the block outside of which nothing of the shape is: where a centroid may lie.
  // Empty if there is none.
  [[nodiscard]] virtual std::vector<Position> part_in(const Block& block, const Latitude& /*latitude*/) const {
    return corners(block);
  }

 protected:
  Shape() = default;
  Shape(const Shape&) = default;
  Shape& operator=(const Shape&) = default;
  Shape(Shape&&) = default;
  Shape& operator=(Shape&&) = default;
};

}  // namespace fillrule::exact
