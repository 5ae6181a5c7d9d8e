// Lanes: one kernel source for a pixel at a time and for several.
//
// A lane type has Float, Int and Double, one of each for every lane, and Mask, what comparing two Floats or two Ints
// gives. All of them take the operators of C++, and `mask ? a : b` chooses lane by lane. Each operation is IEEE's own
// in each lane, none is fused and none reassociated: so any lane type gives the bytes of ScalarLanes.
//
// Vectors are the compilers' vector extension, which GCC and Clang translate for the instructions of the function
// that they are inlined into (isa.h chooses those at run time). Whatever takes or returns lanes must therefore be
// inlined always: [[gnu::always_inline]].
#pragma once

// GCC asks for a builtin's instruction set only where the function that all of this is inlined into is compiled,
// Clang already here: it has to do with what it makes of plain vectors.
#if defined(__GNUC__) && !defined(__clang__)
#define FILLRULE_HAS_LANE_BUILTINS
#include <immintrin.h>  // declares the builtins
#endif

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

namespace fillrule::renderer {

struct ScalarLanes {
  static constexpr uint32_t kWidth = 1;
  using Float = float;
  using Int = int32_t;
  using Double = double;
  using Mask = bool;

  // The same in every lane.
  static Float all(float value) { return value; }
  static Double all(double value) { return value; }
  // The lanes' numbers: 0, 1, 2 ...
  static Int numbers() { return 0; }

  // As many consecutive values as there are lanes.
  static Float load(const float* values) { return *values; }
  static Double load(const double* values) { return *values; }
  static Int load(const int32_t* values) { return *values; }
  static Int load(const uint32_t* values) { return static_cast<Int>(*values); }
  template <typename Value, typename T>
  static void store(Value value, T* values) {
    *values = static_cast<T>(value);
  }

  static Float to_float(Double value) { return static_cast<float>(value); }
  static Float to_float(Int value) { return static_cast<float>(value); }
  static Double to_double(Float value) { return value; }
  static Double to_double(Int value) { return value; }
  // Without its fraction.
  static Int truncated(Float value) { return static_cast<Int>(value); }
  static Double magnitude(Double value) { return std::abs(value); }
  static Int bits_of(Float value) {
    Int bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
  }

  // The lanes' lowest bytes, lane 0 lowest.
  static uint64_t low_bytes(Int value) { return static_cast<uint64_t>(value) & 0xFFU; }

  // a < b ? a : b, and a > b ? a : b: the second one if either is NaN.
  static Float lesser(Float a, Float b) { return a < b ? a : b; }
  static Float greater(Float a, Float b) { return a > b ? a : b; }

  static bool any(Mask mask) { return mask; }
  static Mask negated(Mask mask) { return !mask; }
  // Bit i: lane i.
  static uint32_t sign_bits(Int value) { return static_cast<uint32_t>(value) >> 31U; }
  static Mask mask_of(uint32_t bits) { return (bits & 1U) != 0; }
  static uint32_t bits_of(Mask mask) { return mask ? 1 : 0; }
  // The bits from kFirst on.
  template <uint32_t kFirst>
  static Mask mask_from(uint64_t bits) {
    return mask_of(static_cast<uint32_t>(bits >> kFirst));
  }

  // Four values of 0 to 255, to the nearest whole ones, ties to even, as the bytes of each lane, the first one
  // lowest.
  static Int packed_bytes(Float a, Float b, Float c, Float d) {
    const auto byte = [](Float value) { return bits_of(value + 0x1.8p23F) & 0xFF; };  // no bit is left for a fraction
    return byte(a) | byte(b) << 8 | byte(c) << 16 | static_cast<Int>(static_cast<uint32_t>(byte(d)) << 24U);
  }

  // Lane i of kPart's vector gets lane (kPart * kWidth + i) / kTimes: each lane kTimes, over kTimes vectors.
  template <uint32_t kTimes, uint32_t kPart>
  static Int repeated(Int value) {
    return value;
  }

  // kCount values, again and again, to fill all lanes.
  template <uint32_t kCount>
  static Int load_each(const int32_t* values) {
    static_assert(kCount == 1);
    return *values;
  }
  // Of each kCount lanes side by side, to all of them. kCount is 1 or 4.
  template <uint32_t kCount>
  static Float least_of_each(Float value) {
    static_assert(kCount == 1);
    return value;
  }
  template <uint32_t kCount>
  static Float greatest_of_each(Float value) {
    static_assert(kCount == 1);
    return value;
  }
};

template <typename T, uint32_t kBytes>
struct SimdVector {
  using Type [[gnu::vector_size(kBytes)]] = T;
};

// kFloatBytes: of a vector of floats. kDoubleBytes: of the vectors that Double is made of, one or two.
template <uint32_t kFloatBytes, uint32_t kDoubleBytes>
struct VectorLanes {
  static constexpr uint32_t kWidth = kFloatBytes / sizeof(float);
  static constexpr uint32_t kParts = kWidth * sizeof(double) / kDoubleBytes;
  static_assert(kParts == 1 || kParts == 2);

