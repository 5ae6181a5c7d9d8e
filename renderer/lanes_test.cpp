#include "renderer/lanes.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "renderer/coverage.h"
#include "renderer/isa.h"
#include "renderer/lane_pairs.h"

namespace fillrule::renderer {
namespace {

TEST(Isa, HasANameAndTheBestIsThere) {
  for (const Isa isa : kAllIsas) EXPECT_EQ(isa_named(to_string(isa)), isa);
  EXPECT_FALSE(isa_named("mmx"));
  EXPECT_TRUE(is_supported(Isa::kScalar));
  EXPECT_TRUE(is_supported(best_isa()));
}

constexpr uint32_t kCount = 8;

// What each operation makes of eight numbers.
struct Outcome {
  std::array<float, kCount> narrowed{};
  std::array<float, kCount> chosen{};
  std::array<int32_t, kCount> bits{};
  std::array<float, kCount> limited{};
  std::array<int32_t, kCount> packed{};
  std::array<float, kCount> from_mask{};
  uint32_t below = 0;
  uint32_t negative = 0;
  uint64_t bytes = 0;
  bool operator==(const Outcome&) const = default;
};

Outcome outcome(Isa isa, const std::array<float, kCount>& values) {
  Outcome result;
  dispatch(
      isa, [&]<typename L>() __attribute__((always_inline)) {
        for (uint32_t i = 0; i < kCount; i += L::kWidth) {
          const typename L::Float value = L::load(values.data() + i);
          const typename L::Double wide = L::to_double(value) / L::all(3.0) - L::all(0.1);
          L::store(L::to_float(wide), result.narrowed.data() + i);
          const typename L::Mask below = value < L::all(1.5F);
          const typename L::Mask odd = L::mask_of(0xAAU >> i);
          L::store(odd ? value : L::all(-1.0F), result.chosen.data() + i);
          L::store(L::bits_of(value), result.bits.data() + i);
          const typename L::Float limited = L::lesser(L::greater(value, L::all(0.0F)), L::all(1.5F));
          L::store(limited, result.limited.data() + i);
          L::store(L::packed_bytes(limited, L::all(254.5F), limited * L::all(100.0F), L::all(255.0F)),
                   result.packed.data() + i);
          // Row 4 of a block whose mask has the lanes' bits there, and others around them.
          const uint64_t mask = uint64_t{0x55AA55} << 24U >> i;
          L::store(L::mask(L::template some_from<32>(mask)) ? value : L::all(-1.0F), result.from_mask.data() + i);
          result.negative |= L::sign_bits(L::numbers() + static_cast<int32_t>(i) - 3) << i;
          result.below |= L::bits_of(below) << i;
          result.bytes |= L::low_bytes(L::numbers() + static_cast<int32_t>(i)) << (8 * i);
          EXPECT_EQ(L::any(below), L::bits_of(below) != 0);
          EXPECT_EQ(L::bits_of(L::negated(below)), L::bits_of(below) ^ ((1U << L::kWidth) - 1));
        }
      });
  return result;
}

TEST(Lanes, GiveTheBytesOfOneAtATime) {
  const std::array<float, kCount> values{-0.0F, 0.1F, 1.5F, -7, 1e-40F, 3e38F, 1.4999999F, 2};
  const Outcome expected = outcome(Isa::kScalar, values);
  EXPECT_EQ(expected.below, 0b01011011U);
  EXPECT_EQ(expected.bytes, 0x0706050403020100U);
  EXPECT_EQ(expected.chosen, (std::array<float, kCount>{-1, 0.1F, -1, -7, -1, 3e38F, -1, 2}));
  EXPECT_EQ(expected.limited, (std::array<float, kCount>{0, 0.1F, 1.5F, 0, 1e-40F, 1.5F, 1.4999999F, 1.5F}));
  EXPECT_EQ(static_cast<uint32_t>(expected.packed[1]), 0xFF0AFE00U);  // 0.1, 254.5 to even, 10, 255
  EXPECT_EQ(static_cast<uint32_t>(expected.packed[2]), 0xFF96FE02U);  // 1.5 to even, 150
  EXPECT_EQ(expected.from_mask, (std::array<float, kCount>{-1, 0.1F, -1, -7, -1, 3e38F, -1, 2}));
  EXPECT_EQ(expected.negative, 0b111U);
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa)) continue;
    EXPECT_EQ(outcome(isa, values), expected) << to_string(isa);
  }
}

