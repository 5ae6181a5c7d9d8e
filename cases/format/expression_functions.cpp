#include "cases/format/expression_functions.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace fillrule::format {
namespace {

// One step of the generator by Steele, Lea and Flood, "Fast splittable pseudorandom number generators" (2014).
uint64_t splitmix64(uint64_t state) {
  uint64_t z = state + 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

// Adding zero makes one value of both zeros.
uint64_t bits_of(double value) {
  return std::bit_cast<uint64_t>(value + 0.0);
}

// float32 values in their order, as consecutive integers; both zeros are 0.
int64_t rank_of(float value) {
  const auto bits = std::bit_cast<uint32_t>(value);
  const auto magnitude = int64_t{bits & 0x7FFFFFFFU};
  return (bits >> 31U) != 0 ? -magnitude : magnitude;
}

float value_of(int64_t rank) {
  const auto magnitude = std::bit_cast<float>(static_cast<uint32_t>(std::abs(rank)));
  return rank < 0 ? -magnitude : magnitude;
}

}  // namespace

double floored_mod(double x, double y) {
  return x - y * std::floor(x / y);
}

double ulp(double x, double steps) {
  const auto start = static_cast<float>(x);
  if (std::isnan(x) || std::isnan(steps)) return std::numeric_limits<double>::quiet_NaN();
  const int64_t limit = rank_of(std::numeric_limits<float>::infinity());
  const double bounded = std::clamp(std::nearbyint(steps), -0x1p33, 0x1p33);
  if (bounded == 0.0) return double{start};
  return double{value_of(std::clamp(rank_of(start) + static_cast<int64_t>(bounded), -limit, limit))};
}

double random_unit(double seed, double k) {
  const uint64_t hash = splitmix64(splitmix64(bits_of(seed)) ^ bits_of(k));
  return static_cast<double>(hash >> 11U) * 0x1p-53;
}

}  // namespace fillrule::format