  using Float = typename SimdVector<float, kFloatBytes>::Type;
  using Int = typename SimdVector<int32_t, kFloatBytes>::Type;
  using Mask = Int;  // all bits of a lane, or none
  using Part = typename SimdVector<double, kDoubleBytes>::Type;
  using HalfFloat = typename SimdVector<float, kDoubleBytes / 2>::Type;
  using HalfInt = typename SimdVector<int32_t, kDoubleBytes / 2>::Type;
  using Bytes = typename SimdVector<int8_t, kWidth>::Type;

  struct Double {
    Part parts[kParts];  // NOLINT(modernize-avoid-c-arrays): std::array's members would have to be inlined always

    template <typename Operation>
    [[gnu::always_inline]] static Double each(const Double& a, const Double& b, const Operation& operation) {
      if constexpr (kParts == 1) {
        return {{operation(a.parts[0], b.parts[0])}};
      } else {
        return {{operation(a.parts[0], b.parts[0]), operation(a.parts[1], b.parts[1])}};
      }
    }
    [[gnu::always_inline]] friend Double operator+(const Double& a, const Double& b) {
      return each(
          a, b, [](const Part& p, const Part& q) __attribute__((always_inline)) { return p + q; });
    }
    [[gnu::always_inline]] friend Double operator-(const Double& a, const Double& b) {
      return each(
          a, b, [](const Part& p, const Part& q) __attribute__((always_inline)) { return p - q; });
    }
    [[gnu::always_inline]] friend Double operator*(const Double& a, const Double& b) {
      return each(
          a, b, [](const Part& p, const Part& q) __attribute__((always_inline)) { return p * q; });
    }
    [[gnu::always_inline]] friend Double operator/(const Double& a, const Double& b) {
      return each(
          a, b, [](const Part& p, const Part& q) __attribute__((always_inline)) { return p / q; });
    }
  };

  [[gnu::always_inline]] static Float all(float value) { return broadcast<Float>(value); }
  [[gnu::always_inline]] static Double all(double value) {
    Double result;
    for (Part& part : result.parts) {
      part = broadcast<Part>(value);
    }
    return result;
  }
  [[gnu::always_inline]] static Int numbers() { return numbers(std::make_integer_sequence<int32_t, kWidth>()); }

  [[gnu::always_inline]] static Float load(const float* values) { return loaded<Float>(values); }
  [[gnu::always_inline]] static Int load(const int32_t* values) { return loaded<Int>(values); }
  [[gnu::always_inline]] static Int load(const uint32_t* values) { return loaded<Int>(values); }
  [[gnu::always_inline]] static Double load(const double* values) {
    Double result;
    for (Part& part : result.parts) {  // a copy of the whole would go by way of memory, in halves of vectors
      part = loaded<Part>(values);
      values += sizeof(Part) / sizeof(double);
    }
    return result;
  }
  template <typename Value, typename T>
  [[gnu::always_inline]] static void store(const Value& vector, T* values) {
    std::memcpy(values, &vector, sizeof vector);
  }

  [[gnu::always_inline]] static Float to_float(const Double& value) {
    if constexpr (kParts == 1) {
      return __builtin_convertvector(value.parts[0], Float);
    } else {
      return joined<Float>(__builtin_convertvector(value.parts[0], HalfFloat),
                           __builtin_convertvector(value.parts[1], HalfFloat),
                           std::make_integer_sequence<int, kWidth>());
    }
  }
  [[gnu::always_inline]] static Float to_float(const Int& value) { return __builtin_convertvector(value, Float); }
  [[gnu::always_inline]] static Double to_double(const Float& value) { return widened<HalfFloat>(value); }
  [[gnu::always_inline]] static Double to_double(const Int& value) { return widened<HalfInt>(value); }
  [[gnu::always_inline]] static Double magnitude(const Double& value) {
    using Bits = typename SimdVector<int64_t, kDoubleBytes>::Type;
    Double result;
    for (uint32_t i = 0; i < kParts; ++i) {
      Bits bits;
      std::memcpy(&bits, &value.parts[i], sizeof bits);
      bits = bits & std::numeric_limits<int64_t>::max();
      std::memcpy(&result.parts[i], &bits, sizeof bits);
    }
    return result;
  }
  [[gnu::always_inline]] static Int truncated(const Float& value) { return __builtin_convertvector(value, Int); }
  [[gnu::always_inline]] static Int bits_of(const Float& value) {
    Int bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
  }