// Of what only lanes of several rows or samples need.
TEST(Lanes, CutOffFractionsAndSigns) {
  const std::array<float, kCount> values{-0.0F, 0.9999F, -0.9999F, 1.5F, -7.5F, 31.99F, 64, -1e-40F};
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa)) continue;
    std::array<int32_t, kCount> truncated{};
    std::array<float, kCount> magnitudes{};
    dispatch(
        isa, [&]<typename L>() __attribute__((always_inline)) {
          for (uint32_t i = 0; i < kCount; i += L::kWidth) {
            const typename L::Float value = L::load(values.data() + i);
            L::store(L::truncated(value), truncated.data() + i);
            L::store(L::to_float(L::magnitude(L::to_double(value))), magnitudes.data() + i);
          }
        });
    EXPECT_EQ(truncated, (std::array<int32_t, kCount>{0, 0, 0, 1, -7, 31, 64, 0})) << to_string(isa);
    EXPECT_EQ(magnitudes, (std::array<float, kCount>{0, 0.9999F, 0.9999F, 1.5F, 7.5F, 31.99F, 64, 1e-40F}))
        << to_string(isa);
    EXPECT_FALSE(std::signbit(magnitudes[0])) << to_string(isa);
  }
}

TEST(Lanes, ChooseFromLanes) {
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa)) continue;
    dispatch(
        isa, [&]<typename L>() __attribute__((always_inline)) {
          std::array<int32_t, kCount> chosen{};
          std::array<float, kCount> floats{};
          const auto last = static_cast<int32_t>(L::kWidth) - 1;
          L::store(L::chosen(L::numbers() * 10, last - L::numbers()), chosen.data());
          L::store(L::chosen(L::to_float(L::numbers()), L::numbers() & 1), floats.data());
          for (uint32_t lane = 0; lane < L::kWidth; ++lane) {
            EXPECT_EQ(chosen[lane], (last - static_cast<int32_t>(lane)) * 10) << to_string(isa);
            EXPECT_EQ(floats[lane], static_cast<float>(lane & 1U)) << to_string(isa);
          }
        });
  }
}

TEST(Lanes, WidenWholeNumbersExactly) {
  constexpr std::array<int32_t, kCount> kValues{0,         -1, 7, 16777217, -16777217, 2147483647, -2147483647 - 1,
                                                1234567891};
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa)) continue;
    std::array<double, kCount> widened{};
    dispatch(
        isa, [&]<typename L>() __attribute__((always_inline)) {
          for (uint32_t i = 0; i < kCount; i += L::kWidth) {
            L::store(L::to_double(L::load(kValues.data() + i)), widened.data() + i);
          }
        });
    for (size_t i = 0; i < kValues.size(); ++i) EXPECT_EQ(widened[i], kValues[i]) << to_string(isa);
  }
}

