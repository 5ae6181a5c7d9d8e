// One case in report.html: planes of both parties, verdicts, the oracle's answers, what is known of the gravest
// samples, and outlines to draw.
#pragma once

#include <string>

#include "cases/model/case.h"
#include "harness/explain/explain.h"
#include "harness/report/diagnosis.h"
#include "harness/run/run.h"
#include "harness/run/suite_runner.h"

namespace fillrule::report {

// So many samples are listed, the gravest ones, and so many of them explained, which takes rational arithmetic; of
// the others the page tells values, verdict and class.
inline constexpr size_t kListedSamples = 64;
inline constexpr size_t kExplainedSamples = 32;
// So many outlines are drawn.
inline constexpr size_t kMostOutlines = 1024;

struct Parties {
  std::string candidate;
  uint32_t candidate_subpixel_bits = 8;
  std::string reference;
  uint32_t reference_subpixel_bits = 8;
  judge::Profile profile;
};

struct HtmlCase {
  Diagnosis diagnosis;
  // {details, planes}, each compressed and in base64: JSON text, and bytes. The bytes are, for each of the details'
  // channels, the reference's words, if there is one, and the candidate's XORed with them; for each of the details'
  // planes a verdict a sample; then for each sample its class (bit 4: of the reference alone), the oracle's answer
  // and the owner that the oracle expects. Words are split into their bytes, the lowest ones first.
  std::string json;
};

// The verdict of the drawing has its maps.
HtmlCase html_case(const Case& test_case, const run::CaseResult& result, const run::Drawing& drawing,
                   const Parties& parties);

}  // namespace fillrule::report
