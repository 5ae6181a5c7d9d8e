// From fragments that passed the depth test to the colours of the attachment.
#pragma once

#include <array>
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

// Distances in pixels between pixels of a tile, and of what lanes reach beyond it, ascending: to load, since
// conversions of a few fragments' places are as much work as the rest of what their colours need.
inline constexpr int32_t kLeastDistance = -kTileSize;
constexpr std::array<float, size_t{2} * kTileSize + kBlockSize> distances_in_tile() {
  std::array<float, size_t{2} * kTileSize + kBlockSize> distances{};
  for (int32_t i = 0; float& distance : distances) {
    distance = static_cast<float>(kLeastDistance + i++);
  }
  return distances;
}
inline constexpr auto kDistances = distances_in_tile();

// Where the distances from this one on are.
[[nodiscard, gnu::always_inline]] inline const float* distances_from(int32_t first) {
  return &kDistances[static_cast<size_t>(ptrdiff_t{first} - kLeastDistance)];
}

// A primitive's fragments' colours. It holds copies: stores to the attachment cannot change those, so that what all
// fragments share is computed once. The anchor is a pixel of the fragments' tile.
template <typename Lanes, ColorProgram P>
class PrimitiveColors {
 public:
  using Float = typename Lanes::Float;
  using Pairs = LanePairs<Lanes>;

  template <typename Shader>
  [[gnu::always_inline]] explicit PrimitiveColors(const Shader& shader)
      : program_(shader.program),
        data_(shader.primitive.data),
        reciprocal_w_(shader.primitive.reciprocal_w),
        anchor_x_(shader.primitive.shaded.anchor_x),
        anchor_y_(shader.primitive.shaded.anchor_y) {}

  // Of the centres of as many pixels as there are lanes, from the pixel x on.
  [[nodiscard, gnu::always_inline]] Float x_from_anchor(int32_t x) const {
    return Lanes::load(distances_from(x - anchor_x_));
  }
  [[nodiscard, gnu::always_inline]] Float y_from_anchor(int32_t y) const {
    return Lanes::all(*distances_from(y - anchor_y_));
  }

  // Of the fragments there, packed. L: these lanes, or pairs of them.
  template <typename L = Lanes>
  [[nodiscard, gnu::always_inline]] typename L::Int packed(const typename L::Float& x_from_anchor,
                                                           const typename L::Float& y_from_anchor) const {
    return packed_color<L>(program_, data_, reciprocal_w_, x_from_anchor, y_from_anchor);
  }

  // The same in the rows y and y + 1 at once, for lanes that come in pairs.
  [[nodiscard, gnu::always_inline]] auto packed_pair(const Float& x_from_anchor, int32_t y) const {
    return packed<typename Pairs::Lanes>(Pairs::pair(x_from_anchor, x_from_anchor),
                                         Pairs::pair(y_from_anchor(y), y_from_anchor(y + 1)));
  }

  // Writes the colours of a block's pixels in `landed`, two rows at once; `stored` is of the block's first pixel.
  [[gnu::always_inline]] void write_row_pairs(const Float& x_from_anchor, int32_t y, uint64_t landed,
                                              uint32_t* stored) const {
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
  const P& program_;
  const PrimitiveData<P> data_;
  VaryingPlane<> reciprocal_w_;
  int32_t anchor_x_;
  int32_t anchor_y_;
};

}  // namespace fillrule::renderer::internal
