// Setup of whole triangles, neither clipped nor dropped for their distances, lane by lane of several: what
// setup_whole_triangle() of primitive_setup.h does of one. L is a lane type (lanes.h) of more than one lane.
//
// Of tiny triangles it also finds out which pixels they cover: of triangles as small as a pixel many cover none, and
// to store those, to sort them into tiles and to look at them there would be most of the work.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "renderer/lanes.h"
#include "renderer/primitive_setup.h"

namespace fillrule::renderer::internal {

// Where tiny triangles are covered: in draws of one sample a pixel.
struct TinyCoverage {
  bool is_wanted = false;
  FixedPosition sample_fixed;  // within a pixel
};

// Triangles by lanes, and what is found out about them.
template <typename L>
class TriangleLanes {
 public:
  static constexpr uint32_t kTriangles = 64;  // some vectors of them: what is put is not read at once
  static_assert(kTriangles % L::kWidth == 0);

  [[gnu::always_inline]] void put(uint32_t at, const FixedPosition& a, const FixedPosition& b,
                                  const FixedPosition& c) {
    corners_[0][at] = a;
    corners_[1][at] = b;
    corners_[2][at] = c;
  }

  // Of the first `count` of them, which must have been put.
  [[gnu::always_inline]] void set_up(const SetupState& state, const TinyCoverage& tiny, uint32_t count) {
    visible_ = front_facing_ = too_large_ = 0;
    for (uint32_t i = count; i % L::kWidth != 0; ++i) {
      put(i, {}, {}, {});  // lanes of the last vector that are none of the triangles
    }
    for (uint32_t first = 0; first < count; first += L::kWidth) {
      set_up_lanes(state, tiny, first);
    }
  }

  // Bit i: triangle i may cover a sample.
  [[nodiscard]] uint64_t visible() const { return visible_; }
  // Those about which nothing else is known: lanes have not the digits for them.
  [[nodiscard]] uint64_t too_large() const { return too_large_; }

  // Of a visible triangle.
  [[gnu::always_inline]] void get(uint32_t at, SetupPrimitive& filled) const {
    filled.front_facing = (front_facing_ >> at & 1U) != 0;
    filled.set_bounds({bounds_[0][at], bounds_[1][at], bounds_[2][at], bounds_[3][at]});
    filled.set_covered_pixels(static_cast<uint32_t>(covered_[at]));
  }

 private:
  using Int = typename L::Int;
  using Values = std::array<int32_t, kTriangles>;

  struct Corner {
    Int x;
    Int y;
  };
  struct Bounds {
    Int left;
    Int top;
    Int right;
    Int bottom;
  };
  // Along a coordinate.
  struct Extent {
    Int least;
    Int greatest;
    [[nodiscard, gnu::always_inline]] Int length() const { return greatest - least; }
  };

  [[gnu::always_inline]] static Int lesser(const Int& a, const Int& b) { return a < b ? a : b; }
  [[gnu::always_inline]] static Int greater(const Int& a, const Int& b) { return a > b ? a : b; }

  [[gnu::always_inline]] static Extent extent(const Int& a, const Int& b, const Int& c) {
    return {lesser(lesser(a, b), c), greater(greater(a, b), c)};
  }

  // As first_pixel() of fixed_point.h.
  [[gnu::always_inline]] static Int first_pixels(const Int& coordinates, int32_t sample, uint32_t subpixel_bits) {
    return (coordinates + ((1 << subpixel_bits) - 1 - sample)) >> static_cast<int32_t>(subpixel_bits);
  }

  [[gnu::always_inline]] static uint64_t bits_of(const typename L::Mask& mask) { return L::bits_of(mask); }

  // Twice the signed area (edge_function.h), rounded to a float. The sign is exact where coordinates differ by less
  // than 2^26: then both products are less than 2^52, and a whole number is only rounded to 0 if it is.
  [[gnu::always_inline]] static typename L::Float area(const Corner& a, const Corner& b, const Corner& c) {
    const auto product = [](const Int& p, const Int& q) __attribute__((always_inline)) {
      return L::to_double(p) * L::to_double(q);
    };
    return L::to_float(product(b.x - a.x, c.y - a.y) - product(c.x - a.x, b.y - a.y));
  }

  [[nodiscard, gnu::always_inline]] Corner corner(size_t vertex, uint32_t first) const {
    const auto [x, y] = L::load_pairs(&corners_[vertex][first].x_fixed);
    return {x, y};
  }

  [[gnu::always_inline]] static Bounds bounds(const SetupState& state, const Extent& xs, const Extent& ys) {
    const uint32_t bits = state.transform.subpixel_bits();
    const PixelRect& clip = state.clip_pixels;
    return {greater(first_pixels(xs.least, state.greatest_sample.x_fixed, bits), clip.left + Int{}),
            greater(first_pixels(ys.least, state.greatest_sample.y_fixed, bits), clip.top + Int{}),
            lesser(first_pixels(xs.greatest, state.least_sample.x_fixed, bits), clip.right + Int{}),
            lesser(first_pixels(ys.greatest, state.least_sample.y_fixed, bits), clip.bottom + Int{})};
  }

