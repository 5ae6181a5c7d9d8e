// Two vectors of lanes as one, for what is the same work in both: colours of two rows, depths of samples side by
// side.
#pragma once

#include <cstdint>
#include <utility>

#include "renderer/vector_lanes.h"

namespace fillrule::renderer {

// Pairs of vectors as one of twice as many lanes, where an instruction set has those.
template <typename L>
struct LanePairs {
  static constexpr bool kExist = false;
  using Lanes = L;
};

template <>
struct LanePairs<Avx512Lanes> {
  static constexpr bool kExist = true;
  using Lanes = VectorLanes<64, 64>;

  [[gnu::always_inline]] static Lanes::Float pair(const Avx512Lanes::Float& first, const Avx512Lanes::Float& second) {
    return joined<Lanes::Float>(first, second, std::make_integer_sequence<int, Lanes::kWidth>());
  }
  [[gnu::always_inline]] static Lanes::Double pair(const Avx512Lanes::Double& first,
                                                   const Avx512Lanes::Double& second) {
    return {{first.parts[0], second.parts[0]}};
  }
  [[gnu::always_inline]] static Avx512Lanes::Int first_of(const Lanes::Int& pair) {
    return __builtin_shufflevector(pair, pair, 0, 1, 2, 3, 4, 5, 6, 7);
  }
  [[gnu::always_inline]] static Avx512Lanes::Int second_of(const Lanes::Int& pair) {
    return __builtin_shufflevector(pair, pair, 8, 9, 10, 11, 12, 13, 14, 15);
  }
};

}  // namespace fillrule::renderer
