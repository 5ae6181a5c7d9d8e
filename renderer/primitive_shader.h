// One primitive in one tile: what its fragments need, whichever way they were found.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>

#include "renderer/color_rows.h"
#include "renderer/lane_pairs.h"
#include "renderer/shading.h"
#include "renderer/tile_attachments.h"

namespace fillrule::renderer::internal {

// The planes of a primitive, and what its program made of it.
template <Program P>
struct TilePrimitive {
  PrimitiveInterpolation interpolation;
  ShadedPrimitive shaded;
  PrimitiveData<P> data;
  VaryingPlane<> reciprocal_w;
};

// The values of as many fragments' depths as there are lanes: of those in `values`. Bit by bit: which pass the depth
// test, which is done.
template <typename L, bool kIsUsual>
[[gnu::always_inline]] inline uint32_t test_depths(const DepthStage& depth_stage,
                                                   const typename L::Double& depth_framebuffer,
                                                   const typename L::Some& values, float* stored_depths) {
  const DepthStage stage = depth_stage;
  if constexpr (kIsUsual) {
    return stage.template land_as_usual<L>(depth_framebuffer, values, stored_depths);
  } else {
    typename L::Float stored = L::load(stored_depths);
    const typename L::Mask mask = stage.template lands<L>(depth_framebuffer, L::mask(values), stored);
    L::store(stored, stored_depths);
    return L::bits_of(mask);
  }
}

// Tests a row of values that lie in vectors side by side: `columns` and `row` are what their depths are the sum of.
// Bit by bit: which there are, and which pass. Two vectors are compared and stored as one where there are pairs.
template <typename L, bool kIsUsual, bool kIsFull, size_t kVectors>
[[gnu::always_inline]] inline uint32_t test_row(const DepthStage& stage,
                                                const std::array<typename L::Double, kVectors>& columns,
                                                const typename L::Double& row, float* depths, uint32_t bits) {
  using Pairs = LanePairs<L>;
  constexpr bool kAreInPairs = Pairs::kExist && kIsUsual && kVectors % 2 == 0;
  using Tested = std::conditional_t<kAreInPairs, typename Pairs::Lanes, L>;
  constexpr uint32_t kAllLanes = (1U << Tested::kWidth) - 1;
  const auto depths_from = [&](uint32_t vector) __attribute__((always_inline)) {
    if constexpr (kAreInPairs) {
      return Pairs::pair(columns[vector] + row, columns[vector + 1] + row);
    } else {
      return columns[vector] + row;
    }
  };
  uint32_t landed = 0;
  for (uint32_t vector = 0; vector < kVectors; vector += Tested::kWidth / L::kWidth) {
    const uint32_t first = vector * L::kWidth;
    const typename Tested::Some values = Tested::some(kIsFull ? kAllLanes : bits >> first);
    landed |= test_depths<Tested, kIsUsual>(stage, depths_from(vector), values, depths + first) << first;
  }
  return landed;
}

template <Program P>
struct PrimitiveShader {
  const PreparedDraw& draw;
  const P& program;
  const TilePrimitive<P>& primitive;

  // A pixel of several samples, of which those in `covered` are.
  void shade_pixel(int32_t x, int32_t y, uint32_t covered, const TileAttachments::Values& values) const {
    uint32_t landed = 0;
    for (uint32_t rest = covered & draw.input.state.sample_mask; rest != 0; rest &= rest - 1) {
      const auto sample = static_cast<uint32_t>(std::countr_zero(rest));
      landed |= static_cast<uint32_t>(lands(x, y, sample, values.depths)) << sample;
    }
    if (landed == 0) {
      return;
    }
    Fragment fragment{.x = x, .y = y, .samples = landed, .interpolation = primitive.interpolation};
    // The centre is within the convex hull of all samples; of fewer, any is a point of the primitive.
    if (covered != (1U << draw.input.samples) - 1) {
      fragment.centroid = location(static_cast<uint32_t>(std::countr_zero(covered)));
    }
    if (!draw.input.sample_shading) {
      emit_fragment(fragment, values.colors);
      return;
    }
    for (uint32_t rest = landed; rest != 0; rest &= rest - 1) {
      const auto sample = static_cast<uint32_t>(std::countr_zero(rest));
      fragment.samples = 1U << sample;
      fragment.position = location(sample);
      emit_fragment(fragment, values.colors);
    }
  }

 private:
  [[nodiscard]] WindowOffset location(uint32_t sample) const { return draw.sample_locations[sample].from_centre(); }

  // `stored_depths`: of the pixel's samples; null where none are in use.
  [[nodiscard]] bool lands(int32_t x, int32_t y, uint32_t sample, float* stored_depths) const {
    return !draw.depth.tests() ||
           draw.depth.lands(primitive.interpolation.depth_at(x, y, location(sample)), true, stored_depths[sample]);
  }

  void emit_fragment(const Fragment& fragment, [[maybe_unused]] uint32_t* colors) const {
    if constexpr (ColorProgram<P>) {
      const auto packed = static_cast<uint32_t>(packed_color<ScalarLanes>(
          program, primitive.data, primitive.reciprocal_w,
          static_cast<float>(fragment.x - primitive.shaded.anchor_x + fragment.position.x),
          static_cast<float>(fragment.y - primitive.shaded.anchor_y + fragment.position.y)));
      for (uint32_t rest = fragment.samples; rest != 0; rest &= rest - 1) {
        colors[std::countr_zero(rest)] = packed;
      }
    } else {
      program.fragment(primitive.data, fragment);
    }
  }
};

}  // namespace fillrule::renderer::internal
