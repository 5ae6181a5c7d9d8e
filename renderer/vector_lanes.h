// The lane types of several lanes (lanes.h says what their operations do), and with double_lanes.h and simd_vector.h
// the only place with intrinsics.
//
// They are made of vectors of the compilers' extension (simd_vector.h), for the instructions of the function that
// they are inlined into (isa.h chooses those at run time). Whatever takes or returns lanes must therefore be inlined
// always: [[gnu::always_inline]].
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "renderer/double_lanes.h"
#include "renderer/simd_vector.h"

namespace fillrule::renderer {

// The numbers of the bits that are set in a byte, ascending.
constexpr std::array<std::array<uint8_t, 16>, 256> numbers_of_bits() {
  std::array<std::array<uint8_t, 16>, 256> numbers{};
  for (uint32_t byte = 0; byte < numbers.size(); ++byte) {
    for (uint32_t bit = 0, count = 0; bit < 8; ++bit) {
      numbers[byte][count] = static_cast<uint8_t>(bit);
      count += byte >> bit & 1U;
    }
  }
  return numbers;
}
inline constexpr std::array<std::array<uint8_t, 16>, 256> kNumbersOfBits = numbers_of_bits();

// kFloatBytes: of a vector of floats. kDoubleBytes: of the vectors that Double is made of, one or two; those of 64
// bytes come with AVX-512, whose masks are bits.
template <uint32_t kFloatBytes, uint32_t kDoubleBytes>
struct VectorLanes {
  static constexpr uint32_t kWidth = kFloatBytes / sizeof(float);
#ifdef FILLRULE_HAS_LANE_BUILTINS
  static constexpr bool kMasksAreBits = kDoubleBytes == 64;
#else
  static constexpr bool kMasksAreBits = false;
#endif
  static constexpr uint32_t kParts = kWidth * sizeof(double) / kDoubleBytes;
  static_assert(kParts == 1 || kParts == 2);

  using Float = typename SimdVector<float, kFloatBytes>::Type;
  using Int = typename SimdVector<int32_t, kFloatBytes>::Type;
  using Mask = Int;                                              // all bits of a lane, or none
  using Part = typename SimdVector<double, kDoubleBytes>::Type;  // of Double
  using Bytes = typename SimdVector<int8_t, kWidth>::Type;       // one a lane
  using Chars = typename SimdVector<char, kFloatBytes>::Type;

  using Double = DoubleLanes<kDoubleBytes, kParts>;

  [[gnu::always_inline]] static Float all(float value) {
    return broadcast<Float>(value);
  }
  [[gnu::always_inline]] static Double all(double value) {
    Double result;
    for (Part& part : result.parts) {
      part = broadcast<Part>(value);
    }
    return result;
  }
  [[gnu::always_inline]] static Int all(int32_t value) {
    return broadcast<Int>(value);
  }
  [[gnu::always_inline]] static Int numbers() {
    return numbers(std::make_integer_sequence<int32_t, kWidth>());
  }

  [[gnu::always_inline]] static Float load(const float* values) {
    return loaded<Float>(values);
  }
  [[gnu::always_inline]] static Int load(const int32_t* values) {
    return loaded<Int>(values);
  }
  [[gnu::always_inline]] static Int load(const uint32_t* values) {
    return loaded<Int>(values);
  }
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
      return Double::narrowed(value.parts[0]);
    } else {
      return joined<Float>(Double::narrowed(value.parts[0]), Double::narrowed(value.parts[1]),
                           std::make_integer_sequence<int, kWidth>());
    }
  }
  [[gnu::always_inline]] static Float to_float(const Int& value) {
    return __builtin_convertvector(value, Float);
  }
  [[gnu::always_inline]] static Double to_double(const Float& value) {
    return widened<typename Double::Floats>(value);
  }
  [[gnu::always_inline]] static Double to_double(const Int& value) {
    return widened<typename Double::Ints>(value);
  }
  [[gnu::always_inline]] static Double magnitude(const Double& value) {
    return value.magnitude();
  }
  template <typename Value>
  [[gnu::always_inline]] static Value chosen(const Value& values, const Int& lanes) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    if constexpr (kFloatBytes == 32 && std::is_same_v<Value, Float>) {
      return __builtin_ia32_permvarsf256(values, lanes);
    } else if constexpr (kFloatBytes == 32) {
      return __builtin_ia32_permvarsi256(values, lanes);
    } else if constexpr (kFloatBytes == 16) {
      using Chars = typename SimdVector<char, 16>::Type;
      const Int bytes = lanes * 0x04040404 + 0x03020100;
      const auto result =
          __builtin_ia32_pshufb128(reinterpret_cast<const Chars&>(values), reinterpret_cast<const Chars&>(bytes));
      return reinterpret_cast<const Value&>(result);
    }
