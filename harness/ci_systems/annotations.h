// What CI systems show beside the sources: an annotation at the case file of each case that failed.
#pragma once

#include <cstdint>
#include <string>

#include "harness/run/run.h"

namespace fillrule::ci_systems {

// Where a case is written down: at its sweep if it is one of several cases of its file, else at its first draw.
struct Place {
  std::string path;  // from the project's folder, if it is below that
  uint32_t line = 1;
};
Place place_of(const run::CaseResult& result, const std::string& project_folder);

// GitHub's workflow commands, for stdout. GitHub shows ten errors of a step and no more: the first nine cases and a
// line that counts them all. Empty if no case failed.
std::string github_commands(const run::RunResult& result, const std::string& project_folder);

// Markdown for the page of a workflow's run (GITHUB_STEP_SUMMARY): counts, and a table of the first cases that
// failed. `report` is where the report is, in words. Names cannot be taken for markup.
std::string github_summary(const run::RunResult& result, const std::string& report);

// GitLab's Code Quality report, a JSON array with one entry for each case that failed.
std::string gitlab_code_quality(const run::RunResult& result, const std::string& project_folder);

}  // namespace fillrule::ci_systems
