// For tests: results with every outcome, and names that nobody would choose.
#pragma once

#include <string>

#include "harness/run/run.h"

namespace fillrule::ci_systems {

inline const std::string kHostileName =
    "clipping/<b>\"quoted\" & 'single'\x1b[31m\n::error::owned\xff\xef\xbf\xbf]]>";

inline run::CaseResult failure(const std::string& name) {
  judge::PlaneVerdict owner{.name = "owner", .kind = judge::PlaneKind::kOwner};
  owner.counts = {4094, 0, 0, 1, 1, 0};
  run::CaseResult result{.name = name,
                         .file = "cases/clipping/near.toml",
                         .status = run::Status::kFailed,
                         .reason = "The candidate covers a sample 2 subpixels outside of edge v0-v1.",
                         .explain_command = "fillrule explain 'x' --pixel 1,2",
                         .seconds = 0.25};
  result.verdict.planes = {{.name = "coverage", .counts = {4096, 0, 0, 0, 0, 0}}, owner};
  return result;
}

inline run::RunResult every_outcome() {
  run::RunResult run{.candidate = "renderer", .candidate_subpixel_bits = 8};
  run.reference = {.driver = "lavapipe", .name = "llvmpipe", .version = "Mesa 1", .subpixel_bits = 8};
  run.cases = {failure("clipping/near[angle=30]"), failure(kHostileName)};
  run.cases.push_back({.name = "coverage/tie", .file = "cases/coverage/tie.toml"});
  run.cases.push_back({.name = "coverage/wide",
                       .file = "cases/coverage/wide.toml",
                       .status = run::Status::kSkipped,
                       .message = "the device lacks lines of 7.5 pixels"});
  run.cases.push_back({.name = "bare",
                       .file = "bare.toml",
                       .status = run::Status::kFailed,
                       .message = "the candidate cannot draw it: out of memory"});
  run::CaseResult check{
      .name = "coverage/check", .file = "cases/coverage/check.toml", .status = run::Status::kFailed};
  check.verdict.planes = {{.name = "coverage", .counts = {4096, 0, 0, 0, 0, 0}}};
  check.checks = {{.name = "scissor_crop",
                   .outcome = judge::CheckResult::Outcome::kFailed,
                   .message = "depth differs at (1, 2)"}};
  run.cases.push_back(check);
  run.summary = run::summarise(run.cases, 1.5);
  return run;
}

}  // namespace fillrule::ci_systems
