#include "harness/cli/inspect.h"

#include "harness/terminal/map.h"
#include "harness/terminal/preview.h"
#include "harness/terminal/worst.h"

namespace fillrule::cli {

Result<explain::Explanation> explain_sample(const run::RunResult& parties, const judge::Profile& profile,
                                            const Case& test_case, const run::Drawing& drawing,
                                            const explain::SampleId& sample) {
  const explain::NamedParty candidate{
      .name = parties.candidate,
      .party = {.planes = &drawing.candidate, .subpixel_bits = parties.candidate_subpixel_bits}};
  explain::NamedParty reference{.name = parties.reference.driver,
                                .party = {.subpixel_bits = parties.reference.subpixel_bits}};
  if (drawing.reference) reference.party.planes = &*drawing.reference;
  return explain::explain(test_case, candidate, drawing.reference ? &reference : nullptr, profile, sample);
}

std::string reason_of(const run::RunResult& parties, const judge::Profile& profile, const Case& test_case,
                      const run::Drawing& drawing) {
  const std::optional<judge::SampleRecord> worst = drawing.verdict.worst();
  if (!worst) return {};
  const auto explanation =
      explain_sample(parties, profile, test_case, drawing, {.x = worst->x, .y = worst->y, .sample = worst->sample});
  return explanation ? explanation->reason : std::string();
}

std::string inspection_text(const Case& test_case, const run::Drawing& drawing, const terminal::Style& style) {
  return terminal::worst_text(drawing.verdict, style) + terminal::map_text(test_case, drawing, style) +
         terminal::preview_text(test_case, drawing, style);
}

}  // namespace fillrule::cli