TEST(Lanes, RoundOnce) {
  // 1 + 2^-23 squared less 1 + 2^-22 is 2^-46, of which rounding the product first leaves nothing.
  const std::array<float, kCount> factors{1 + 0x1p-23F, 2, -0.5F, 1 + 0x1p-23F, 3, 1e20F, 0, -1};
  const std::array<float, kCount> sums{-1 - 0x1p-22F, 1, 0, -1, -9, -1e38F, -0.0F, 0};
  const std::array<float, kCount> values{0.5F, 1.5F, -2.5F, 0.49999997F, 8388607.5F, -0.0F, 1e9F, -1.5000001F};
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa)) continue;
    std::array<float, kCount> fused{};
    std::array<float, kCount> nearest{};
    dispatch(
        isa, [&]<typename L>() __attribute__((always_inline)) {
          for (uint32_t i = 0; i < kCount; i += L::kWidth) {
            const typename L::Float factor = L::load(factors.data() + i);
            L::store(L::fused(factor, factor, L::load(sums.data() + i)), fused.data() + i);
            L::store(L::to_nearest(L::load(values.data() + i)), nearest.data() + i);
          }
        });
    EXPECT_EQ(fused[0], 0x1p-46F) << to_string(isa);
    for (size_t i = 0; i < kCount; ++i) {
      EXPECT_EQ(fused[i], std::fma(factors[i], factors[i], sums[i])) << to_string(isa) << i;
    }
    EXPECT_EQ(nearest, (std::array<float, kCount>{0, 2, -2, 0, 8388608, 0, 1e9F, -2})) << to_string(isa);
  }
}

TEST(Lanes, TakePairsAndFourVectorsApart) {
  std::array<float, size_t{4} * kCount> vectors{};
  std::iota(vectors.begin(), vectors.end(), 0.0F);
  std::array<int32_t, size_t{2} * kCount> pairs{};
  std::iota(pairs.begin(), pairs.end(), 0);
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa)) continue;
    std::array<std::array<float, kCount>, 4> components{};
    std::array<std::array<int32_t, kCount>, 2> of_pairs{};
    dispatch(
        isa, [&]<typename L>() __attribute__((always_inline)) {
          for (uint32_t i = 0; i < kCount; i += L::kWidth) {
            const auto loaded =
                L::load_components([&](uint32_t lane) { return vectors.data() + size_t{4} * (i + lane); });
            for (size_t component = 0; component < 4; ++component) {
              L::store(loaded[component], components[component].data() + i);
            }
            const auto loaded_pairs = L::load_pairs(pairs.data() + size_t{2} * i);
            L::store(loaded_pairs[0], of_pairs[0].data() + i);
            L::store(loaded_pairs[1], of_pairs[1].data() + i);
          }
        });
    for (size_t i = 0; i < vectors.size(); ++i) {
      EXPECT_EQ(components[i % 4][i / 4], vectors[i]) << to_string(isa) << i;
    }
    for (size_t i = 0; i < pairs.size(); ++i) {
      EXPECT_EQ(of_pairs[i % 2][i / 2], pairs[i]) << to_string(isa) << i;
    }
  }
}

TEST(Lanes, StoreSomeOfThem) {
  constexpr uint32_t kSome = 0b10110010;
  const std::array<int32_t, kCount> values{10, 11, 12, 13, 14, 15, 16, -17};
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa)) continue;
    std::array<uint32_t, kCount> stored{};
    std::array<uint32_t, size_t{2} * kCount> packed{};
    size_t count = 0;
    dispatch(
        isa, [&]<typename L>() __attribute__((always_inline)) {
          constexpr uint32_t kAllLanes = (1U << L::kWidth) - 1;
          for (uint32_t i = 0; i < kCount; i += L::kWidth) {
            const uint32_t bits = kSome >> i & kAllLanes;
            L::store(L::some(bits), L::load(values.data() + i), stored.data() + i);
            L::store_packed(bits, L::load(values.data() + i), packed.data() + count);
            count += static_cast<size_t>(std::popcount(bits));
          }
        });
    EXPECT_EQ(stored, (std::array<uint32_t, kCount>{0, 11, 0, 0, 14, 15, 0, static_cast<uint32_t>(-17)}))
        << to_string(isa);
    packed[count] = 0;
    EXPECT_EQ(count, 4U);
    EXPECT_EQ(std::vector(packed.begin(), packed.begin() + 4),
              (std::vector<uint32_t>{11, 14, 15, static_cast<uint32_t>(-17)}))
        << to_string(isa);
  }
}

