// What becomes of the fragments that passed the depth test: they are handed to the program, and its colours to the
// attachment.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "renderer/shading.h"

namespace fillrule::renderer::internal {

// The packed colours of a row of fragments, so far from the anchor of the primitive's planes.
template <typename Lanes, ColorProgram P>
[[gnu::always_inline]] inline typename Lanes::Int packed_color(const P& program,
                                                               const typename P::PrimitiveData& data,
                                                               const VaryingPlane& reciprocal_w,
                                                               const typename Lanes::Float& x_from_anchor,
                                                               float y_from_anchor) {
  FragmentLanes<Lanes> fragments;
  fragments.x = x_from_anchor;
  fragments.y = Lanes::all(y_from_anchor);
  fragments.w = Lanes::all(1.0F) / reciprocal_w.template at<Lanes>(fragments.x, fragments.y);
  return packed_unorm8<Lanes>(program.template color<Lanes>(data, fragments));
}

// What becomes of the fragments of one sample a pixel in a column of rows of lanes, from x to the right. It holds
// copies: stores to the attachments cannot change those, so that what all rows share is computed once.
template <typename Lanes, Program P>
struct RowEmitter {
  template <typename Shader>
  [[gnu::always_inline]] RowEmitter(const Shader& shader, int32_t the_x, size_t first)
      : program(shader.program),
        data(shader.data),
        interpolation(shader.interpolation),
        reciprocal_w(shader.reciprocal_w),
        x(the_x),
        anchor_y(shader.primitive.anchor_y),
        x_from_anchor(Lanes::to_float(Lanes::numbers() + (the_x - shader.primitive.anchor_x))),
        color(shader.draw.input.color.values.data() + first) {}

  // Those in the mask, so many values after the first row.
  [[gnu::always_inline]] void emit(size_t offset, int32_t y, const typename Lanes::Mask& mask) const {
    if constexpr (ColorProgram<P>) {
      const typename Lanes::Int packed =
          packed_color<Lanes>(program, data, reciprocal_w, x_from_anchor, static_cast<float>(y - anchor_y));
      Lanes::store(mask ? packed : Lanes::load(color + offset), color + offset);
    } else {
      for (uint32_t bits = Lanes::bits_of(mask); bits != 0; bits &= bits - 1) {
        program.fragment(data, {.x = x + std::countr_zero(bits), .y = y, .interpolation = interpolation});
      }
    }
  }

  // The same of pixels of several samples: a mask for each vector of samples.
  template <uint32_t kSamples>
  [[gnu::always_inline]] void emit_samples(size_t offset, int32_t y,
                                           const std::array<typename Lanes::Mask, kSamples>& masks) const {
    const typename Lanes::Int packed =
        packed_color<Lanes>(program, data, reciprocal_w, x_from_anchor, static_cast<float>(y - anchor_y));
    [&]<uint32_t... kPart>(std::integer_sequence<uint32_t, kPart...>) __attribute__((always_inline)) {
      (emit_part(color + offset + size_t{kPart} * Lanes::kWidth, Lanes::template repeated<kSamples, kPart>(packed),
                 masks[kPart]),
       ...);
    }
    (std::make_integer_sequence<uint32_t, kSamples>());
  }

  [[gnu::always_inline]] static void emit_part(uint32_t* stored, const typename Lanes::Int& packed,
                                               const typename Lanes::Mask& mask) {
    Lanes::store(mask ? packed : Lanes::load(stored), stored);
  }

  const P& program;
  std::conditional_t<ColorProgram<P>, const typename P::PrimitiveData, const typename P::PrimitiveData&> data;
  const PrimitiveInterpolation& interpolation;
  VaryingPlane reciprocal_w;
  int32_t x;
  int32_t anchor_y;
  typename Lanes::Float x_from_anchor;
  uint32_t* color;
};

}  // namespace fillrule::renderer::internal
