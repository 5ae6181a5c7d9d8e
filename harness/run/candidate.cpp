#include "harness/run/candidate.h"

#include <fmt/format.h>

#include "harness/programs/varyings.h"

namespace fillrule::run {

Result<Candidate> make_candidate(const std::string& name, const CandidateOptions& options) {
  if (name != "renderer") {
    return failure(fmt::format("there is no candidate '{}'", name), "the candidates are: renderer");
  }
  const renderer::Options renderer_options{.subpixel_bits = options.subpixel_bits, .threads = options.threads};
  const auto draw = [renderer_options](const Case& test_case, uint32_t threads) {
    renderer::Options chosen = renderer_options;
    if (threads != 0) chosen.threads = threads;
    return programs::draw_case(test_case, chosen);
  };
  return Candidate{.name = name, .subpixel_bits = options.subpixel_bits, .draw = draw};
}

}  // namespace fillrule::run
