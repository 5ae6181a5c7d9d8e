// The suite passes its own check.
#include <gtest/gtest.h>

#include "cases/format/suite.h"
#include "harness/check/check.h"
#include "harness/scene/build.h"

namespace fillrule::check {
namespace {

TEST(Suite, PassesTheCheck) {
  const format::Suite suite = scene::load_suite(FILLRULE_SOURCE_DIR "/cases", {});
  ASSERT_TRUE(suite.errors.empty()) << to_string(suite.errors.front());
  for (const Error& finding : check_files(suite.cases, {})) ADD_FAILURE() << to_string(finding);
}

}  // namespace
}  // namespace fillrule::check