#endif
    Value result;
    for (uint32_t lane = 0; lane < kWidth; ++lane) {
      result[lane] = values[lanes[lane]];
    }
    return result;
  }
  [[gnu::always_inline]] static Int truncated(const Float& value) {
    return __builtin_convertvector(value, Int);
  }
  [[gnu::always_inline]] static Int bits_of(const Float& value) {
    Int bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
  }

  template <typename VectorOf>
  [[gnu::always_inline]] static std::array<Float, 4> load_components(const VectorOf& vector_of) {
    // In each quarter of 16 bytes the four-vectors of as many lanes: those of lane i and, if there are eight, i + 4.
    const auto of_lane = [&](uint32_t lane) __attribute__((always_inline)) {
      using Four = typename SimdVector<float, 16>::Type;
      const Four low = loaded<Four>(vector_of(lane));
      if constexpr (kWidth == 4) {
        return low;
      } else {
        const Four high = loaded<Four>(vector_of(lane + 4));
        return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
      }
    };
    const Float a = of_lane(0);
    const Float b = of_lane(1);
    const Float c = of_lane(2);
    const Float d = of_lane(3);
    const Float ac_low = interleaved<0>(a, c);  // a0 c0 a1 c1
    const Float ac_high = interleaved<2>(a, c);
    const Float bd_low = interleaved<0>(b, d);
    const Float bd_high = interleaved<2>(b, d);
    return {interleaved<0>(ac_low, bd_low), interleaved<2>(ac_low, bd_low), interleaved<0>(ac_high, bd_high),
            interleaved<2>(ac_high, bd_high)};
  }

  [[gnu::always_inline]] static std::array<Int, 2> load_pairs(const int32_t* pairs) {
    const Int low = load(pairs);
    const Int high = load(pairs + kWidth);
    if constexpr (kWidth == 4) {
      return {__builtin_shufflevector(low, high, 0, 2, 4, 6), __builtin_shufflevector(low, high, 1, 3, 5, 7)};
    } else {
      return {__builtin_shufflevector(low, high, 0, 2, 4, 6, 8, 10, 12, 14),
              __builtin_shufflevector(low, high, 1, 3, 5, 7, 9, 11, 13, 15)};
    }
  }

  [[gnu::always_inline]] static Float fused(const Float& a, const Float& b, const Float& c) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    if constexpr (kFloatBytes == 32) {
      return __builtin_ia32_vfmaddps256(a, b, c);
    }
#endif
    Float result;
    for (uint32_t lane = 0; lane < kWidth; ++lane) {
      result[lane] = std::fma(a[lane], b[lane], c[lane]);
    }
    return result;
  }
  [[gnu::always_inline]] static Float to_nearest(const Float& value) {
    return to_float((to_double(value) + all(0x1.8p52)) - all(0x1.8p52));
  }

  [[gnu::always_inline]] static Float lesser(const Float& a, const Float& b) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    if constexpr (kFloatBytes == 16) {
      return __builtin_ia32_minps(a, b);
    } else if constexpr (kFloatBytes == 32) {
      return __builtin_ia32_minps256(a, b);
    } else {
      return __builtin_ia32_minps512_mask(a, b, a, kAllOf512, kCurrentRounding);
    }
#else
    return a < b ? a : b;
#endif
  }
  [[gnu::always_inline]] static Float greater(const Float& a, const Float& b) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    if constexpr (kFloatBytes == 16) {
      return __builtin_ia32_maxps(a, b);
    } else if constexpr (kFloatBytes == 32) {
      return __builtin_ia32_maxps256(a, b);
    } else {
      return __builtin_ia32_maxps512_mask(a, b, a, kAllOf512, kCurrentRounding);
    }
#else
    return a > b ? a : b;
