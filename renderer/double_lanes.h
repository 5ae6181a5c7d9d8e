// The doubles of a vector lane type (vector_lanes.h): as many as it has floats, in kParts vectors of kBytes.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>

#include "renderer/simd_vector.h"

namespace fillrule::renderer {

template <uint32_t kBytes, uint32_t kParts>
struct DoubleLanes {
  using Part = typename SimdVector<double, kBytes>::Type;

  Part parts[kParts];  // NOLINT(modernize-avoid-c-arrays): std::array's members would have to be inlined always

  template <typename Operation>
  [[gnu::always_inline]] static DoubleLanes each(const DoubleLanes& a, const DoubleLanes& b,
                                                 const Operation& operation) {
    if constexpr (kParts == 1) {
      return {{operation(a.parts[0], b.parts[0])}};
    } else {
      return {{operation(a.parts[0], b.parts[0]), operation(a.parts[1], b.parts[1])}};
    }
  }
  [[gnu::always_inline]] friend DoubleLanes operator+(const DoubleLanes& a, const DoubleLanes& b) {
    return each(
        a, b, [](const Part& p, const Part& q) __attribute__((always_inline)) { return p + q; });
  }
  [[gnu::always_inline]] friend DoubleLanes operator-(const DoubleLanes& a, const DoubleLanes& b) {
    return each(
        a, b, [](const Part& p, const Part& q) __attribute__((always_inline)) { return p - q; });
  }
  [[gnu::always_inline]] friend DoubleLanes operator*(const DoubleLanes& a, const DoubleLanes& b) {
    return each(
        a, b, [](const Part& p, const Part& q) __attribute__((always_inline)) { return p * q; });
  }
  [[gnu::always_inline]] friend DoubleLanes operator/(const DoubleLanes& a, const DoubleLanes& b) {
    return each(
        a, b, [](const Part& p, const Part& q) __attribute__((always_inline)) { return p / q; });
  }
  [[nodiscard, gnu::always_inline]] DoubleLanes magnitude() const {
    using Bits = typename SimdVector<int64_t, kBytes>::Type;
    DoubleLanes result;
    for (uint32_t i = 0; i < kParts; ++i) {
      Bits bits;
      std::memcpy(&bits, &parts[i], sizeof bits);
      bits = bits & std::numeric_limits<int64_t>::max();
      std::memcpy(&result.parts[i], &bits, sizeof bits);
    }
    return result;
  }
};

}  // namespace fillrule::renderer
