// From fragments that passed the depth test to the colours of the attachment.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "renderer/lane_pairs.h"
#include "renderer/shading.h"

namespace fillrule::renderer::internal {

// The packed colours of a row of fragments, so far from the anchor of the primitive's planes.
template <typename Lanes, ColorProgram P>
[[gnu::always_inline]] inline typename Lanes::Int packed_color(const P& program, const PrimitiveData<P>& data,
                                                               const VaryingPlane<>& reciprocal_w,
                                                               const typename Lanes::Float& x_from_anchor,
                                                               const typename Lanes::Float& y_from_anchor) {
  FragmentLanes<Lanes> fragments;
  fragments.x = x_from_anchor;
  fragments.y = y_from_anchor;
  fragments.w = Lanes::all(1.0F) / fragments.at(reciprocal_w);
  return packed_unorm8<Lanes>(program.template color<Lanes>(data, fragments));
}

template <bool kIsFull, typename Lanes>
[[gnu::always_inline]] inline void write_vector(const typename Lanes::Int& packed, uint32_t bits, uint32_t* stored) {
  if constexpr (kIsFull) {
    Lanes::store(packed, stored);
  } else {
    Lanes::store(Lanes::some(bits), packed, stored);
  }
}

template <typename Lanes, uint32_t kSamples, bool kIsFull, uint32_t... kVectors>
[[gnu::always_inline]] inline void write_vectors(const typename Lanes::Int& packed, uint32_t bits, uint32_t* stored,
                                                 std::integer_sequence<uint32_t, kVectors...> /*all*/) {
  (write_vector<kIsFull, Lanes>(Lanes::template repeated<kSamples, kVectors>(packed),
                                bits >> (kVectors * Lanes::kWidth), stored + size_t{kVectors} * Lanes::kWidth),
   ...);
}

// The colours of as many pixels as there are lanes, to those of their samples whose bits are set, kSamples a pixel;
// or to all of them.
template <typename Lanes, uint32_t kSamples, bool kIsFull>
[[gnu::always_inline]] inline void write_samples(const typename Lanes::Int& packed, uint32_t bits, uint32_t* stored) {
  write_vectors<Lanes, kSamples, kIsFull>(packed, bits, stored, std::make_integer_sequence<uint32_t, kSamples>());
}

// A primitive's fragments' colours. It holds copies: stores to the attachment cannot change those, so that what all
// fragments share is computed once.
template <typename Lanes, ColorProgram P>
class PrimitiveColors {
 public:
  template <typename Shader>
  [[gnu::always_inline]] explicit PrimitiveColors(const Shader& shader)
      : program_(shader.program),
        data_(shader.primitive.data),
        reciprocal_w_(shader.primitive.reciprocal_w),
        anchor_x_(shader.primitive.shaded.anchor_x),
        anchor_y_(shader.primitive.shaded.anchor_y) {}

  // Of the centres of as many pixels as there are lanes, from the pixel x on.
  [[nodiscard, gnu::always_inline]] typename Lanes::Float x_from_anchor(int32_t x) const {
    return Lanes::to_float(Lanes::numbers() + (x - anchor_x_));
  }

  // Of the fragments there in the row y, packed.
  [[nodiscard, gnu::always_inline]] typename Lanes::Int packed(const typename Lanes::Float& x_from_anchor,
                                                               int32_t y) const {
    return packed_color<Lanes>(program_, data_, reciprocal_w_, x_from_anchor, y_from_anchor(y));
  }

  // The same in the rows y and y + 1 at once, for lanes that come in pairs.
  template <typename Pairs = LanePairs<Lanes>>
  [[nodiscard, gnu::always_inline]] typename Pairs::Lanes::Int packed_pair(const typename Lanes::Float& x_from_anchor,
                                                                           int32_t y) const {
    return packed_color<typename Pairs::Lanes>(program_, data_, reciprocal_w_,
                                               Pairs::pair(x_from_anchor, x_from_anchor),
                                               Pairs::pair(y_from_anchor(y), y_from_anchor(y + 1)));
  }

  // Writes the colours of a block's pixels in `landed`, two rows at once; `stored` is of the block's first pixel.
  [[gnu::always_inline]] void write_row_pairs(const typename Lanes::Float& x_from_anchor, int32_t y, uint64_t landed,
                                              uint32_t* stored) const {
    using Pairs = LanePairs<Lanes>;
    static_assert(Lanes::kWidth == kBlockSize);
    constexpr uint64_t kTwoRows = 0xFFFF;
    while (landed != 0) {
      const int32_t row = std::countr_zero(landed) / (2 * kBlockSize) * 2;
      const auto bits = static_cast<uint32_t>(landed >> (row * kBlockSize) & kTwoRows);
      landed &= ~(kTwoRows << (row * kBlockSize));
      const auto pair = packed_pair(x_from_anchor, y + row);
      uint32_t* const of_row = stored + ptrdiff_t{row} * kTileSize;
      write_samples<Lanes, 1, false>(Pairs::first_of(pair), bits, of_row);
      write_samples<Lanes, 1, false>(Pairs::second_of(pair), bits >> kBlockSize, of_row + kTileSize);
    }
  }

 private:
  [[nodiscard, gnu::always_inline]] typename Lanes::Float y_from_anchor(int32_t y) const {
    return Lanes::all(static_cast<float>(y - anchor_y_));
  }

  const P& program_;
  const PrimitiveData<P> data_;
  VaryingPlane<> reciprocal_w_;
  int32_t anchor_x_;
  int32_t anchor_y_;
};

}  // namespace fillrule::renderer::internal
