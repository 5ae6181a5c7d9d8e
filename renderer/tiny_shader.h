// Tiny triangles fragment by fragment: first the depth tests of all of them, then the colours of those that are left,
// of as many fragments at once as there are lanes, whichever triangles they belong to. In runs of eight pixels of a
// row, most lanes would have nothing to do.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "renderer/color_rows.h"
#include "renderer/primitive_shader.h"
#include "renderer/shading.h"
#include "renderer/tile_attachments.h"
#include "renderer/triangle_buffer.h"

namespace fillrule::renderer::internal {

// As many triangles as there are lanes, in one tile and with one sample a pixel. The blocks of their pixels must have
// been loaded.
template <typename L, LaneProgram P>
class TinyShader {
 public:
  [[gnu::always_inline]] TinyShader(const PreparedDraw& draw, const P& program,
                                    const LaneTriangleBuffer<L>& triangles, const TileAttachments::Pixels<1>& pixels)
      : depth_(draw.depth), program_(program), triangles_(triangles), pixels_(pixels) {}

  // The pixels of a triangle: as SetupPrimitive::covered_pixels(), which is at (left, top).
  [[gnu::always_inline]] void add(uint32_t lane, int32_t left, int32_t top, uint32_t covered) {
    const auto first =
        static_cast<uint32_t>((top - pixels_.top) * kTileSize + left - pixels_.left) + (lane << kLaneBit);
    // Some more than most have, so that nobody has to guess how many there are.
    do {
      for (uint32_t i = 0; i < kAtOnce; ++i, covered &= covered - 1) {
        const auto bit = static_cast<uint32_t>(std::countr_zero(covered));
        constexpr uint32_t kToNextRow = kTileSize - SetupPrimitive::kCoveredWidth;
        fragments_[count_] = first + bit + bit / SetupPrimitive::kCoveredWidth * kToNextRow;
        count_ += covered != 0 ? 1 : 0;
      }
    } while (covered != 0);
  }

  // Whatever was added.
  [[gnu::always_inline]] void shade() {
    if (depth_.tests()) {
      if (depth_.is_usual()) {
        test<true>();
      } else {
        test<false>();
      }
    }
    if (count_ != 0) {
      write_colors();
    }
  }

 private:
  static constexpr uint32_t kAtOnce = 4;
  static constexpr uint32_t kMaxFragments =
      L::kWidth * SetupPrimitive::kCoveredWidth * SetupPrimitive::kCoveredHeight + kAtOnce + L::kWidth;
  // A fragment: the number of its pixel in the tile, row by row, and the lane of its triangle.
  static constexpr uint32_t kLaneBit = 16;
  static constexpr uint32_t kPixelBits = 0xFFFF;
  static constexpr uint32_t kPixelsOfTile = uint32_t{kTileSize} * kTileSize;
  static_assert(std::has_single_bit(static_cast<uint32_t>(kTileSize)) && kPixelsOfTile <= kPixelBits);

  // Keeps those that pass.
  template <bool kIsUsual>
  [[gnu::always_inline]] void test() {
    const DepthStage stage = depth_;
    uint32_t count = 0;
    for (uint32_t i = 0; i < count_; ++i) {
      const uint32_t fragment = fragments_[i];
      const uint32_t lane = fragment >> kLaneBit;
      const uint32_t pixel = fragment & kPixelBits;
      const auto x = static_cast<int32_t>(pixel % kTileSize) + pixels_.left - triangles_.anchor_x()[lane];
      const auto y = static_cast<int32_t>(pixel / kTileSize) + pixels_.top - triangles_.anchor_y()[lane];
      const double depth = triangles_.depth_framebuffer(lane).at(x, y);
      fragments_[count] = fragment;
      count += test_depths<ScalarLanes, kIsUsual>(stage, depth, true, pixels_.depths + pixel);
    }
    count_ = count;
  }

  [[gnu::always_inline]] void write_colors() {
    const auto [anchor_x, anchor_y] = triangles_.anchors_within(pixels_.left, pixels_.top);
    const PrimitiveLanes<L> shaded = triangles_.shaded(anchor_x, anchor_y);
    const auto data = program_.primitive_data(shaded);
    const VaryingPlane<L> reciprocal_w = reciprocal_w_plane(shaded);
    // Those of the last vector that are none go to where no pixel is.
    for (uint32_t i = 0; i < L::kWidth; ++i) {
      fragments_[count_ + i] = kPixelsOfTile;
    }
    for (uint32_t first = 0; first < count_; first += L::kWidth) {
      const Int of_lanes = L::load(fragments_.data() + first);
      FragmentLanes<L> fragments;
      fragments.primitive = of_lanes >> static_cast<int32_t>(kLaneBit);
      const auto from_anchor = [&](const Int& pixels, const Int& anchors) __attribute__((always_inline)) {
        return L::to_float((pixels & (kTileSize - 1)) - L::chosen(anchors, fragments.primitive));
      };
      fragments.x = from_anchor(of_lanes, anchor_x - pixels_.left);
      fragments.y =
          from_anchor(of_lanes >> std::countr_zero(static_cast<uint32_t>(kTileSize)), anchor_y - pixels_.top);
      fragments.w = L::all(1.0F) / fragments.at(reciprocal_w);
      std::array<uint32_t, L::kWidth> packed;
      L::store(packed_unorm8<L>(program_.template color<L>(data, fragments)), packed.data());
      for (uint32_t i = 0; i < L::kWidth; ++i) {
        pixels_.colors[fragments_[first + i] & kPixelBits] = packed[i];
      }
    }
  }

  using Int = typename L::Int;

  const DepthStage& depth_;
  const P& program_;
  const LaneTriangleBuffer<L>& triangles_;
  TileAttachments::Pixels<1> pixels_;
  uint32_t count_ = 0;
  std::array<uint32_t, kMaxFragments> fragments_;
};

}  // namespace fillrule::renderer::internal
