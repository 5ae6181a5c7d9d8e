// What a triangle covers of rows of samples.
//
// The distance from a boundary is linear along a row, and what rounding reaches is the same all along. So there are
// first samples outside of the boundary, then such as rounding may move to either side, then those inside; or the
// other way round. Where one kind ends and the next begins is guessed, and then found by asking the samples around.
// What lies between two samples that were asked follows, whatever the guess was.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "reference/exact/triangle.h"

namespace fillrule::exact {

// Of a row's samples those in [may_begin, may_end) may be covered, and those in [must_begin, must_end) must be. The
// rest of the former has to be asked one by one.
struct RowCoverage {
  uint32_t may_begin = 0;
  uint32_t may_end = 0;
  uint32_t must_begin = 0;
  uint32_t must_end = 0;
};

class TriangleRows {
 public:
  // The boundaries that can be asked about.
  static constexpr DoubtBits kBoundaries = kDoubtEdges | kDoubtNear | kDoubtFar | kDoubtViewport;

  // All samples that will be asked about are in the block. The triangle, which has to stay where it is, is neither
  // undefined nor without area.
  TriangleRows(const Triangle& triangle, const Latitude& latitude, const Block& samples, DoubtBits undecided);

  // The samples at (x + i, y), i from 0 to `count`.
  [[nodiscard]] RowCoverage at(double x, double y, uint32_t count) const;

 private:
  struct Boundary {
    LinearForm form;
    int number = 0;     // BoundaryNumber
    double reach = 0;   // how far rounding moves it
    double slack = 0;   // what its distance errs at most, and the reach
    double pixels = 0;  // in which the distance changes by 1; infinite if it is the same all along
    bool falls = false;
  };
  void add(const LinearForm& form, int number, const Block& samples);
  [[nodiscard]] std::span<const Boundary> boundaries() const { return {boundaries_.data(), count_}; }
  [[nodiscard]] Coverage coverage_at(const Boundary& boundary, double x, double y) const;
  void meet(const Boundary& boundary, double x, double y, uint32_t count, RowCoverage& row) const;
  void meet_viewport(double x, double y, RowCoverage& row) const;

  const Triangle* triangle_;
  Latitude latitude_;
  std::array<Boundary, 5> boundaries_;
  size_t count_ = 0;
  bool asks_viewport_;
  bool is_certain_ = true;  // which way each distance rises
};

}  // namespace fillrule::exact