  [[gnu::always_inline]] static Float lesser(const Float& a, const Float& b) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    if constexpr (kFloatBytes == 16) {
      return __builtin_ia32_minps(a, b);
    } else {
      return __builtin_ia32_minps256(a, b);
    }
#else
    return a < b ? a : b;
#endif
  }
  [[gnu::always_inline]] static Float greater(const Float& a, const Float& b) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    if constexpr (kFloatBytes == 16) {
      return __builtin_ia32_maxps(a, b);
    } else {
      return __builtin_ia32_maxps256(a, b);
    }
#else
    return a > b ? a : b;
#endif
  }

  [[gnu::always_inline]] static bool any(const Mask& mask) {
    return bits_of(mask) != 0;
  }
  [[gnu::always_inline]] static Mask negated(const Mask& mask) {
    return ~mask;
  }
  [[gnu::always_inline]] static Mask mask_of(uint32_t bits) {
    const Int own = own_bits(std::make_integer_sequence<uint32_t, kWidth>());
    return ((own & static_cast<int32_t>(bits)) == own);
  }
  // The lanes' lowest bytes, lane 0 lowest.
  [[gnu::always_inline]] static uint64_t low_bytes(const Int& value) {
    const Bytes bytes = __builtin_convertvector(value, Bytes);
    uint64_t result = 0;
    std::memcpy(&result, &bytes, sizeof bytes);
    return result;
  }
  [[gnu::always_inline]] static uint32_t bits_of(const Mask& mask) {
    return sign_bits(mask);
  }
  template <uint32_t kFirst>
  [[gnu::always_inline]] static Mask mask_from(uint64_t bits) {
    if constexpr (kFloatBytes == 16) {
      return mask_of(static_cast<uint32_t>(bits >> kFirst));
    } else {
      // Each lane moves its own bit to the sign.
      const auto half = static_cast<int32_t>(bits >> (kFirst & 32U));
      return (((half + Int{}) << (31 - static_cast<int32_t>(kFirst & 31U) - numbers())) < 0);
    }
  }
  [[gnu::always_inline]] static uint32_t sign_bits(const Int& value) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    if constexpr (kFloatBytes == 16) {
      return static_cast<uint32_t>(__builtin_ia32_movmskps(reinterpret_cast<const Float&>(value)));
    } else {
      return static_cast<uint32_t>(__builtin_ia32_movmskps256(reinterpret_cast<const Float&>(value)));
    }
#else
    // The product moves one bit of each byte to the top byte.
    return static_cast<uint32_t>((low_bytes(value < 0) & kOneOfEach) * kEachByte >> 56U);
#endif
  }

  [[gnu::always_inline]] static Int packed_bytes(const Float& a, const Float& b, const Float& c, const Float& d) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    if constexpr (kFloatBytes == 32) {
      using Words = typename SimdVector<int16_t, 32>::Type;
      const Words ab = __builtin_ia32_packssdw256(__builtin_ia32_cvtps2dq256(a), __builtin_ia32_cvtps2dq256(b));
      const Words cd = __builtin_ia32_packssdw256(__builtin_ia32_cvtps2dq256(c), __builtin_ia32_cvtps2dq256(d));
      // In each half of the vector four bytes of each value follow those of the last.
      using Chars = typename SimdVector<char, 32>::Type;
      const Chars order{0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15,
                        0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15};
      const Chars bytes = __builtin_ia32_pshufb256(__builtin_ia32_packuswb256(ab, cd), order);
      return reinterpret_cast<const Int&>(bytes);
    }