TEST(Lanes, StoreWhatIsLess) {
  constexpr uint32_t kSome = 0b01111110;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::array<float, kCount> values{-1, 0.5F, nan, 1, -0.0F, 3, 0.25F, -1};
  const std::array<float, kCount> before{0, 1, 1, 1, 0, nan, 0.5F, 0};
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa)) continue;
    std::array<float, kCount> stored = before;
    uint32_t lesser = 0;
    dispatch(
        isa, [&]<typename L>() __attribute__((always_inline)) {
          for (uint32_t i = 0; i < kCount; i += L::kWidth) {
            lesser |= L::store_lesser(L::some(kSome >> i), L::load(values.data() + i), stored.data() + i) << i;
          }
        });
    EXPECT_EQ(lesser, 0b01000010U) << to_string(isa);
    for (uint32_t i = 0; i < kCount; ++i) {
      EXPECT_EQ(std::bit_cast<uint32_t>(stored[i]),
                std::bit_cast<uint32_t>((lesser >> i & 1U) != 0 ? values[i] : before[i]))
          << to_string(isa) << i;
    }
  }
}

TEST(Lanes, CompareWholeNumbers) {
  const std::array<int32_t, kCount> values{0, -1, 7, INT32_MIN, 0, INT32_MAX, 1 << 24, 3};
  const std::array<int32_t, kCount> others{0, 2, -7, 1, -1, INT32_MIN, (1 << 24) + 1, 3};
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa)) continue;
    std::array<int32_t, kCount> lesser{};
    std::array<int32_t, kCount> greater{};
    uint32_t nonzero = 0;
    dispatch(
        isa, [&]<typename L>() __attribute__((always_inline)) {
          for (uint32_t i = 0; i < kCount; i += L::kWidth) {
            const typename L::Int value = L::load(values.data() + i);
            L::store(L::lesser(value, L::load(others.data() + i)), lesser.data() + i);
            L::store(L::greater(value, L::load(others.data() + i)), greater.data() + i);
            nonzero |= L::nonzero_bits(value) << i;
          }
        });
    for (size_t i = 0; i < kCount; ++i) {
      EXPECT_EQ(lesser[i], std::min(values[i], others[i])) << to_string(isa) << i;
      EXPECT_EQ(greater[i], std::max(values[i], others[i])) << to_string(isa) << i;
    }
    EXPECT_EQ(nonzero, 0b11101110U) << to_string(isa);
  }
}

TEST(Lanes, PackNothingOfWhatIsNoColor) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const std::array<float, kCount> values{-1, -1e30F, -kInfinity, std::nanf(""), -0.4F, 0, 255, -70000};
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa)) continue;
    std::array<int32_t, kCount> packed{};
    std::array<int32_t, size_t{2} * kCount> of_pairs{};
    dispatch(
        isa, [&]<typename L>() __attribute__((always_inline)) {
          for (uint32_t i = 0; i < kCount; i += L::kWidth) {
            const auto value = L::load(values.data() + i);
            L::store(L::packed_bytes(value, value, value, L::all(9.0F)), packed.data() + i);
          }
          if constexpr (LanePairs<L>::kExist) {
            using Pairs = LanePairs<L>;
            const auto pair = Pairs::pair(L::load(values.data()), L::all(7.0F));
            const auto bytes =
                Pairs::Lanes::packed_bytes(pair, pair, Pairs::Lanes::all(8.0F), Pairs::Lanes::all(9.0F));
            L::store(Pairs::first_of(bytes), of_pairs.data());
            L::store(Pairs::second_of(bytes), of_pairs.data() + kCount);
          }
        });
    for (size_t i = 0; i < kCount; ++i) {
      EXPECT_EQ(packed[i], values[i] == 255 ? 0x09FFFFFF : 0x09000000) << to_string(isa) << i;
      if (isa == Isa::kAvx512) {
        EXPECT_EQ(of_pairs[i], values[i] == 255 ? 0x0908FFFF : 0x09080000) << i;
        EXPECT_EQ(of_pairs[i + kCount], 0x09080707) << i;
      }
    }
  }
}

