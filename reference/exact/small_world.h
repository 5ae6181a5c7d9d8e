// The oracle's small-world form: the coverage of every triangle whose vertices lie on a grid of 1/grid pixels in a
// cell of size x size pixels, by integers alone and fast enough to be asked for all of them.
//
// A sample is inside of a directed edge from a to b where E = (b - a) x (sample - a) > 0, framebuffer coordinates, y
// down, or where E = 0 and the edge is a top or a left one: the same half-planes, with the same ties, as
// Triangle::owns() has them (small_world_test.cpp holds one against the other). So one mask for each directed edge
// is computed once, and the coverage of a triangle is the meet of three. Ties on the edges follow the top-left rule,
// which Vulkan does not ask for: whoever differs on ties alone is within Triangle::classify()'s kMay.
//
// Units: grid steps from the cell's top left corner; position number y * (grid * size + 1) + x.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fillrule::exact {

// A bit for each pixel of a cell, row by row from the top left.
using CellMask = uint16_t;
inline constexpr uint32_t kMaxCellSize = 4;  // pixels

struct GridPosition {
  uint32_t x = 0;  // grid steps
  uint32_t y = 0;
};

// What a triangle covers. It has one winding (as seen on the framebuffer): at most one of the masks has bits. A
// triangle without area covers nothing.
struct WoundCoverage {
  CellMask clockwise = 0;
  CellMask counter_clockwise = 0;
};

class SmallWorld {
 public:
  // `size` is 1 to kMaxCellSize. The table takes 4 bytes for each directed edge.
  SmallWorld(uint32_t grid, uint32_t size);

  [[nodiscard]] uint32_t positions() const { return side_ * side_; }
  [[nodiscard]] GridPosition position(uint32_t number) const { return {number % side_, number / side_}; }

  // The samples on the inner side of the edge from position a to position b, if the triangle is clockwise. Nothing
  // where a = b.
  [[nodiscard]] CellMask edge(uint32_t a, uint32_t b) const { return edges_[size_t{a} * positions() + b]; }

  [[nodiscard]] WoundCoverage coverage(uint32_t a, uint32_t b, uint32_t c) const {
    // No sample is outside of all three edges of a triangle; so the meet for the other winding is empty by itself.
    // Without area, two of the edges point opposite ways on one line, or one of them is no edge.
    const auto meet = [](unsigned p, unsigned q, unsigned r) { return static_cast<CellMask>(p & q & r); };
    return {.clockwise = meet(edge(a, b), edge(b, c), edge_to(a, c)),
            .counter_clockwise = meet(edge_to(a, b), edge_to(b, c), edge(a, c))};
  }

 private:
  // The edge from `from` to `to`, out of the transposed table: walks over `from` find neighbours in memory.
  [[nodiscard]] CellMask edge_to(uint32_t to, uint32_t from) const {
    return transposed_edges_[size_t{to} * positions() + from];
  }

  uint32_t side_;  // positions in a row
  std::vector<CellMask> edges_;
  std::vector<CellMask> transposed_edges_;
};

}  // namespace fillrule::exact
