// The programs, and the way from the coverage of a primitive in a tile to fragments: the per-sample operations and
// the fragment program (Vulkan, "Fragment Operations", "Sample Shading").
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "renderer/color.h"
#include "renderer/interpolation.h"
#include "renderer/isa.h"
#include "renderer/prepared_draw.h"
#include "renderer/tile_bins.h"

namespace fillrule::renderer {

// A primitive about to be shaded.
struct ShadedPrimitive {
  using Lanes = ScalarLanes;

  uint32_t primitive = 0;  // within the draw; culled, clipped and degenerate ones are counted
  // The provoking one first; the weights' order. A primitive of fewer vertices repeats its last.
  std::array<uint32_t, 3> vertices{};
  bool front_facing = false;
  const PrimitiveInterpolation* interpolation = nullptr;
  int32_t anchor_x = 0;  // of the planes of varyings: a pixel of the tile, near the primitive
  int32_t anchor_y = 0;

  // Of varyings whose value at a vertex is `of(vertex)`, a Vec4: smooth, or of the provoking vertex.
  template <typename Of>
  [[nodiscard, gnu::always_inline]] VaryingPlanes<> smooth(const Of& of) const {
    return smooth_planes(*interpolation, anchor_x, anchor_y, of(vertices[0]), of(vertices[1]), of(vertices[2]));
  }
  template <typename Of>
  [[nodiscard, gnu::always_inline]] Vec4 flat(const Of& of) const {
    return of(vertices[0]);
  }
};

// As many primitives about to be shaded as there are lanes: their varyings, as ShadedPrimitive has them of one. L is
// a lane type (lanes.h).
template <typename L>
struct PrimitiveLanes {
  using Lanes = L;
  using Weights = std::array<typename L::Double, 3>;

  std::array<const SetupPrimitive*, L::kWidth> primitives;
  // Of the vertices, divided by w (interpolation.h): at the pixel at which the planes of varyings are anchored.
  Weights at_anchor;
  Weights step_x;
  Weights step_y;

  template <typename Of>
  [[nodiscard, gnu::always_inline]] VaryingPlanes<L> smooth(const Of& of) const {
    const std::array<Color<L>, 3> values{values_at<0>(of), values_at<1>(of), values_at<2>(of)};
    VaryingPlanes<L> planes;
    for (size_t component = 0; component < 4; ++component) {
      const auto a = L::to_double(values[0][component]);
      const auto b = L::to_double(values[1][component]);
      const auto c = L::to_double(values[2][component]);
      const auto sum = [&](const Weights& weights) __attribute__((always_inline)) {
        return L::to_float(weights[0] * a + weights[1] * b + weights[2] * c);
      };
      planes.at_anchor[component] = sum(at_anchor);
      planes.step_x[component] = sum(step_x);
      planes.step_y[component] = sum(step_y);
    }
    return planes;
  }
  template <typename Of>
  [[nodiscard, gnu::always_inline]] Color<L> flat(const Of& of) const {
    return values_at<0>(of);
  }

 private:
  template <size_t kVertex, typename Of>
  [[nodiscard, gnu::always_inline]] Color<L> values_at(const Of& of) const {
    return L::load_components([&](uint32_t lane) __attribute__((always_inline)) {
      return of(primitives[lane]->indices[kVertex]).data();
    });
  }
};

// As that of one primitive (color.h).
template <typename L>
[[gnu::always_inline]] inline VaryingPlane<L> reciprocal_w_plane(const PrimitiveLanes<L>& primitives) {
  const auto sum = [](const typename PrimitiveLanes<L>::Weights& l) __attribute__((always_inline)) {
    return L::to_float(l[0] + l[1] + l[2]);
  };
  return {.at_anchor = sum(primitives.at_anchor), .step_x = sum(primitives.step_x), .step_y = sum(primitives.step_y)};
}

// A fragment that passed the depth test at one of its samples at least.
struct Fragment {
  // Framebuffer coordinates of its pixel; the pixel's centre is at x + 0.5, y + 0.5.
  int32_t x = 0;
  int32_t y = 0;
  uint32_t samples = 1;   // bit i: it lands on sample i; one of them under sample shading
  WindowOffset position;  // gl_FragCoord.xy: the sample's location under sample shading, else the centre
  WindowOffset centroid;  // a point of both the pixel and the primitive
  const PrimitiveInterpolation& interpolation;

  [[nodiscard]] PixelWeights weights(const WindowOffset& from_centre = {}) const {
    return interpolation.weights_at(x, y, from_centre);
  }

  // gl_FragCoord: framebuffer x and y, the depth with its bias but neither clamped nor quantised, and 1/w.
  [[nodiscard]] std::array<float, 4> frag_coord() const {
    return {static_cast<float>(x + 0.5 + position.x), static_cast<float>(y + 0.5 + position.y),
            finite_float(interpolation.depth_at(x, y, position)),
            finite_float(interpolation.reciprocal_w_at(x, y, position))};
  }