  [[gnu::always_inline]] void set_up_lanes(const SetupState& state, const TinyCoverage& tiny, uint32_t first) {
    constexpr int32_t kExactExtent = 1 << 26;
    const Corner a = corner(0, first);
    const Corner b = corner(1, first);
    const Corner c = corner(2, first);
    const Extent xs = extent(a.x, b.x, c.x);
    const Extent ys = extent(a.y, b.y, c.y);
    const Int length = greater(xs.length(), ys.length());
    const Bounds pixels = bounds(state, xs, ys);
    const typename L::Float doubled_area = area(a, b, c);

    const uint64_t exact = bits_of(length < kExactExtent);
    const uint64_t clockwise = bits_of(doubled_area > L::all(0.0F));
    const uint64_t counter_clockwise = bits_of(doubled_area < L::all(0.0F));
    const bool is_front_clockwise = state.front_face != VK_FRONT_FACE_COUNTER_CLOCKWISE;
    const uint64_t front = is_front_clockwise ? clockwise : counter_clockwise;
    const uint64_t back = is_front_clockwise ? counter_clockwise : clockwise;
    uint64_t visible = ((state.cull_mode & VK_CULL_MODE_FRONT_BIT) != 0 ? 0 : front) |
                       ((state.cull_mode & VK_CULL_MODE_BACK_BIT) != 0 ? 0 : back);
    visible &= exact & bits_of((pixels.left < pixels.right) & (pixels.top < pixels.bottom));

    Int covered{};
    if (tiny.is_wanted && visible != 0) {
      const Int width = pixels.right - pixels.left;
      const auto is_tiny =
          (length < kTinyExtent) & (width > 0) & (width <= kTinyWidth) & (pixels.bottom - pixels.top <= kTinyHeight);
      const auto turned = doubled_area < L::all(0.0F);
      const std::array<Corner, 3> triangle{
          {a, {turned ? c.x : b.x, turned ? c.y : b.y}, {turned ? b.x : c.x, turned ? b.y : c.y}}};
      covered = covered_pixels(triangle, pixels, is_tiny, tiny.sample_fixed, state.transform.subpixel_bits());
      visible &= ~bits_of(is_tiny & (covered == 0));
    }
    L::store(pixels.left, bounds_[0].data() + first);
    L::store(pixels.top, bounds_[1].data() + first);
    L::store(pixels.right, bounds_[2].data() + first);
    L::store(pixels.bottom, bounds_[3].data() + first);
    L::store(covered, covered_.data() + first);
    visible_ |= visible << first;
    front_facing_ |= front << first;
    constexpr uint64_t kAllLanes = (1U << L::kWidth) - 1;
    too_large_ |= (~exact & kAllLanes) << first;
  }

  // A tiny triangle's coordinates differ by so little that edge functions fit an int32, with room to spare, on every
  // pixel of the rectangles; its rectangle is SetupPrimitive::covered_pixels()'s at most.
  static constexpr int32_t kTinyExtent = 1 << 13;
  static constexpr int32_t kTinyWidth = SetupPrimitive::kCoveredWidth;
  static constexpr int32_t kTinyHeight = SetupPrimitive::kCoveredHeight;

  // An edge function (edge_function.h), and by how much it changes from pixel to pixel.
  struct Edge {
    Int value;
    Int step_x;
    Int step_y;
  };

  // At the first pixel of each rectangle, of triangles with positive area. Those that are not tiny have steps of 0,
  // so that nothing overflows.
  [[gnu::always_inline]] static Edge edge(const Corner& from, const Corner& to, const Bounds& pixels,
                                          const Int& is_tiny, const FixedPosition& sample_fixed,
                                          uint32_t subpixel_bits) {
    const auto bits = static_cast<int32_t>(subpixel_bits);
    const Int dx = is_tiny & (to.x - from.x);
    const Int dy = is_tiny & (to.y - from.y);
    const Int x = (pixels.left << bits) + sample_fixed.x_fixed - from.x;
    const Int y = (pixels.top << bits) + sample_fixed.y_fixed - from.y;
    const Int is_top_left = (dy < 0) | ((dy == 0) & (dx > 0));  // -1 or 0
    return {(y * dx - x * dy + ~is_top_left) >> bits, -dy, dx};
  }

  // As SetupPrimitive::covered_pixels() has them, of the tiny triangles; 0 of the others.
  [[gnu::always_inline]] static Int covered_pixels(const std::array<Corner, 3>& triangle, const Bounds& pixels,
                                                   const Int& is_tiny, const FixedPosition& sample_fixed,
                                                   uint32_t subpixel_bits) {
    Edge edge0 = edge(triangle[0], triangle[1], pixels, is_tiny, sample_fixed, subpixel_bits);
    Edge edge1 = edge(triangle[1], triangle[2], pixels, is_tiny, sample_fixed, subpixel_bits);
    Edge edge2 = edge(triangle[2], triangle[0], pixels, is_tiny, sample_fixed, subpixel_bits);
    const Int widths = is_tiny & (pixels.right - pixels.left);
    const Int heights = is_tiny & (pixels.bottom - pixels.top);
    const Int columns = (1 << widths) - 1;  // of a row, those in the rectangle
    Int covered{};
    for (int32_t row = 0; row < kTinyHeight && L::any(heights > row); ++row) {
      Int value0 = edge0.value;
      Int value1 = edge1.value;
      Int value2 = edge2.value;
      Int in_row{};
      for (int32_t column = 0; column < kTinyWidth && L::any(widths > column); ++column) {
        in_row |= ((value0 | value1 | value2) >= 0) & L::all(1 << column);
        value0 += edge0.step_x;
        value1 += edge1.step_x;
        value2 += edge2.step_x;
      }
      covered |= (in_row & columns & (heights > row)) << (kTinyWidth * row);
      edge0.value += edge0.step_y;
      edge1.value += edge1.step_y;
      edge2.value += edge2.step_y;
    }
    return covered;
  }

  std::array<std::array<FixedPosition, kTriangles>, 3> corners_;
  std::array<Values, 4> bounds_;  // left, top, right, bottom; pixels
  Values covered_;
  uint64_t visible_ = 0;
  uint64_t front_facing_ = 0;
  uint64_t too_large_ = 0;
};

}  // namespace fillrule::renderer::internal
