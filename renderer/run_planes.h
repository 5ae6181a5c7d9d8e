// What runs of pixels (row_spans.h) need of their primitives, from where it was made: of one primitive after the
// other, or lane by lane of as many as there are lanes.
//
// Distances are from the anchor of a primitive's planes to the first pixel of the tile.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "renderer/color_rows.h"
#include "renderer/primitive_shader.h"
#include "renderer/shading.h"
#include "renderer/triangle_buffer.h"

namespace fillrule::renderer::internal {

struct AnchorDistance {
  int32_t x = 0;  // pixels
  int32_t y = 0;
};

// A run's primitive is its number in `primitives`.
template <Program P>
struct PlanesOfPrimitives {
  const P& program;
  std::span<const TilePrimitive<P>> primitives;
  PixelRect tile_pixels;

  [[nodiscard, gnu::always_inline]] const WindowPlane& depth_framebuffer(uint32_t primitive) const {
    return primitives[primitive].interpolation.depth_framebuffer;
  }
  [[nodiscard, gnu::always_inline]] AnchorDistance depth_distance(uint32_t primitive) const {
    const PrimitiveInterpolation& planes = primitives[primitive].interpolation;
    return {tile_pixels.left - planes.anchor_x, tile_pixels.top - planes.anchor_y};
  }
  [[nodiscard, gnu::always_inline]] AnchorDistance color_distance(uint32_t primitive) const {
    const ShadedPrimitive& shaded = primitives[primitive].shaded;
    return {tile_pixels.left - shaded.anchor_x, tile_pixels.top - shaded.anchor_y};
  }
  // The packed colours of pixels so far from the anchor.
  template <typename Lanes>
  [[nodiscard, gnu::always_inline]] typename Lanes::Int color(uint32_t primitive, const typename Lanes::Float& x,
                                                              const typename Lanes::Float& y) const {
    const TilePrimitive<P>& of = primitives[primitive];
    return packed_color<Lanes>(program, of.data, of.reciprocal_w, x, y);
  }
};

// A run's primitive is its lane in `triangles`.
template <typename L, LaneProgram P>
class PlanesInLanes {
 public:
  [[gnu::always_inline]] PlanesInLanes(const P& program, const LaneTriangleBuffer<L>& triangles,
                                       const PixelRect& tile_pixels)
      : PlanesInLanes(program, triangles, tile_pixels, triangles.anchors_within(tile_pixels.left, tile_pixels.top)) {}

  [[nodiscard, gnu::always_inline]] WindowPlane depth_framebuffer(uint32_t lane) const {
    return triangles_.depth_framebuffer(lane);
  }
  [[nodiscard, gnu::always_inline]] AnchorDistance depth_distance(uint32_t lane) const {
    return {depth_x_[lane], depth_y_[lane]};
  }
  [[nodiscard, gnu::always_inline]] AnchorDistance color_distance(uint32_t lane) const {
    return {color_x_[lane], color_y_[lane]};
  }
  template <typename Lanes>
  [[nodiscard, gnu::always_inline]] typename Lanes::Int color(uint32_t lane, const typename Lanes::Float& x,
                                                              const typename Lanes::Float& y) const {
    FragmentLanes<Lanes> fragments;
    fragments.are_of_one = true;
    fragments.lane = lane;
    fragments.x = x;
    fragments.y = y;
    fragments.w = Lanes::all(1.0F) / fragments.at(reciprocal_w_);
    return packed_unorm8<Lanes>(program_.template color<Lanes>(data_, fragments));
  }

 private:
  using Anchors = typename LaneTriangleBuffer<L>::LaneAnchors;
  using Distances = std::array<int32_t, L::kWidth>;
  using Data = decltype(std::declval<const P&>().primitive_data(std::declval<const PrimitiveLanes<L>&>()));

  [[gnu::always_inline]] PlanesInLanes(const P& program, const LaneTriangleBuffer<L>& triangles,
                                       const PixelRect& tile_pixels, const Anchors& color_anchors)
      : program_(program), triangles_(triangles) {
    const PrimitiveLanes<L> shaded = triangles.shaded(color_anchors.x, color_anchors.y);
    data_ = program.primitive_data(shaded);
    reciprocal_w_ = reciprocal_w_plane(shaded);
    L::store(tile_pixels.left - L::load(triangles.anchor_x().data()), depth_x_.data());
    L::store(tile_pixels.top - L::load(triangles.anchor_y().data()), depth_y_.data());
    L::store(tile_pixels.left - color_anchors.x, color_x_.data());
    L::store(tile_pixels.top - color_anchors.y, color_y_.data());
  }

  const P& program_;
  const LaneTriangleBuffer<L>& triangles_;
  Data data_;
  VaryingPlane<L> reciprocal_w_;
  Distances depth_x_;
  Distances depth_y_;
  Distances color_x_;
  Distances color_y_;
};

}  // namespace fillrule::renderer::internal
