// Two vectors of lanes as one, for what is the same work in both: colours of two rows.
#pragma once

#include "renderer/vector_lanes.h"

namespace fillrule::renderer {

// Pairs of vectors as one of twice as many lanes, where an instruction set has those.
template <typename L>
struct LanePairs {
  static constexpr bool kExist = false;
};

template <>
struct LanePairs<Avx512Lanes> {
  static constexpr bool kExist = true;
  using Lanes = VectorLanes<64, 64>;

  [[gnu::always_inline]] static Lanes::Float pair(const Avx512Lanes::Float& first, const Avx512Lanes::Float& second) {
    return __builtin_shufflevector(first, second, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  }
  [[gnu::always_inline]] static Avx512Lanes::Int first_of(const Lanes::Int& pair) {
    return __builtin_shufflevector(pair, pair, 0, 1, 2, 3, 4, 5, 6, 7);
  }
  [[gnu::always_inline]] static Avx512Lanes::Int second_of(const Lanes::Int& pair) {
    return __builtin_shufflevector(pair, pair, 8, 9, 10, 11, 12, 13, 14, 15);
  }
};

}  // namespace fillrule::renderer
