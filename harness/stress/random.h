// Random numbers that are the same with every standard library: the distributions of <random> are not.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace fillrule::stress {

class Random {
 public:
  // Another sequence for each combination of the three.
  Random(uint64_t seed, uint64_t family, uint64_t number) : engine_(engine_for(seed, family, number)) {}

  // In [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  // 2^e, e uniform.
  double power_of_two(double low_exponent, double high_exponent) {
    return std::exp2(uniform(low_exponent, high_exponent));
  }
  double sign() { return chance(0.5) ? 1 : -1; }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  uint32_t below(uint32_t limit) { return static_cast<uint32_t>(uniform(0, limit)); }

  template <typename T, size_t N>
  T pick(const std::array<T, N>& choices) {
    return choices[below(static_cast<uint32_t>(N))];
  }

 private:
  static std::mt19937_64 engine_for(uint64_t seed, uint64_t family, uint64_t number) {
    const auto low = [](uint64_t value) { return static_cast<uint32_t>(value); };
    const auto high = [](uint64_t value) { return static_cast<uint32_t>(value >> 32U); };
    std::seed_seq seeds{low(seed), high(seed), low(family), low(number), high(number)};
    return std::mt19937_64(seeds);
  }

  std::mt19937_64 engine_;
};

}  // namespace fillrule::stress