#endif
    const auto bits = [](const Float& value) __attribute__((always_inline)) {
      return bits_of(value + all(0x1.8p23F));
    };
    // The bits of 1.5 * 2^23 are zeros in the lowest byte, and cancel in the others.
    constexpr uint32_t kNoFraction = 0x4B400000;
    constexpr auto kRest =
        static_cast<int32_t>(kNoFraction ^ kNoFraction << 8U ^ kNoFraction << 16U ^ kNoFraction << 24U);
    return bits(a) ^ bits(b) << 8 ^ bits(c) << 16 ^ bits(d) << 24 ^ kRest;
  }

  template <uint32_t kTimes, uint32_t kPart>
  [[gnu::always_inline]] static Int repeated(const Int& value) {
    return repeated<kTimes, kPart>(value, std::make_integer_sequence<uint32_t, kWidth>());
  }

  template <uint32_t kCount>
  [[gnu::always_inline]] static Int load_each(const int32_t* values) {
    static_assert(kCount == 4);
    const auto each = loaded<typename SimdVector<int32_t, kCount * sizeof(int32_t)>::Type>(values);
    if constexpr (kWidth == kCount) {
      return each;
    } else {
      return __builtin_shufflevector(each, each, 0, 1, 2, 3, 0, 1, 2, 3);
    }
  }
  template <uint32_t kCount>
  [[gnu::always_inline]] static Float least_of_each(const Float& value) {
    if constexpr (kCount == 1) {
      return value;
    } else {
      const Float of_two = lesser(value, exchanged<1>(value));
      return lesser(of_two, exchanged<2>(of_two));
    }
  }
  template <uint32_t kCount>
  [[gnu::always_inline]] static Float greatest_of_each(const Float& value) {
    if constexpr (kCount == 1) {
      return value;
    } else {
      const Float of_two = greater(value, exchanged<1>(value));
      return greater(of_two, exchanged<2>(of_two));
    }
  }

 private:
  static constexpr uint64_t kEachByte = 0x0101010101010101U;
  static constexpr uint64_t kOneOfEach = 0x8040201008040201U;

  // GCC 12 would fill the lanes of a vector wider than SSE's one by one.
  template <typename Vector, typename Value>
  [[gnu::always_inline]] static Vector broadcast(Value value) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    const typename SimdVector<Value, 16>::Type first{value};
    if constexpr (sizeof(Vector) == 64) {
      return __builtin_ia32_broadcastsd512(first, Vector{}, 0xFF);
    } else if constexpr (sizeof(Vector) == 32 && sizeof(Value) == sizeof(double)) {
      return __builtin_ia32_vbroadcastsd_pd256(first);
    } else if constexpr (sizeof(Vector) == 32) {
      return __builtin_ia32_vbroadcastss_ps256(first);
    }
#endif
    return value - Vector{};
  }
  template <uint32_t... kNumbers>
  [[gnu::always_inline]] static Int own_bits(std::integer_sequence<uint32_t, kNumbers...> /*all*/) {
    return Int{static_cast<int32_t>(1U << kNumbers)...};
  }
  template <int32_t... kNumbers>
  [[gnu::always_inline]] static Int numbers(std::integer_sequence<int32_t, kNumbers...> /*all*/) {
    return Int{kNumbers...};
  }
  template <typename Value, typename T>
  [[gnu::always_inline]] static Value loaded(const T* values) {
    Value vector;
    std::memcpy(&vector, values, sizeof vector);
    return vector;
  }
  template <typename Value, typename Half, int... kNumbers>
  [[gnu::always_inline]] static Value joined(const Half& low, const Half& high,
                                             std::integer_sequence<int, kNumbers...> /*all*/) {
    return __builtin_shufflevector(low, high, kNumbers...);
  }
  template <typename Half, typename Value>
  [[gnu::always_inline]] static Double widened(const Value& value) {
    Double result;
    for (uint32_t i = 0; i < kParts; ++i) {
      Half half;
      std::memcpy(&half, reinterpret_cast<const std::byte*>(&value) + i * sizeof half, sizeof half);  // NOLINT
      result.parts[i] = __builtin_convertvector(half, Part);
    }
    return result;
  }
  // Lane i gets lane i ^ kDistance.
  template <uint32_t kDistance>
  [[gnu::always_inline]] static Float exchanged(const Float& value) {
    return exchanged<kDistance>(value, std::make_integer_sequence<uint32_t, kWidth>());
  }
  template <uint32_t kDistance, uint32_t... kNumbers>
  [[gnu::always_inline]] static Float exchanged(const Float& value,
                                                std::integer_sequence<uint32_t, kNumbers...> /*all*/) {
    return __builtin_shufflevector(value, value, static_cast<int>(kNumbers ^ kDistance)...);
  }
  template <uint32_t kTimes, uint32_t kPart, uint32_t... kNumbers>
  [[gnu::always_inline]] static Int repeated(const Int& value, std::integer_sequence<uint32_t, kNumbers...> /*all*/) {
    return __builtin_shufflevector(value, value, static_cast<int>((kPart * kWidth + kNumbers) / kTimes)...);
  }
};

using Sse41Lanes = VectorLanes<16, 16>;
using Avx2Lanes = VectorLanes<32, 32>;
using Avx512Lanes = VectorLanes<32, 64>;

}  // namespace fillrule::renderer
