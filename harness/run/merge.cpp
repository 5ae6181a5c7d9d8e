#include "harness/run/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace fillrule::run {
namespace {

std::string parties_of(const RunResult& result) {
  const Reference& reference = result.reference;
  return fmt::format("{} ({} subpixel bits) against {} ({}, {}, {} subpixel bits)", result.candidate,
                     result.candidate_subpixel_bits, reference.driver, reference.name, reference.version,
                     reference.subpixel_bits);
}

Result<void> check_parties(std::span<const NamedResult> parts) {
  const std::string first = parties_of(parts.front().result);
  for (const NamedResult& part : parts) {
    if (const std::string other = parties_of(part.result); other != first) {
      return tl::unexpected(Error{.file = part.file,
                                  .what = fmt::format("is of other parties: {}", other),
                                  .hint = fmt::format("{} is of {}", parts.front().file, first)});
    }
  }
  return {};
}

// Under another profile other verdicts are faults.
Result<void> check_profiles(std::span<const NamedResult> parts) {
  const auto described = [](const std::string& profile) {
    return profile.empty() ? std::string("no profile") : "profile " + profile;
  };
  const NamedResult& first = parts.front();
  for (const NamedResult& part : parts) {
    if (part.result.profile != first.result.profile) {
      return tl::unexpected(
          Error{.file = part.file,
                .what = fmt::format("is judged by {}", described(part.result.profile)),
                .hint = fmt::format("{} is judged by {}", first.file, described(first.result.profile))});
    }
  }
  return {};
}

Result<void> check_names(std::span<const NamedResult> parts) {
  std::map<std::string, std::string> files;
  for (const NamedResult& part : parts) {
    for (const CaseResult& one : part.result.cases) {
      const auto [place, fresh] = files.try_emplace(one.name, part.file);
      if (fresh) continue;
      return tl::unexpected(Error{.file = part.file,
                                  .what = fmt::format("holds the case \"{}\" a second time", one.name),
                                  .hint = fmt::format("the first is in {}", place->second)});
    }
  }
  return {};
}

// The parts in the order of their shards.
Result<std::vector<const NamedResult*>> all_shards(std::span<const NamedResult> parts) {
  const Shard& first = parts.front().result.shard;
  std::vector<const NamedResult*> shards(first.total, nullptr);
  for (const NamedResult& part : parts) {
    const Shard& shard = part.result.shard;
    const std::string name = fmt::format("shard {} of {}", shard.index + 1, shard.total);
    if (shard.total != first.total || shard.suite_cases != first.suite_cases || shard.index >= shard.total) {
      return tl::unexpected(Error{.file = part.file,
                                  .what = fmt::format("is {}, of {} cases", name, shard.suite_cases),
                                  .hint = fmt::format("{} is one of {} shards, of {} cases", parts.front().file,
                                                      first.total, first.suite_cases)});
    }
    const NamedResult*& place = shards[shard.index];
    if (place != nullptr) {
      return tl::unexpected(Error{.file = part.file,
                                  .what = fmt::format("is {}, which is there already", name),
                                  .hint = fmt::format("the other is {}", place->file)});
    }
    place = &part;
  }
  for (size_t i = 0; i < shards.size(); ++i) {
    if (shards[i] == nullptr) return failure(fmt::format("shard {} of {} is missing", i + 1, shards.size()));
  }
  return shards;
}

// Case number i is in the shard i modulo their number.
Result<std::vector<CaseResult>> interleaved(const std::vector<const NamedResult*>& shards) {
  const uint64_t count = shards.front()->result.shard.suite_cases;
  std::vector<CaseResult> cases;
  cases.reserve(count);
  for (uint64_t i = 0; i < count; ++i) {
    const NamedResult& part = *shards[i % shards.size()];
    const uint64_t number = i / shards.size();
    if (number >= part.result.cases.size()) {
      return tl::unexpected(Error{.file = part.file, .what = "holds fewer cases than its shard has"});
    }
    cases.push_back(part.result.cases[number]);
  }
  return cases;
}

Result<std::vector<CaseResult>> cases_in_order(std::span<const NamedResult> parts) {
  const bool split = std::ranges::any_of(parts, [](const NamedResult& part) { return part.result.shard.total > 1; });
  if (split) return all_shards(parts).and_then(interleaved);
  std::vector<CaseResult> cases;
  for (const NamedResult& part : parts) {
    cases.insert(cases.end(), part.result.cases.begin(), part.result.cases.end());
  }
  std::ranges::sort(cases, {}, &CaseResult::name);
  return cases;
}

}  // namespace

std::vector<Case> cases_of(const Shard& shard, std::vector<Case> suite) {
  if (shard.total <= 1) return suite;
  std::vector<Case> cases;
  for (size_t i = shard.index; i < suite.size(); i += shard.total) cases.push_back(std::move(suite[i]));
  return cases;
}

Result<RunResult> merge_results(std::span<const NamedResult> parts) {
  if (parts.empty()) return failure("there are no results to merge");
  if (const auto same = check_parties(parts); !same) return tl::unexpected(same.error());
  if (const auto same = check_profiles(parts); !same) return tl::unexpected(same.error());
  if (const auto distinct = check_names(parts); !distinct) return tl::unexpected(distinct.error());
  Result<std::vector<CaseResult>> cases = cases_in_order(parts);
  if (!cases) return tl::unexpected(cases.error());
  const RunResult& first = parts.front().result;
  RunResult merged{.candidate = first.candidate,
                   .candidate_subpixel_bits = first.candidate_subpixel_bits,
                   .reference = first.reference,
                   .profile = first.profile,
                   .cases = std::move(*cases)};
  double wall_seconds = 0;
  for (const NamedResult& part : parts) {
    merged.timing.run += part.result.timing.run;
    wall_seconds = std::max(wall_seconds, part.result.summary.wall_seconds);
  }
  merged.timing.run.wall_seconds = wall_seconds;
  merged.summary = summarise(merged.cases, wall_seconds);
  return merged;
}

}  // namespace fillrule::run
