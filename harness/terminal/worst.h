// The worst samples of a case, as text.
#pragma once

#include <string>
#include <string_view>

#include "harness/judge/verdict.h"
#include "harness/terminal/style.h"

namespace fillrule::terminal {

inline constexpr size_t kShownSamples = 10;

// "candidate none, reference 3, exact 3 +- 1.5e-07": what a record of the plane holds.
std::string values_text(const judge::PlaneVerdict& plane, const judge::SampleRecord& sample);

// "uv.y" of a varying of several components, else the plane's name.
std::string component_name(const judge::PlaneVerdict& plane, const judge::SampleRecord& sample);

// The worst samples, at most kShownSamples, each in the plane where it is worst, with both values, the exact
// one, the tolerance and the error of whoever is at fault in units of the last place; as a list where a table would
// be too wide. Empty if the judge kept none.
std::string worst_text(const judge::CaseVerdict& verdict, const Style& style);

// The colour that a verdict is shown in.
Role role_of(judge::Verdict verdict);

}  // namespace fillrule::terminal
