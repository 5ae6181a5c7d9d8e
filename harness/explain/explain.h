// Gathers what is known about one sample: `fillrule explain`, and what a report embeds.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "cases/model/result.h"
#include "harness/explain/explanation.h"
#include "harness/judge/judge.h"

namespace fillrule::explain {

struct NamedParty {
  std::string name;
  judge::Party party;
};

struct SampleId {
  uint32_t x = 0;  // pixel
  uint32_t y = 0;
  std::optional<uint32_t> sample;  // none: the one with the gravest verdict, the first among equals
};

// `reference` may be null. A sample outside of the target is an error.
Result<Explanation> explain(const Case& test_case, const NamedParty& candidate, const NamedParty* reference,
                            const judge::Profile& profile, const SampleId& sample);

// Explains many samples of one case: what they have in common is worked out once. All that it is given has to stay
// where it is. `reference` may be null; the verdict is the judge's on these parties, with maps.
class CaseExplainer {
 public:
  CaseExplainer(const Case& test_case, const NamedParty& candidate, const NamedParty* reference,
                const judge::Profile& profile, const judge::CaseVerdict& verdict);
  CaseExplainer(const CaseExplainer&) = delete;
  CaseExplainer& operator=(const CaseExplainer&) = delete;
  CaseExplainer(CaseExplainer&&) = delete;
  CaseExplainer& operator=(CaseExplainer&&) = delete;
  ~CaseExplainer();

  // The sample is in the target.
  Explanation at(const SampleId& id);

 private:
  class State;
  std::unique_ptr<State> state_;
};

// The same as text, the reason last.
std::string to_text(const Explanation& explanation);

}  // namespace fillrule::explain
