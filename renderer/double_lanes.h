// The doubles of a vector lane type (vector_lanes.h): as many as it has floats, in kParts vectors of kBytes.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "renderer/simd_vector.h"

namespace fillrule::renderer {

template <uint32_t kBytes, uint32_t kParts>
struct DoubleLanes {
  using Part = typename SimdVector<double, kBytes>::Type;
  using Floats = typename SimdVector<float, kBytes / 2>::Type;  // as many as a part has doubles
  using Ints = typename SimdVector<int32_t, kBytes / 2>::Type;

  Part parts[kParts];  // NOLINT(modernize-avoid-c-arrays): std::array's members would have to be inlined always

  // Floats or Ints to doubles and back; of wide vectors GCC 12 by itself converts halves.
  template <typename Values>
  [[gnu::always_inline]] static Part widened(const Values& values) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    constexpr bool kAreFloats = std::is_same_v<Values, Floats>;
    constexpr uint8_t kAll = 0xFF;
    if constexpr (kBytes == 32 && kAreFloats) {
      return __builtin_ia32_cvtps2pd256(values);
    } else if constexpr (kBytes == 32) {
      return __builtin_ia32_cvtdq2pd256(values);
    } else if constexpr (kBytes == 64 && kAreFloats) {
      return __builtin_ia32_cvtps2pd512_mask(values, Part{}, kAll, kCurrentRounding);
    } else if constexpr (kBytes == 64) {
      return __builtin_ia32_cvtdq2pd512_mask(values, Part{}, kAll);
    }
#endif
    return __builtin_convertvector(values, Part);
  }
  [[gnu::always_inline]] static Floats narrowed(const Part& part) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    if constexpr (kBytes == 32) {
      return __builtin_ia32_cvtpd2ps256(part);
    }
#endif
    return __builtin_convertvector(part, Floats);
  }

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
