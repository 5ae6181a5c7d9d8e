#include "harness/run/reference.h"

#include "harness/programs/glsl.h"
#include "harness/run/under_way.h"

namespace fillrule::run {

Result<vulkan::Reference> open_device(const std::string& driver, const std::vector<std::string>& driver_files,
                                      bool validation) {
  return vulkan::Reference::create({.driver = driver,
                                    .driver_files = driver_files,
                                    .program = {.vertex_glsl = programs::varyings_vertex_glsl(),
                                                .fragment_glsl = programs::varyings_fragment_glsl()},
                                    .validation = validation});
}

std::vector<std::optional<Planes>> draw_batch(vulkan::Reference& device, std::span<const Case> cases,
                                              std::span<const size_t> batch, std::span<CaseResult> results) {
  std::vector<std::optional<Planes>> drawn(batch.size());
  std::vector<const Case*> accepted;
  std::vector<size_t> places;
  for (size_t i = 0; i < batch.size(); ++i) {
    CaseResult& result = results[batch[i]];
    if (const Result<void> can = vulkan::check_case(device.device(), cases[batch[i]]); !can) {
      result.status = Status::kSkipped;
      result.message = to_string(can.error()) + "; held against the oracle alone";
      continue;
    }
    accepted.push_back(&cases[batch[i]]);
    places.push_back(i);
  }
  const UnderWay under_way("drawn by", device.device().driver, accepted);
  std::vector<Result<Planes>> planes = device.draw(accepted);
  for (size_t i = 0; i < accepted.size(); ++i) {
    if (planes[i]) {
      drawn[places[i]] = std::move(*planes[i]);
      continue;
    }
    CaseResult& result = results[batch[places[i]]];
    result.status = Status::kFailed;
    result.message = "the reference broke down: " + to_string(planes[i].error());
  }
  return drawn;
}

}  // namespace fillrule::run