TEST(Lanes, AreWithinSpans) {
  const std::array<int8_t, 4> begins{0, -3, 5, 2};
  const std::array<int8_t, 4> ends{8, 1, 127, 2};
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa)) continue;
    std::array<uint32_t, 2> within{};
    dispatch(
        isa, [&]<typename L>() __attribute__((always_inline)) {
          within = {L::within_four(0, begins.data(), ends.data()), L::within_four(5, begins.data(), ends.data())};
        });
    EXPECT_EQ(within[0], 0x55511113U) << to_string(isa);
    EXPECT_EQ(within[1], 0x44444555U) << to_string(isa);
  }
}

// Four lanes side by side, as the samples of a pixel are.
TEST(Lanes, AreComparedFourByFour) {
  const std::array<float, kCount> values{3, -1, 2, 0.5F, -8, -9, -7, -8.5F};
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa) || isa == Isa::kScalar) continue;
    dispatch(
        isa, [&]<typename L>() __attribute__((always_inline)) {
          if constexpr (L::kWidth > 1) {
            std::array<float, L::kWidth> least{};
            std::array<float, L::kWidth> greatest{};
            for (uint32_t first = 0; first < kCount; first += L::kWidth) {
              const typename L::Float value = L::load(values.data() + first);
              L::store(L::template least_of_each<4>(value), least.data());
              L::store(L::template greatest_of_each<4>(value), greatest.data());
              for (uint32_t lane = 0; lane < L::kWidth; ++lane) {
                const bool is_first_four = first + lane < 4;
                EXPECT_EQ(least[lane], is_first_four ? -1 : -9) << to_string(isa) << lane;
                EXPECT_EQ(greatest[lane], is_first_four ? 3 : -7) << to_string(isa) << lane;
              }
            }
          }
        });
  }
}

TEST(Lanes, LimitWhatIsNoNumber) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa)) continue;
    std::array<float, kCount> values;
    values.fill(nan);
    dispatch(
        isa, [&]<typename L>() __attribute__((always_inline)) {
          for (uint32_t i = 0; i < kCount; i += L::kWidth) {
            L::store(L::greater(L::load(values.data() + i), L::all(0.0F)), values.data() + i);
          }
        });
    EXPECT_EQ(values, (std::array<float, kCount>{})) << to_string(isa);
  }
}

TEST(Lanes, RepeatEachOfThem) {
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa)) continue;
    dispatch(
        isa, [&]<typename L>() __attribute__((always_inline)) {
          std::array<int32_t, size_t{2} * L::kWidth> result{};
          L::store(L::template repeated<2, 0>(L::numbers()), result.data());
          L::store(L::template repeated<2, 1>(L::numbers()), result.data() + L::kWidth);
          for (size_t i = 0; i < result.size(); ++i)
            EXPECT_EQ(result[i], static_cast<int32_t>(i / 2)) << to_string(isa);
        });
  }
}

TEST(Coverage, IsTheSameWithAnyInstructionSet) {
  // Gentle edges, and steep ones beyond int32.
  for (const int32_t reach : {100 * 256, 1 << 29}) {
    const std::array<FixedPosition, 3> outline{{{5 * 256 + 77, 3 * 256}, {-reach, reach}, {reach, 60 * 256 + 13}}};
    const PixelRect rect{1, 2, 61, 63};
    TileCoverage expected;
    cover(outline, pixel_centre_fixed(8), 8, rect, expected, Isa::kScalar);
    EXPECT_GT(expected.count, 0U);
    for (const Isa isa : kAllIsas) {
      if (!is_supported(isa)) continue;
      TileCoverage coverage;
      cover(outline, pixel_centre_fixed(8), 8, rect, coverage, isa);
      ASSERT_EQ(coverage.count, expected.count) << to_string(isa);
      for (uint32_t i = 0; i < coverage.count; ++i) EXPECT_EQ(coverage.blocks[i].mask, expected.blocks[i].mask);
    }
  }
}

}  // namespace
}  // namespace fillrule::renderer