#endif
  }

  [[gnu::always_inline]] static Double greater(const Double& a, const Double& b) {
    return Double::each(
        a, b, [](const Part& p, const Part& q) __attribute__((always_inline)) { return p > q ? p : q; });
  }
  [[gnu::always_inline]] static Int lesser(const Int& a, const Int& b) {
    return a < b ? a : b;
  }
  [[gnu::always_inline]] static Int greater(const Int& a, const Int& b) {
    return a > b ? a : b;
  }
  [[gnu::always_inline]] static bool all_at_most(const Double& a, const Double& b) {
    const Double beyond = Double::each(
        a, b,
        [](const Part& p, const Part& q) __attribute__((always_inline)) { return p <= q ? Part{} : Part{} + 1; });
    return !any(to_float(beyond) > all(0.0F));
  }

  using Some = std::conditional_t<kMasksAreBits, std::conditional_t<kWidth == 16, uint16_t, uint8_t>, Mask>;
  [[gnu::always_inline]] static Some some(uint32_t bits) {
    if constexpr (kMasksAreBits) {
      return static_cast<Some>(bits);
    } else {
      return mask_of(bits);
    }
  }
  [[gnu::always_inline]] static Mask mask(const Some& lanes) {
    if constexpr (kMasksAreBits) {
      return mask_of(lanes);
    } else {
      return lanes;
    }
  }
  template <uint32_t kFirst>
  [[gnu::always_inline]] static Some some_from(uint64_t bits) {
    if constexpr (kMasksAreBits || kFloatBytes == 16) {
      return some(static_cast<uint32_t>(bits >> kFirst));
    } else {
      // Each lane moves its own bit to the sign.
      const auto half = static_cast<int32_t>(bits >> (kFirst & 32U));
      return (((half + Int{}) << (31 - static_cast<int32_t>(kFirst & 31U) - numbers())) < 0);
    }
  }
  [[gnu::always_inline]] static void store(const Some& lanes, const Int& value, uint32_t* values) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    if constexpr (kMasksAreBits) {
      __builtin_ia32_storedqusi256_mask(reinterpret_cast<int32_t*>(values), value, lanes);
      return;
    }
#endif
    if constexpr (!kMasksAreBits) {
      store(lanes ? value : load(values), values);
    }
  }
  [[gnu::always_inline]] static void store(const Some& lanes, const Float& value, float* values) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    if constexpr (kMasksAreBits) {
      __builtin_ia32_storeups256_mask(values, value, lanes);
      return;
    }
#endif
    if constexpr (!kMasksAreBits) {
      store(lanes ? value : load(values), values);
    }
  }
  [[gnu::always_inline]] static uint32_t store_lesser(const Some& lanes, const Float& value, float* values) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    constexpr int kLess = 1;
    if constexpr (kMasksAreBits && kFloatBytes == 64) {
      const auto lesser =
          static_cast<Some>(__builtin_ia32_cmpps512_mask(value, load(values), kLess, lanes, kCurrentRounding));
      __builtin_ia32_storeups512_mask(values, value, lesser);
      return lesser;
    } else if constexpr (kMasksAreBits) {
      const auto lesser = static_cast<Some>(__builtin_ia32_cmpps256_mask(value, load(values), kLess, lanes));
      __builtin_ia32_storeups256_mask(values, value, lesser);
      return lesser;
    } else
#endif
    {
      const Float stored = load(values);
      const Mask is_less = lanes & (value < stored);
      store(is_less ? value : stored, values);
      return bits_of(is_less);
    }
  }

  [[gnu::always_inline]] static void store_packed(uint32_t bits, const Int& value, uint32_t* values) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    if constexpr (kMasksAreBits) {
      store(__builtin_ia32_compresssi256_mask(value, value, static_cast<uint8_t>(bits)), values);
      return;
    } else if constexpr (kFloatBytes == 32) {
      const Int order =
          __builtin_ia32_pmovzxbd256(loaded<typename SimdVector<char, 16>::Type>(kNumbersOfBits[bits].data()));
      store(__builtin_ia32_permvarsi256(value, order), values);
      return;
    }
#endif
    for (uint32_t lane = 0, count = 0; lane < kWidth; ++lane) {
      values[count] = static_cast<uint32_t>(value[lane]);
      count += bits >> lane & 1U;
    }
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
    static_assert(kWidth <= sizeof(uint64_t));
    uint64_t result = 0;
