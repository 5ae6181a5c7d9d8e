// Which part of the suite to run: --shard 2/4, or GoogleTest's variables, so that whatever splits its tests splits
// the suite too.
#pragma once

#include <string>

#include "cases/model/result.h"
#include "harness/run/run.h"

namespace fillrule::cli {

// `text` counts from 1, "2/4"; where it is empty, GTEST_TOTAL_SHARDS and GTEST_SHARD_INDEX, which counts from 0,
// decide, and the whole suite is run if they are not set.
Result<run::Shard> choose_shard(const std::string& text);

}  // namespace fillrule::cli
