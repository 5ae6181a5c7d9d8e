// The commands of a submission. Vulkan specification, "Command Buffers", "Render Pass", "Synchronization and Cache
// Control".
#pragma once

#include <span>

#include "reference/vulkan/job.h"
#include "reference/vulkan/sample_reader.h"

namespace fillrule::vulkan {

// Where the submission's data lies.
struct SubmissionBuffers {
  VkBuffer upload = VK_NULL_HANDLE;
  VkBuffer readback = VK_NULL_HANDLE;
};

// Records drawing all jobs and bringing their attachments to the readback buffer, for the host to read.
void record(VkCommandBuffer commands, const PipelineCache& pipelines, const SampleReader& sample_reader,
            const SubmissionBuffers& buffers, std::span<const CaseJob> jobs);

}  // namespace fillrule::vulkan