#ifdef FILLRULE_HAS_LANE_BUILTINS
    // Before AVX-512 GCC 12 by itself would take the lanes apart.
    if constexpr (!kMasksAreBits) {
      const typename SimdVector<char, 16>::Type order{0, 4, 8, 12};
      if constexpr (kFloatBytes == 16) {
        const auto bytes = __builtin_ia32_pshufb128(reinterpret_cast<const Chars&>(value), order);
        std::memcpy(&result, &bytes, kWidth);
      } else {
        const auto orders = joined<Chars>(order, order, std::make_integer_sequence<int, kFloatBytes>());
        const auto bytes = __builtin_ia32_pshufb256(reinterpret_cast<const Chars&>(value), orders);
        const Int halves = __builtin_ia32_permvarsi256(reinterpret_cast<const Int&>(bytes), Int{0, 4});
        std::memcpy(&result, &halves, kWidth);
      }
      return result;
    }
#endif
    const Bytes bytes = __builtin_convertvector(value, Bytes);
    std::memcpy(&result, &bytes, sizeof bytes);
    return result;
  }
  [[gnu::always_inline]] static uint32_t bits_of(const Mask& mask) {
    return sign_bits(mask);
  }
  [[gnu::always_inline]] static uint32_t nonzero_bits(const Int& value) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    if constexpr (kMasksAreBits && kFloatBytes == 32) {
      return static_cast<uint8_t>(__builtin_ia32_ptestmd256(value, value, 0xFF));
    }
#endif
    return bits_of(value != 0);
  }
  [[gnu::always_inline]] static uint32_t sign_bits(const Int& value) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    if constexpr (kFloatBytes == 16) {
      return static_cast<uint32_t>(__builtin_ia32_movmskps(reinterpret_cast<const Float&>(value)));
    } else {
      return static_cast<uint32_t>(__builtin_ia32_movmskps256(reinterpret_cast<const Float&>(value)));
    }
#else
    if constexpr (kWidth > sizeof(uint64_t)) {
      uint32_t bits = 0;
      for (uint32_t lane = 0; lane < kWidth; ++lane) {
        bits |= static_cast<uint32_t>(value[lane]) >> 31U << lane;
      }
      return bits;
    } else {
      // The product moves one bit of each byte to the top byte.
      return static_cast<uint32_t>((low_bytes(value < 0) & kOneOfEach) * kEachByte >> 56U);
    }
#endif
  }

  [[gnu::always_inline]] static Int packed_bytes(const Float& a, const Float& b, const Float& c, const Float& d) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    // Conversions make the least int32 of NaN, and packing 0 of all that is less.
    if constexpr (kFloatBytes == 32) {
      using Words = typename SimdVector<int16_t, 32>::Type;
      const Words ab = __builtin_ia32_packssdw256(__builtin_ia32_cvtps2dq256(a), __builtin_ia32_cvtps2dq256(b));
      const Words cd = __builtin_ia32_packssdw256(__builtin_ia32_cvtps2dq256(c), __builtin_ia32_cvtps2dq256(d));
      const auto bytes = __builtin_ia32_pshufb256(__builtin_ia32_packuswb256(ab, cd), order_of_packed_bytes());
      return reinterpret_cast<const Int&>(bytes);
    } else if constexpr (kFloatBytes == 64) {
      using Words = typename SimdVector<int16_t, 64>::Type;
      using Chars = typename SimdVector<char, 64>::Type;
      const auto whole = [](const Float& value) __attribute__((always_inline)) {
        return __builtin_ia32_cvtps2dq512_mask(value, Int{}, kAllOf512, kCurrentRounding);
      };
      const Words ab = __builtin_ia32_packssdw512_mask(whole(a), whole(b), Words{}, ~0U);
      const Words cd = __builtin_ia32_packssdw512_mask(whole(c), whole(d), Words{}, ~0U);
      const Chars packed = __builtin_ia32_packuswb512_mask(ab, cd, Chars{}, ~uint64_t{0});
      const Chars bytes = __builtin_ia32_pshufb512_mask(packed, order_of_packed_bytes(), Chars{}, ~uint64_t{0});
      return reinterpret_cast<const Int&>(bytes);
    }
