// The compilers' vector extension, which GCC and Clang translate for the instructions of the function that a vector
// is used in.
#pragma once

// GCC asks for a builtin's instruction set only where the function that all of this is inlined into is compiled,
// Clang already here: it has to do with what it makes of plain vectors.
#if defined(__GNUC__) && !defined(__clang__)
#define FILLRULE_HAS_LANE_BUILTINS
#include <immintrin.h>  // declares the builtins
#endif

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace fillrule::renderer {

template <typename T, uint32_t kBytes>
struct SimdVector {
  using Type [[gnu::vector_size(kBytes)]] = T;
};

#ifdef FILLRULE_HAS_LANE_BUILTINS
// What the builtins of AVX-512 are told: the rounding that there is, and all lanes.
inline constexpr int kCurrentRounding = 4;
inline constexpr uint16_t kAllOf512 = 0xFFFF;
#endif

// The same in every lane. GCC 12 by itself would fill the lanes of a vector wider than SSE's one by one.
template <typename Vector, typename Value>
[[gnu::always_inline]] inline Vector broadcast(Value value) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
  const typename SimdVector<Value, 16>::Type first{value};
  if constexpr (std::is_same_v<Value, int32_t>) {
    if constexpr (sizeof(Vector) == 32) {
      return __builtin_ia32_pbroadcastd256(first);
    }
  } else if constexpr (sizeof(Vector) == 64 && sizeof(Value) == sizeof(double)) {
    return __builtin_ia32_broadcastsd512(first, Vector{}, 0xFF);
  } else if constexpr (sizeof(Vector) == 64) {
    return __builtin_ia32_broadcastss512(first, Vector{}, kAllOf512);
  } else if constexpr (sizeof(Vector) == 32 && sizeof(Value) == sizeof(double)) {
    return __builtin_ia32_vbroadcastsd_pd256(first);
  } else if constexpr (sizeof(Vector) == 32) {
    return __builtin_ia32_vbroadcastss_ps256(first);
  }
#endif
  return value - Vector{};
}

// From memory, which need not be aligned.
template <typename Vector, typename T>
[[gnu::always_inline]] inline Vector loaded(const T* values) {
  Vector vector;
  std::memcpy(&vector, values, sizeof vector);
  return vector;
}

// Two halves as one vector, whose lanes kNumbers counts.
template <typename Vector, typename Half, int... kNumbers>
[[gnu::always_inline]] inline Vector joined(const Half& low, const Half& high,
                                            std::integer_sequence<int, kNumbers...> /*all*/) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
  // GCC 12 by itself would clear the upper half first.
  if constexpr (sizeof(Vector) == 64 && std::is_same_v<Half, typename SimdVector<float, 32>::Type>) {
    const Vector wide = __builtin_ia32_ps512_256ps(low);
    return __builtin_ia32_insertf32x8_mask(wide, high, 1, wide, kAllOf512);
  }
#endif
  return __builtin_shufflevector(low, high, kNumbers...);
}

}  // namespace fillrule::renderer
