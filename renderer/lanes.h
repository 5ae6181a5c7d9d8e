// Lanes: one kernel source for a pixel at a time and for several.
//
// A lane type has Float, Int and Double, one of each for every lane, and Mask, what comparing two Floats or two Ints
// gives. All of them take the operators of C++, and `mask ? a : b` chooses lane by lane. Each operation is IEEE's own
// in each lane, none but fused() is fused and none reassociated: so any lane type gives the bytes of ScalarLanes,
// which is here and says what each operation does. Those of several lanes are in vector_lanes.h.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

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
  static Int all(int32_t value) { return value; }
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
  // In lane i, the value of the lane that `lanes` has there.
  template <typename Value>
  static Value chosen(Value values, Int /*lanes*/) {
    return values;
  }
  // Without its fraction.
  static Int truncated(Float value) { return static_cast<Int>(value); }
  static Double magnitude(Double value) { return std::abs(value); }
  static Int bits_of(Float value) {
    Int bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
  }

  // The components of as many four-vectors as there are lanes: that of each lane is where `vector_of(lane)` points.
  template <typename VectorOf>
  static std::array<Float, 4> load_components(const VectorOf& vector_of) {
    const float* const vector = vector_of(0U);
    return {vector[0], vector[1], vector[2], vector[3]};
  }

  // The same of as many pairs.
  static std::array<Int, 2> load_pairs(const int32_t* pairs) { return {pairs[0], pairs[1]}; }

  // a * b + c, rounded once.
  static Float fused(Float a, Float b, Float c) { return std::fma(a, b, c); }
  // To the nearest whole number, ties to even; of values beyond 2^51 nothing is asked.
  static Float to_nearest(Float value) { return to_float((to_double(value) + 0x1.8p52) - 0x1.8p52); }

  // The lanes' lowest bytes, lane 0 lowest.
  static uint64_t low_bytes(Int value) { return static_cast<uint64_t>(value) & 0xFFU; }

  // a < b ? a : b, and a > b ? a : b: the second one if either is NaN.
  static Float lesser(Float a, Float b) { return a < b ? a : b; }
  static Float greater(Float a, Float b) { return a > b ? a : b; }
  static Double greater(Double a, Double b) { return a > b ? a : b; }
  static Int lesser(Int a, Int b) { return a < b ? a : b; }
  static Int greater(Int a, Int b) { return a > b ? a : b; }
  // a <= b in every lane.
  static bool all_at_most(Double a, Double b) { return a <= b; }

  // Some of the lanes, as what stores by them wants it.
  using Some = bool;
  static Some some(uint32_t bits) { return mask_of(bits); }
  static Mask mask(Some lanes) { return lanes; }
  template <uint32_t kFirst>
  static Some some_from(uint64_t bits) {  // the bits from kFirst on
    return some(static_cast<uint32_t>(bits >> kFirst));
  }
  static void store(Some lanes, Float value, float* values) { *values = lanes ? value : *values; }
  static void store(Some lanes, Int value, uint32_t* values) {
    *values = lanes ? static_cast<uint32_t>(value) : *values;
  }
  // Those that are less than what is stored. Bit by bit: which they were.
  static uint32_t store_lesser(Some lanes, Float value, float* values) {
    const bool is_less = lanes && value < *values;
    *values = is_less ? value : *values;
    return is_less ? 1 : 0;
  }

  // Those whose bits are set, one after the other. As many as there are lanes are written, of which the rest is
  // anything.
  static void store_packed(uint32_t /*bits*/, Int value, uint32_t* values) { *values = static_cast<uint32_t>(value); }

  static bool any(Mask mask) { return mask; }
  static Mask negated(Mask mask) { return !mask; }
  // Bit i: lane i.
  static uint32_t sign_bits(Int value) { return static_cast<uint32_t>(value) >> 31U; }
  static uint32_t nonzero_bits(Int value) { return value != 0 ? 1 : 0; }
  static Mask mask_of(uint32_t bits) { return (bits & 1U) != 0; }
  static uint32_t bits_of(Mask mask) { return mask ? 1 : 0; }

  // Four values of 255 at most, to the nearest whole ones, ties to even, as the bytes of each lane, the first one
  // lowest. 0 of what is less, and of NaN.
  static Int packed_bytes(Float a, Float b, Float c, Float d) {
    const auto byte = [](Float value) {
      return bits_of(greater(value, 0.0F) + 0x1.8p23F) & 0xFF;  // no bit is left for a fraction
    };
    return byte(a) | byte(b) << 8 | byte(c) << 16 | static_cast<Int>(static_cast<uint32_t>(byte(d)) << 24U);
  }

  // Lane i of kPart's vector gets lane (kPart * kWidth + i) / kTimes: each lane kTimes, over kTimes vectors.
  template <uint32_t kTimes, uint32_t kPart>
  static Int repeated(Int value) {
    return value;
  }

  // Bit 4 * i + k: whether begins[k] <= first + i < ends[k], of eight numbers and four spans. All are bytes.
  static uint32_t within_four(int32_t first, const int8_t* begins, const int8_t* ends) {
    uint32_t within = 0;
    for (uint32_t bit = 0; bit < 32; ++bit) {
      const int32_t number = first + static_cast<int32_t>(bit / 4);
      const bool is_within = begins[bit % 4] <= number && number < ends[bit % 4];
      within |= (is_within ? 1U : 0U) << bit;
    }
    return within;
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

}  // namespace fillrule::renderer
