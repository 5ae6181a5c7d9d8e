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

namespace fillrule::renderer {

template <typename T, uint32_t kBytes>
struct SimdVector {
  using Type [[gnu::vector_size(kBytes)]] = T;
};

#ifdef FILLRULE_HAS_LANE_BUILTINS
// What the builtins of AVX-512 are told: the rounding that there is.
inline constexpr int kCurrentRounding = 4;
#endif

}  // namespace fillrule::renderer