  // gl_PointCoord; 0 of anything but points.
  [[nodiscard]] std::array<float, 2> point_coord() const { return interpolation.point_coord_at(x, y, position); }
};

// What every program has.
template <typename P>
concept PrimitiveProgram = requires(const P& program, uint32_t vertex, const ShadedPrimitive& primitive) {
  // The vertex program: the position in clip space. Called once for each vertex.
  { program.position(vertex) } -> std::convertible_to<ClipPosition>;
  // What the fragments of a primitive share. Called once for each primitive and tile.
  program.primitive_data(primitive);
};
template <PrimitiveProgram P>
using PrimitiveData = decltype(std::declval<const P&>().primitive_data(std::declval<const ShadedPrimitive&>()));

// A program of fragments one by one, which does with them whatever it likes.
template <typename P>
concept FragmentProgram = PrimitiveProgram<P> &&
    requires(const P& program, const PrimitiveData<P>& data, const Fragment& fragment) {
  // The fragment program: writes wherever it likes for this pixel.
  program.fragment(data, fragment);
};

// A fragment program that takes the fragments of a block of 8x8 pixels at once where each pixel has one sample, which
// all of them land on: bit 8 * row + column of `landed`. L are the lanes of the chosen instruction set (lanes.h), for
// which it must be inlined always.
template <typename P>
concept BlockProgram = FragmentProgram<P> &&
    requires(const P& program, const PrimitiveData<P>& data, int32_t x, int32_t y, uint64_t landed,
             const PrimitiveInterpolation& interpolation) {
  program.template block<ScalarLanes>(data, x, y, landed, interpolation);
};

// A program that gives fragments their colour for the colour attachment, as many at once as there are lanes:
//   template <typename L> [[gnu::always_inline]] Color<L> color(const Data& data, const FragmentLanes<L>&) const;
template <typename P>
concept ColorProgram = PrimitiveProgram<P> &&
    requires(const P& program, const PrimitiveData<P>& data, const FragmentLanes<ScalarLanes>& fragments) {
  { program.template color<ScalarLanes>(data, fragments) } -> std::same_as<Color<ScalarLanes>>;
};

// One whose primitive_data() and color() also take as many primitives as there are lanes: tiny ones are then shaded
// several at once (tiny_shader.h).
template <typename P>
concept LaneProgram = ColorProgram<P> && requires(const P& program, const PrimitiveLanes<ScalarLanes>& primitives,
                                                  const FragmentLanes<ScalarLanes>& fragments) {
  {
    program.template color<ScalarLanes>(program.primitive_data(primitives), fragments)
    } -> std::same_as<Color<ScalarLanes>>;
};

// Either may also have `void prefetch(uint32_t vertex) const`, which asks for what primitive_data() will read of it.
template <typename P>
concept Program = FragmentProgram<P> || ColorProgram<P>;

// The pixel at which the planes of a primitive are anchored. It must not depend on what does not belong to the
// primitive: not on scissor, target or tile.
struct PlaneAnchor {
  int32_t x = 0;
  int32_t y = 0;
};
inline FixedPosition least_corner(const FixedPosition& a, const FixedPosition& b) {
  return {std::min(a.x_fixed, b.x_fixed), std::min(a.y_fixed, b.y_fixed)};
}
inline PlaneAnchor plane_anchor(const PreparedDraw& draw, std::span<const FixedPosition> outline) {
  FixedPosition corner = outline[0];
  for (const FixedPosition& vertex : outline) {
    corner = least_corner(corner, vertex);
  }
  const PixelRect& limits = draw.viewport_pixels;
  return {std::clamp(corner.x_fixed >> draw.subpixel_bits, limits.left, limits.right),
          std::clamp(corner.y_fixed >> draw.subpixel_bits, limits.top, limits.bottom)};
}

// The plane equations of a primitive that was set up.
PrimitiveInterpolation make_interpolation(const PreparedDraw& draw, const SetupPrimitive& primitive,
                                          std::span<const ClipPosition> positions_clip,
                                          std::span<const FixedPosition> outline);

// No sample of the rectangle's pixels has less: rounding keeps the order, so with the operations by which depths are
// computed, one of the outermost samples has the least.
[[nodiscard, gnu::always_inline]] inline double least_depth(const PreparedDraw& draw,
                                                            const PrimitiveInterpolation& planes,
                                                            const PixelRect& pixels) {
  const WindowPlane& depth = planes.depth_framebuffer;
  const double left = static_cast<double>(pixels.left - planes.anchor_x) + draw.least_sample_offset.x;
  const double right = static_cast<double>(pixels.right - 1 - planes.anchor_x) + draw.greatest_sample_offset.x;
  const double top = static_cast<double>(pixels.top - planes.anchor_y) + draw.least_sample_offset.y;
  const double bottom = static_cast<double>(pixels.bottom - 1 - planes.anchor_y) + draw.greatest_sample_offset.y;
  return depth.at(depth.step_x < 0 ? right : left, depth.step_y < 0 ? bottom : top);
}

}  // namespace fillrule::renderer
