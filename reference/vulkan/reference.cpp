#include "reference/vulkan/reference.h"

#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "reference/vulkan/resources.h"
#include "reference/vulkan/submission.h"

namespace fillrule::vulkan {

void prefer_fast_compilation() {
  setenv("GALLIVM_PERF", "nopt", 0);
}

// Members refer to those above them, which therefore never move.
struct Reference::State {
  State(Instance the_instance, Device the_device)
      : instance(std::move(the_instance)), device(std::move(the_device)) {}

  Instance instance;
  Device device;
  std::optional<ResourceBinder> resources;  // none where the program reads nothing beside its vertices
  std::optional<PipelineCache> pipelines;
  std::optional<Submitter> submitter;
};

Result<Reference> Reference::create(const Options& options) {
  Result<Instance> instance = Instance::create(options.driver_files, options.validation);
  if (!instance) return tl::unexpected(instance.error());
  const Result<PhysicalDevice> physical = instance->choose_device(options.driver);
  if (!physical) return tl::unexpected(physical.error());
  Result<Device> device = Device::create(*physical);
  if (!device) return tl::unexpected(device.error());

  auto state = std::make_unique<State>(std::move(*instance), std::move(*device));
  const bool use_primitive_id =
      options.primitive_number == PrimitiveNumber::kBest && state->device.info().has_primitive_id;
  VkDescriptorSetLayout resource_layout = VK_NULL_HANDLE;
  if (options.program.uniform_bytes > 0) {
    Result<ResourceBinder> resources = ResourceBinder::create(state->device, options.program.uniform_bytes);
    if (!resources) return tl::unexpected(resources.error());
    state->resources.emplace(std::move(*resources));
    resource_layout = state->resources->layout();
  }
  Result<PipelineCache> pipelines =
      PipelineCache::create(state->device, options.program, use_primitive_id, resource_layout);
  if (!pipelines) return tl::unexpected(pipelines.error());
  state->pipelines.emplace(std::move(*pipelines));
  Result<Submitter> submitter = Submitter::create(state->device, *state->pipelines, options.bytes_in_flight);
  if (!submitter) return tl::unexpected(submitter.error());
  state->submitter.emplace(std::move(*submitter));
  return Reference(std::move(state));
}

Reference::Reference(std::unique_ptr<State> state) : state_(std::move(state)) {}
Reference::Reference(Reference&&) noexcept = default;
Reference& Reference::operator=(Reference&&) noexcept = default;
Reference::~Reference() = default;

const DeviceInfo& Reference::device() const {
  return state_->device.info();
}

std::vector<Result<Planes>> Reference::draw(std::span<const Case* const> cases) {
  Submitter& submitter = *state_->submitter;
  std::vector<Result<Planes>> results(cases.size());
  std::vector<CaseJob> jobs;
  uint64_t bytes = 0;
  for (size_t i = 0; i < cases.size(); ++i) {
    Result<CaseNeeds> needs = submitter.needs(*cases[i]);
    if (!needs) {
      results[i] = tl::unexpected(needs.error());
      continue;
    }
    if (bytes + needs->device_bytes > submitter.bytes_in_flight() && !jobs.empty()) {
      submitter.draw(std::exchange(jobs, {}), results);
      bytes = 0;
    }
    bytes += needs->device_bytes;
    jobs.push_back({.drawn = cases[i], .result_index = i, .needs = std::move(*needs)});
  }
  submitter.draw(std::move(jobs), results);
  return results;
}

Result<Planes> Reference::draw(const Case& drawn, std::span<const DrawResources> resources) {
  if (!state_->resources) return failure("the program reads nothing beside its vertices");
  if (resources.size() != drawn.draws.size()) {
    return failure(std::to_string(resources.size()) + " resources for " + std::to_string(drawn.draws.size()) +
                   " draws");
  }
  Submitter& submitter = *state_->submitter;
  Result<CaseNeeds> needs = submitter.needs(drawn);
  if (!needs) return tl::unexpected(needs.error());
  Result<std::vector<VkDescriptorSet>> sets = state_->resources->bind(resources);
  if (!sets) return tl::unexpected(sets.error());
  CaseJob job{.drawn = &drawn, .needs = std::move(*needs), .resource_sets = std::move(*sets)};
  for (const DrawResources& one : resources) job.variants.push_back(one.variant);
  std::vector<CaseJob> jobs;
  jobs.push_back(std::move(job));
  std::vector<Result<Planes>> results(1);
  submitter.draw(std::move(jobs), results);
  return std::move(results.front());
}

std::vector<std::string> Reference::validation_messages() const {
  return state_->instance.log().messages();
}

}  // namespace fillrule::vulkan
