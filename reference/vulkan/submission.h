// One submission at a time: cases are put in, drawn together, and their planes taken out.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "reference/vulkan/job.h"
#include "reference/vulkan/sample_reader.h"

namespace fillrule::vulkan {

class Submitter {
 public:
  // `device` and `pipelines` must outlive the submitter.
  static Result<Submitter> create(const Device& device, PipelineCache& pipelines, uint64_t bytes_in_flight);

  // What one submission should use at most.
  [[nodiscard]] uint64_t bytes_in_flight() const { return bytes_in_flight_; }
  // What a case needs, or why it cannot be drawn here.
  [[nodiscard]] Result<CaseNeeds> needs(const Case& drawn) const;
  // Draws the jobs and puts planes or error at each one's result_index.
  void draw(std::vector<CaseJob> jobs, std::span<Result<Planes>> results);

 private:
  Submitter(const Device& device, PipelineCache& pipelines, uint64_t bytes_in_flight)
      : device_(&device),
        pipelines_(&pipelines),
        sample_reader_(device),
        bytes_in_flight_(bytes_in_flight),
        targets_(device, bytes_in_flight) {}

  // Finds attachments and pipelines for every pass of the job.
  Result<void> prepare(CaseJob& job);
  // Gives every job its part of the buffers, which are made to fit.
  Result<void> place(std::span<CaseJob> jobs);
  Result<void> submit(std::span<const CaseJob> jobs);
  Result<void> fit(HostBuffer& buffer, uint64_t bytes, VkBufferUsageFlags usage) const;
  void release(CaseJob& job);

  const Device* device_;
  PipelineCache* pipelines_;
  SampleReader sample_reader_;
  uint64_t bytes_in_flight_;
  TargetPool targets_;
  HostBuffer upload_;
  HostBuffer readback_;
  CommandPool command_pool_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  Fence fence_;
};

}  // namespace fillrule::vulkan
