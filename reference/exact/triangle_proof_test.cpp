// The oracle's proof: on random and adversarial triangles it says what the obvious implementation in rationals says,
// without exception.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "reference/exact/obvious_oracle.h"
#include "reference/exact/random_triangle.h"
#include "reference/exact/rational_triangle.h"
#include "reference/exact/value_bound.h"

namespace fillrule::exact {
namespace {

constexpr uint64_t kSeed = 20261122;
constexpr int kTrianglesPerFamily = 8500;  // times 12 families: more than 100,000

// A sample anywhere, or one that an edge passes by, where answers differ.
std::array<double, 2> pick_sample(const RandomTriangle& triangle, std::mt19937_64& random) {
  const auto centre = [](double position) { return std::clamp(std::floor(position), -2.0, 66.0) + 0.5; };
  const auto window = [&triangle](size_t vertex, size_t axis) {
    const auto& v = triangle.vertices[vertex];
    const VkViewport& viewport = triangle.viewport;
    const double size = axis == 0 ? viewport.width : viewport.height;
    const double offset = axis == 0 ? viewport.x : viewport.y;
    return offset + (double{v[axis]} / double{v[3]} + 1) * size / 2;
  };
  const double along = static_cast<double>(random() % 64) + 0.5;
  if (random() % 4 == 0) return {along, static_cast<double>(random() % 64) + 0.5};
  const size_t i = random() % 3;
  const size_t j = (i + 1) % 3;
  const std::array<double, 2> direction{window(j, 0) - window(i, 0), window(j, 1) - window(i, 1)};
  const bool x_major = std::abs(direction[0]) > std::abs(direction[1]);
  const size_t major = x_major ? 0 : 1;
  // Within the edge's extent, as far as that is within the viewport.
  const double low = std::max(std::min(window(i, major), window(j, major)), -1.0);
  const double high = std::min(std::max(window(i, major), window(j, major)), 65.0);
  const double position = low < high ? centre(low + (high - low) * along / 64) : along;
  const double slope = direction[major] == 0 ? 0 : direction[1 - major] / direction[major];  // coincident vertices
  const double other = window(i, 1 - major) + slope * (position - window(i, major));
  return x_major ? std::array{position, centre(other)} : std::array{centre(other), position};
}

void expect_within_one_ulp(double value, const obvious::Rational& exact, const std::string& what) {
  // Compared in rationals: exact lies between the neighbours of value.
  const double infinity = std::numeric_limits<double>::infinity();
  if (std::abs(value) == infinity) return;  // beyond double; nobody asks for it
  const obvious::Rational below(std::nextafter(value, -infinity));
  const obvious::Rational above(std::nextafter(value, infinity));
  EXPECT_TRUE(below <= exact && exact <= above) << what << ": " << value;
}

class OracleProof : public testing::TestWithParam<size_t> {};

TEST_P(OracleProof, AgreesWithTheObviousImplementation) {
  const auto family = static_cast<Family>(GetParam());
  std::mt19937_64 random(kSeed + GetParam());
  SCOPED_TRACE("seed " + std::to_string(kSeed) + ", family " + std::to_string(GetParam()));
  std::array<size_t, 3> answers{};
  int drawn = 0;
  while (drawn < kTrianglesPerFamily) {
    const RandomTriangle picked = random_triangle(family, random);
    const Triangle triangle(picked.vertices, picked.viewport);
    if (triangle.undefined()) continue;
    const obvious::Oracle oracle(picked.vertices, picked.viewport);
    const Latitude latitude = latitude_of(picked.viewport, drawn % 2 == 0 ? 8 : 4);
    const auto [x, y] = pick_sample(picked, random);
    const Coverage expected = oracle.classify(x, y, latitude);
    ASSERT_EQ(triangle.classify(x, y, latitude).coverage, expected)
        << "triangle " << drawn << " at " << x << ", " << y;
    // A block's answer holds for each of its samples.
    const BlockClassification block =
        triangle.classify_block({.x = x - 1, .y = y + 0.5, .half_width = 1, .half_height = 0.5}, latitude);
    if (block.coverage == Coverage::kMay) {
      ASSERT_EQ(triangle.classify(x, y, latitude, block.undecided).coverage, expected) << "triangle " << drawn;
    } else {
      ASSERT_EQ(block.coverage, expected) << "triangle " << drawn;
    }
    ASSERT_EQ(triangle.orientation() != 0, oracle.has_area()) << "triangle " << drawn;
    ++answers[static_cast<size_t>(expected)];
    ++drawn;
  }
  std::printf("family %zu: %zu must not, %zu may, %zu must\n", GetParam(), answers[0], answers[1], answers[2]);
  EXPECT_GT(answers[0], 0U);
  EXPECT_GT(answers[1], 0U);
}

TEST_P(OracleProof, ValuesAreExactToOneUlp) {
  const auto family = static_cast<Family>(GetParam());
  std::mt19937_64 random(kSeed + 1000 + GetParam());
  SCOPED_TRACE("seed " + std::to_string(kSeed) + ", family " + std::to_string(GetParam()));
  for (int drawn = 0; drawn < kTrianglesPerFamily / 10; ++drawn) {
    const RandomTriangle picked = random_triangle(family, random);
    const Triangle triangle(picked.vertices, picked.viewport);
    if (triangle.undefined() || triangle.orientation() == 0) continue;
    const obvious::Oracle oracle(picked.vertices, picked.viewport);
    const auto [x, y] = pick_sample(picked, random);
    const std::array<float, 3> q{1.25F, -3.5F, 1e6F};
    const std::string what = "triangle " + std::to_string(drawn);
    expect_within_one_ulp(exact_depth(triangle, x, y), oracle.depth(x, y), what + " depth");
    expect_within_one_ulp(exact_smooth(triangle, q, x, y), oracle.smooth(q, x, y), what + " smooth");
    expect_within_one_ulp(exact_noperspective(triangle, q, x, y), oracle.noperspective(q, x, y),
                          what + " noperspective");
  }
}

std::string family_name(const testing::TestParamInfo<size_t>& info) {
  constexpr std::array kNames{"Small",       "Big",    "OnGrid", "OnCentres", "Sliver", "Collinear",
                              "Perspective", "MixedW", "Near",   "Far",       "Huge",   "Denormal"};
  return kNames.at(info.param);
}

INSTANTIATE_TEST_SUITE_P(Families, OracleProof, testing::Range(size_t{0}, kFamilies), family_name);

}  // namespace
}  // namespace fillrule::exact
