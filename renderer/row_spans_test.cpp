#include "renderer/row_spans.h"

#include <gtest/gtest.h>

#include <bit>
#include <memory>
#include <random>
#include <vector>

#include "renderer/isa.h"
#include "renderer/sample_locations.h"

namespace fillrule::renderer::internal {
namespace {

// A small triangle in a rectangle that holds all the pixels it may cover, or a part of them.
struct SmallTriangle {
  std::array<FixedPosition, 3> vertices;
  uint32_t subpixel_bits = 8;
  uint32_t samples = 1;
  PixelRect rect;
};

std::vector<FixedPosition> samples_of(const SmallTriangle& one) {
  std::vector<FixedPosition> samples;
  for (const SampleLocation& location : standard_sample_locations(one.samples)) {
    samples.push_back(location.fixed(one.subpixel_bits));
  }
  return samples;
}

SpanSamples lanes_of(const SmallTriangle& one) {
  const std::vector<FixedPosition> samples = samples_of(one);
  SpanSamples lanes;
  for (uint32_t i = 0; i < kBlockSize; ++i) {
    const FixedPosition& sample = samples[i % one.samples];
    lanes.x_fixed[i] = sample.x_fixed;
    lanes.y_fixed[i] = sample.y_fixed + (static_cast<int32_t>(i / one.samples) << one.subpixel_bits);
  }
  return lanes;
}

// Of the rectangle's pixels row by row the covered samples, bit by bit, by the edge functions themselves.
std::vector<uint32_t> expected_of(const SmallTriangle& one) {
  std::array<FixedPosition, 3> triangle = one.vertices;
  if (doubled_area(triangle[0], triangle[1], triangle[2]) < 0) {
    std::swap(triangle[1], triangle[2]);
  }
  const bool has_area = doubled_area(triangle[0], triangle[1], triangle[2]) != 0;
  const std::vector<FixedPosition> samples = samples_of(one);
  std::vector<uint32_t> covered;
  for (int32_t y = one.rect.top; y < one.rect.bottom; ++y) {
    for (int32_t x = one.rect.left; x < one.rect.right; ++x) {
      uint32_t bits = 0;
      for (uint32_t s = 0; s < samples.size(); ++s) {
        bool is_inside = has_area;
        for (size_t i = 0; i < 3; ++i) {
          const EdgeFunction edge = edge_function(triangle[i], triangle[(i + 1) % 3], samples[s], one.subpixel_bits);
          is_inside = is_inside && edge.at(x, y) >= 0;
        }
        bits |= (is_inside ? 1U : 0U) << s;
      }
      covered.push_back(bits);
    }
  }
  return covered;
}

// The same by spans; what lies beyond the rectangle, or is there twice, is reported.
std::vector<uint32_t> covered_of(const SmallTriangle& one, Isa isa) {
  const auto list = std::make_unique<RunList>();
  list->tile_left = one.rect.left / kTileSize * kTileSize;
  list->tile_top = one.rect.top / kTileSize * kTileSize;
  list->primitive = 15;
  dispatch(
      isa, [&]<typename L>() __attribute__((always_inline)) {
        if (one.samples == 1) {
          cover_small<L, 1>(one.vertices, lanes_of(one), one.subpixel_bits, one.rect, *list);
        } else if constexpr (L::kWidth > 1) {
          cover_small<L, 4>(one.vertices, lanes_of(one), one.subpixel_bits, one.rect, *list);
        }
      });
  EXPECT_LE(list->count, kMaxRunsOfTriangle);
  std::vector<uint32_t> covered(static_cast<size_t>(one.rect.width()) * static_cast<size_t>(one.rect.height()));
  for (uint32_t i = 0; i < list->count; ++i) {
    const PixelRun run = list->run(i);
    EXPECT_NE(run.samples, 0U);
    EXPECT_EQ(run.primitive, 15U);
    for (uint32_t bit = 0; bit < kBlockSize * one.samples; ++bit) {
      if ((run.samples >> bit & 1U) == 0) {
        continue;
      }
      const int32_t x = list->tile_left + static_cast<int32_t>(run.x() + bit / one.samples) - one.rect.left;
      const int32_t y = list->tile_top + static_cast<int32_t>(run.y()) - one.rect.top;
      if (x < 0 || x >= one.rect.width() || y < 0 || y >= one.rect.height()) {
        ADD_FAILURE() << "a pixel beyond the rectangle: " << x << ", " << y;
        continue;
      }
      uint32_t& bits =
          covered[static_cast<size_t>(y) * static_cast<size_t>(one.rect.width()) + static_cast<size_t>(x)];
      EXPECT_EQ(bits >> bit % one.samples & 1U, 0U) << "twice";
      bits |= 1U << bit % one.samples;
    }
  }
  return covered;
}

void expect_exact(const SmallTriangle& one) {
  ASSERT_TRUE(is_small(one.vertices, one.rect));
  const std::vector<uint32_t> expected = expected_of(one);
  for (const Isa isa : kAllIsas) {
    if (is_supported(isa) && (one.samples == 1 || isa != Isa::kScalar)) {
      ASSERT_EQ(covered_of(one, isa), expected) << to_string(isa) << ", subpixel bits " << one.subpixel_bits;
    }
  }
}

// The pixels around the triangle that lie in the tile of its first vertex, within 32 x 32 of them.
PixelRect rect_of(const std::array<FixedPosition, 3>& triangle, uint32_t bits) {
  const auto& [a, b, c] = triangle;
  const auto span = [bits](int32_t p, int32_t q, int32_t r) {
    const int32_t tile = (p >> bits) & ~(kTileSize - 1);
    const int32_t low = std::clamp(std::min(std::min(p, q), r) >> bits, tile, tile + kTileSize - 1);
    const int32_t high = std::clamp((std::max(std::max(p, q), r) >> bits) + 1, low + 1, tile + kTileSize);
    return std::pair{low, std::min(high, low + kMaxSpanPixels)};
  };
  const auto [left, right] = span(a.x_fixed, b.x_fixed, c.x_fixed);
  const auto [top, bottom] = span(a.y_fixed, b.y_fixed, c.y_fixed);
  return {left, top, right, bottom};
}

class RandomSpans : public testing::TestWithParam<uint32_t> {};  // samples

TEST_P(RandomSpans, AreExact) {
  constexpr uint32_t kSeed = 17;
  std::mt19937 random(kSeed);
  const auto uniform = [&](int32_t least, int32_t greatest) {
    return std::uniform_int_distribution<int32_t>(least, greatest)(random);
  };
  for (int i = 0; i < 30'000 && !testing::Test::HasFatalFailure(); ++i) {
    const auto bits = static_cast<uint32_t>(uniform(4, 8));
    // Extents up to the greatest that is small, and vertices on lines through samples, where edges are met exactly.
    const int32_t extent = std::min((1 << uniform(2, 13)) - 1, (40 << bits));
    const int32_t grid = 1 << uniform(0, static_cast<int32_t>(bits) - 1);
    const int32_t x = uniform(0, 16'000 << bits);
    const int32_t y = uniform(0, 16'000 << bits);
    const auto vertex = [&] {
      return FixedPosition{(x + uniform(0, extent)) / grid * grid, (y + uniform(0, extent)) / grid * grid};
    };
    SmallTriangle one{.vertices = {vertex(), vertex(), vertex()}, .subpixel_bits = bits, .samples = GetParam()};
    one.rect = rect_of(one.vertices, bits);
    if (is_small(one.vertices, one.rect)) {
      SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", number " << i);
      expect_exact(one);
    }
  }
}

// Edges whose quotients are as near to whole pixels as any: one of 8191 steps that misses a sample by a single one.
TEST_P(RandomSpans, AreExactWhereAnEdgeMissesASampleByTheLeast) {
  constexpr int32_t kGreatest = (1 << 13) - 1;
  for (int32_t missed = -2; missed <= 2; ++missed) {
    for (int32_t dx = 0; dx <= kGreatest; dx += 91) {
      const int32_t x = 200 * 256 + 128;
      const int32_t y = 100 * 256 + 128;
      SmallTriangle one{
          .vertices = {{{x, y - 4096}, {x + dx + missed, y - 4096 + kGreatest}, {x + kGreatest, y - 4096 + 17}}},
          .samples = GetParam()};
      one.vertices[1].x_fixed = std::clamp(one.vertices[1].x_fixed, x, x + kGreatest);
      one.rect = rect_of(one.vertices, one.subpixel_bits);
      expect_exact(one);
      std::swap(one.vertices[0], one.vertices[1]);
      expect_exact(one);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, RandomSpans, testing::Values(1, 4));

TEST(Spans, AreNoneWithoutArea) {
  expect_exact({.vertices = {{{256, 256}, {512, 512}, {1024, 1024}}}, .rect = {1, 1, 5, 5}});
}

TEST(Spans, AreForTrianglesOfUpToThirtyTwoPixels) {
  const std::array<FixedPosition, 3> triangle{{{0, 0}, {8191, 0}, {0, 8191}}};
  EXPECT_TRUE(is_small(triangle, {0, 0, 32, 32}));
  EXPECT_FALSE(is_small(triangle, {0, 0, 33, 32}));
  EXPECT_FALSE(is_small({{{0, 0}, {8192, 0}, {0, 8191}}}, {0, 0, 32, 32}));
}

}  // namespace
}  // namespace fillrule::renderer::internal
