// Draws cases with the candidate and the reference, and has them judged, on as many threads as there are jobs: one of
// them, or two (lanes.h), draw with the reference, too, in batches.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "cases/model/result.h"
#include "harness/judge/judge.h"
#include "harness/run/candidate.h"
#include "harness/run/run.h"

namespace fillrule::run {

// The name of a reference that leaves the candidate alone with the oracle.
inline constexpr const char* kNoReference = "none";

struct RunOptions {
  std::string candidate = "renderer";  // as make_candidate() names them
  CandidateOptions candidate_options;
  std::string reference = "lavapipe";  // a driver, or kNoReference
  std::vector<std::string> driver_files;
  judge::Profile profile;
  bool checks = true;  // run the metamorphic checks
  uint32_t jobs = 1;
  bool measure_alone = false;  // fill Timing's warm figures
  bool validation = false;     // Vulkan's validation layers
};

// Both parties' pictures of one case, and the verdict with its maps.
struct Drawing {
  Planes candidate;
  std::optional<Planes> reference;
  judge::CaseVerdict verdict;
  // Of a scene, if the candidate can draw it in colour. Errors as those of scene::check_scene().
  std::optional<Result<judge::CheckResult>> scene_colors;
};

// Told each time that a case is done, by whichever thread has done it.
using Progress = std::function<void()>;

class SuiteRunner {
 public:
  static Result<SuiteRunner> create(const RunOptions& options);
  // With a candidate of one's own, whatever the options name.
  static Result<SuiteRunner> create(const RunOptions& options, Candidate candidate);
  SuiteRunner(SuiteRunner&& other) noexcept;
  SuiteRunner& operator=(SuiteRunner&& other) noexcept;
  ~SuiteRunner();

  // Results are in the order of the cases, whatever the number of jobs.
  RunResult run(std::span<const Case> cases, const Progress& progress = {});

  Result<Drawing> draw(const Case& test_case);

  [[nodiscard]] std::vector<std::string> validation_messages() const;

 private:
  struct State;
  explicit SuiteRunner(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace fillrule::run