#endif
    const auto bits = [](const Float& value) __attribute__((always_inline)) {
      return bits_of(greater(value, all(0.0F)) + all(0x1.8p23F));
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

  [[gnu::always_inline]] static uint32_t within_four(int32_t first, const int8_t* begins, const int8_t* ends) {
    constexpr auto kNumbersInVector = static_cast<int32_t>(kFloatBytes / 4);
    const Chars all_begins = repeated_bytes(begins);
    const Chars all_ends = repeated_bytes(ends);
    uint32_t within = 0;
    for (int32_t i = 0; i < 8; i += kNumbersInVector) {
      const Chars numbers =
          each_four_times(std::make_integer_sequence<int32_t, kFloatBytes>()) + static_cast<char>(first + i);
      within |= bits_within(numbers, all_begins, all_ends) << static_cast<uint32_t>(4 * i);
    }
    return within;
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
#ifdef FILLRULE_HAS_LANE_BUILTINS
  // In each 16 bytes of a packed vector four bytes of each value follow those of the last.
  template <int... kNumbers>
  [[gnu::always_inline]] static auto order_of_packed_bytes(std::integer_sequence<int, kNumbers...> /*all*/) {
    const typename SimdVector<char, 16>::Type order{0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15};
    return __builtin_shufflevector(order, order, kNumbers % 16 ...);
  }
  [[gnu::always_inline]] static auto order_of_packed_bytes() {
    return order_of_packed_bytes(std::make_integer_sequence<int, kFloatBytes>());
  }
#endif
  // Four bytes, again and again.
  [[gnu::always_inline]] static Chars repeated_bytes(const int8_t* four) {
    int32_t bits = 0;
    std::memcpy(&bits, four, sizeof bits);
    const Int each = all(bits);
    return reinterpret_cast<const Chars&>(each);
  }
  template <int32_t... kNumbers>
  [[gnu::always_inline]] static Chars each_four_times(std::integer_sequence<int32_t, kNumbers...> /*all*/) {
    return Chars{static_cast<char>(kNumbers / 4)...};
  }
  // Byte by byte: begins <= values < ends.
  [[gnu::always_inline]] static uint32_t bits_within(const Chars& values, const Chars& begins, const Chars& ends) {
#ifdef FILLRULE_HAS_LANE_BUILTINS
    if constexpr (kMasksAreBits && kFloatBytes == 32) {
      constexpr int kLess = 1;
      constexpr int kAtMost = 2;
      const auto begun = static_cast<uint32_t>(__builtin_ia32_cmpb256_mask(begins, values, kAtMost, ~0U));
      return static_cast<uint32_t>(__builtin_ia32_cmpb256_mask(values, ends, kLess, begun));
    } else if constexpr (kFloatBytes == 32) {
      return static_cast<uint32_t>(__builtin_ia32_pmovmskb256((values < ends) & ~(values < begins)));
    } else if constexpr (kFloatBytes == 16) {
      return static_cast<uint32_t>(__builtin_ia32_pmovmskb128((values < ends) & ~(values < begins)));
    }
#endif
    uint32_t bits = 0;
    for (uint32_t i = 0; i < kFloatBytes; ++i) {
      bits |= (begins[i] <= values[i] && values[i] < ends[i] ? 1U : 0U) << i;
    }
    return bits;
  }
  static constexpr uint64_t kEachByte = 0x0101010101010101U;
  static constexpr uint64_t kOneOfEach = 0x8040201008040201U;

  template <uint32_t... kNumbers>
  [[gnu::always_inline]] static Int own_bits(std::integer_sequence<uint32_t, kNumbers...> /*all*/) {
    return Int{static_cast<int32_t>(1U << kNumbers)...};
  }
  template <int32_t... kNumbers>
  [[gnu::always_inline]] static Int numbers(std::integer_sequence<int32_t, kNumbers...> /*all*/) {
    return Int{kNumbers...};
  }
  template <typename Half, typename Value>
  [[gnu::always_inline]] static Double widened(const Value& value) {
    Double result;
    for (uint32_t i = 0; i < kParts; ++i) {
      Half half;
      std::memcpy(&half, reinterpret_cast<const std::byte*>(&value) + i * sizeof half, sizeof half);  // NOLINT
      result.parts[i] = Double::widened(half);
    }
    return result;
  }
  // In each 16 bytes: two values of a from kFirst on, each followed by that of b.
  template <int kFirst>
  [[gnu::always_inline]] static Float interleaved(const Float& a, const Float& b) {
    constexpr int kB = kWidth + kFirst;
    if constexpr (kWidth == 4) {
      return __builtin_shufflevector(a, b, kFirst, kB, kFirst + 1, kB + 1);
    } else {
      return __builtin_shufflevector(a, b, kFirst, kB, kFirst + 1, kB + 1, kFirst + 4, kB + 4, kFirst + 5, kB + 5);
    }
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
