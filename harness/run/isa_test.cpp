// The renderer's bytes do not depend on how it gets to them: instruction set, threads, fill.
#include <gtest/gtest.h>

#include <cstring>

#include "cases/format/suite.h"
#include "harness/programs/varyings.h"

namespace fillrule::run {
namespace {

template <typename T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same_bytes(const Planes& a, const Planes& b) {
  if (a.varyings.size() != b.varyings.size()) return false;
  for (size_t i = 0; i < a.varyings.size(); ++i) {
    if (!same_bytes(a.varyings[i], b.varyings[i])) return false;
  }
  return same_bytes(a.hits, b.hits) && same_bytes(a.owner, b.owner) && same_bytes(a.front_facing, b.front_facing) &&
         same_bytes(a.depth, b.depth);
}

class SameBytes : public testing::TestWithParam<renderer::Isa> {};

TEST_P(SameBytes, WithAnyThreadsAndEitherFillOnTheWholeSuite) {
  if (!renderer::is_supported(GetParam())) GTEST_SKIP() << "this processor does not have it";
  const format::Suite suite = format::load_suite(FILLRULE_SOURCE_DIR "/cases", {});
  ASSERT_GT(suite.cases.size(), 4000U);
  for (const Case& one : suite.cases) {
    const Result<Planes> expected = programs::draw_case(one, {.isa = renderer::Isa::kScalar});
    ASSERT_TRUE(expected) << one.name << ": " << to_string(expected.error());
    for (const renderer::Options& options :
         {renderer::Options{.threads = 1}, {.threads = 3}, {.threads = 2, .fill = renderer::Fill::kScanline}}) {
      renderer::Options chosen = options;
      chosen.isa = GetParam();
      const Result<Planes> planes = programs::draw_case(one, chosen);
      ASSERT_TRUE(planes);
      EXPECT_TRUE(same_bytes(*planes, *expected)) << one.name << ", " << options.threads << " threads";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Isas, SameBytes, testing::ValuesIn(renderer::kAllIsas), [](const auto& info) {
  return std::string("isa_") + std::to_string(static_cast<int>(info.param));
});

}  // namespace
}  // namespace fillrule::run
