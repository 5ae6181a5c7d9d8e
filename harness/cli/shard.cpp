#include "harness/cli/shard.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace fillrule::cli {
namespace {

std::optional<uint32_t> whole_number(std::string_view text) {
  uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string_view() : value;
}

Result<run::Shard> shard_of_environment() {
  const std::string_view total = variable("GTEST_TOTAL_SHARDS");
  const std::string_view index = variable("GTEST_SHARD_INDEX");
  if (total.empty() && index.empty()) return run::Shard{};
  const auto number = whole_number(index);
  const auto count = whole_number(total);
  if (!number || !count || *number >= *count) {
    return failure(fmt::format(R"(GTEST_SHARD_INDEX is "{}" and GTEST_TOTAL_SHARDS "{}")", index, total),
                   "both are whole numbers, the index from 0 to one less than the total; or unset both");
  }
  return run::Shard{.index = *number, .total = *count};
}

}  // namespace

Result<run::Shard> choose_shard(const std::string& text) {
  if (text.empty()) return shard_of_environment();
  const std::string_view whole = text;
  const size_t slash = std::min(whole.find('/'), whole.size());
  const auto number = whole_number(whole.substr(0, slash));
  const auto count = whole_number(whole.substr(std::min(slash + 1, whole.size())));
  if (!number || !count || *number == 0 || *number > *count) {
    return failure(fmt::format("--shard takes I/N, not \"{}\"", text), "the shards of 4 are 1/4 to 4/4");
  }
  return run::Shard{.index = *number - 1, .total = *count};
}

}  // namespace fillrule::cli
