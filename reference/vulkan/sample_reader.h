// Reads multisampled attachments back, every sample of them: no copy can, so a compute shader fetches the samples and
// stores them in the order of Planes. Vulkan specification, "Compute Pipelines", "Descriptor Sets".
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "reference/vulkan/job.h"

namespace fillrule::vulkan {

class SampleReader {
 public:
  // `device` must outlive the reader.
  explicit SampleReader(const Device& device) : device_(&device) {}

  // Makes ready to store the multisampled attachments of the jobs in `readback`, each where attachment_offset() says.
  // No commands of an earlier call may still run.
  Result<void> bind(std::span<const CaseJob> jobs, VkBuffer readback);
  // The attachments must be in VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL.
  void record(VkCommandBuffer commands) const;

 private:
  // What a word of the buffer comes from.
  enum class Kind : uint8_t { kScalar, kInteger, kVector };
  static constexpr size_t kKindCount = 3;

  // One attachment.
  struct Read {
    Kind kind = Kind::kScalar;
    VkDescriptorSet set = VK_NULL_HANDLE;
    TargetKey target;
  };

  // The pipelines, on first need.
  Result<void> create();
  Result<void> create_layout();
  Result<void> create_pipeline(Kind kind);
  // Room for so many attachments in descriptors_.
  Result<void> reserve(uint32_t attachments);
  Result<void> bind_attachment(const Pass& pass, uint32_t attachment, VkBuffer readback);

  const Device* device_;
  Sampler sampler_;
  DescriptorSetLayout set_layout_;
  PipelineLayout layout_;
  std::array<Pipeline, kKindCount> pipelines_;
  DescriptorPool descriptors_;
  uint32_t capacity_ = 0;  // attachments
  std::vector<Read> reads_;
};

}  // namespace fillrule::vulkan
