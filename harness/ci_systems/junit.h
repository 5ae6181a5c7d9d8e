// The results as a JUnit file, in the dialect that Jenkins, GitLab and GitHub's actions read; junit.xsd is its
// schema.
#pragma once

#include <functional>
#include <string>

#include "harness/run/run.h"

namespace fillrule::ci_systems {

// The pictures of a case, as paths from the folder where GitLab has the project; none where there are none.
using Attachments = std::function<std::vector<std::string>(const run::CaseResult&)>;

// A test suite for each topic, and a test case for each case, named by the case's whole name, so that no two share
// one. A failure holds the counts in full and the text that the terminal shows, as GitLab shows the text and not the
// message; and each picture is named in system-out as [[ATTACHMENT|path]], where GitLab looks for it.
std::string to_junit(const run::RunResult& result, const Attachments& attachments);

}  // namespace fillrule::ci_systems
