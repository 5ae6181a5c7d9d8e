// The outcome of running cases: what the terminal, the JSON file and the exit code are made from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases/model/result.h"
#include "harness/judge/metamorphic.h"
#include "harness/judge/verdict.h"
#include "harness/run/timing.h"

namespace fillrule::run {

enum class Status : uint8_t {
  kPassed,
  kFailed,  // the candidate is at fault, or fails a check, or could not draw; or the reference broke down
  // A party cannot draw or judge the case, or its files are no good; `message` tells why. Where it is the reference,
  // the candidate was held against the oracle alone, and found without fault.
  kSkipped,
};

struct CaseResult {
  std::string name;
  std::string file;
  Status status = Status::kPassed;
  std::string message;  // why a case was skipped, or failed without a verdict
  // What is wrong with its files, found out as it was drawn. Neither party is to blame: the case is skipped, but
  // failed if the candidate is at fault all the same.
  std::optional<Error> bad_input;
  // One plain sentence about the worst sample; empty where there is none, or nobody asked.
  std::string reason;
  // Commands that show the case again, and explain its worst sample, with the same parties; empty where there are
  // none.
  std::string show_command;
  std::string explain_command;
  double seconds = 0;  // the candidate's drawing and the judging; the reference draws in batches
  judge::CaseVerdict verdict;
  std::vector<judge::CheckResult> checks;  // empty where they were not asked for
};

struct Summary {
  uint64_t cases = 0;
  uint64_t passed = 0;
  uint64_t failed = 0;
  uint64_t skipped = 0;
  // Samples, summed over all planes of all cases.
  uint64_t identical = 0;
  uint64_t permitted = 0;
  uint64_t imprecise = 0;
  uint64_t candidate_faults = 0;
  uint64_t reference_faults = 0;
  uint64_t failed_checks = 0;  // metamorphic ones
  double wall_seconds = 0;
};

struct Reference {
  std::string driver;  // "none" where the candidate was held against the oracle alone
  std::string name;
  std::string version;
  uint32_t subpixel_bits = 0;
};

// The part of the suite that was run: of the cases in order the ones whose number is `index` modulo `total`, which is
// how GoogleTest splits tests.
struct Shard {
  uint32_t index = 0;
  uint32_t total = 1;
  uint64_t suite_cases = 0;  // in all shards together
};

struct RunResult {
  std::string candidate;
  uint32_t candidate_subpixel_bits = 0;
  Reference reference;
  std::string profile;  // as to_string() of judge.h has it
  Shard shard;
  std::vector<CaseResult> cases;
  Summary summary;
  Timing timing;
};

Summary summarise(const std::vector<CaseResult>& cases, double wall_seconds);

}  // namespace fillrule::run
