// From fragments that passed the depth test to the colours of the attachment.
#pragma once

#include <cstdint>
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

// The colours of one primitive in a column of rows of lanes, from x to the right. It holds copies: stores to the
// attachment cannot change those, so that what all rows share is computed once.
template <typename Lanes, ColorProgram P>
struct ColorRows {
  // `first`: the column's first value.
  template <typename Shader>
  [[gnu::always_inline]] ColorRows(const Shader& shader, int32_t x, uint32_t* first)
      : program(shader.program),
        data(shader.data),
        reciprocal_w(shader.reciprocal_w),
        anchor_y(shader.primitive.anchor_y),
        x_from_anchor(Lanes::to_float(Lanes::numbers() + (x - shader.primitive.anchor_x))),
        values(first) {}

  // Of the fragments in the mask, so many values after the first row.
  [[gnu::always_inline]] void write(int32_t offset, int32_t y, const typename Lanes::Mask& mask) const {
    uint32_t* const stored = values + offset;
    Lanes::store(mask ? packed(y) : Lanes::load(stored), stored);
  }

  // Of all of them.
  [[gnu::always_inline]] void write_all(int32_t offset, int32_t y) const { Lanes::store(packed(y), values + offset); }

  // The same of pixels of several samples: bit i is value i; or all of them.
  template <uint32_t kSamples, bool kIsFull>
  [[gnu::always_inline]] void write_samples(int32_t offset, int32_t y, uint32_t bits) const {
    write_vectors<kSamples, kIsFull>(values + offset, packed(y), bits,
                                     std::make_integer_sequence<uint32_t, kSamples>());
  }

 private:
  [[gnu::always_inline]] typename Lanes::Int packed(int32_t y) const {
    return packed_color<Lanes>(program, data, reciprocal_w, x_from_anchor, static_cast<float>(y - anchor_y));
  }

  template <uint32_t kSamples, bool kIsFull, uint32_t... kVectors>
  [[gnu::always_inline]] static void write_vectors(uint32_t* stored, const typename Lanes::Int& packed, uint32_t bits,
                                                   std::integer_sequence<uint32_t, kVectors...> /*all*/) {
    (write_vector<kIsFull>(stored + size_t{kVectors} * Lanes::kWidth,
                           Lanes::template repeated<kSamples, kVectors>(packed), bits >> (kVectors * Lanes::kWidth)),
     ...);
  }

  template <bool kIsFull>
  [[gnu::always_inline]] static void write_vector(uint32_t* stored, const typename Lanes::Int& packed,
                                                  uint32_t bits) {
    if constexpr (kIsFull) {
      Lanes::store(packed, stored);
    } else {
      Lanes::store(Lanes::mask_of(bits) ? packed : Lanes::load(stored), stored);
    }
  }

  const P& program;
  const typename P::PrimitiveData data;
  VaryingPlane reciprocal_w;
  int32_t anchor_y;
  typename Lanes::Float x_from_anchor;
  uint32_t* values;
};

}  // namespace fillrule::renderer::internal
