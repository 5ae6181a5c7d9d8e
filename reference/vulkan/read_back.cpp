#include <cmath>
#include <cstring>

#include "reference/vulkan/job.h"

namespace fillrule::vulkan {
namespace {

constexpr uint32_t kFrontFacingBit = 0x80000000U;

template <typename T>
std::vector<T> copy_attachment(const Pass& pass, uint32_t attachment, std::span<const std::byte> buffer) {
  const TargetKey& key = pass.target.key();
  std::vector<T> values(size_t{key.width} * key.height * key.samples);
  const uint64_t offset = pass.readback_offset + attachment_offset(key, attachment);
  const auto bytes = buffer.subspan(offset, values.size() * sizeof(T));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

// One lane of a slot, for every sample.
std::vector<float> copy_lane(const Pass& pass, const ComponentPlace& place, std::span<const std::byte> buffer) {
  const TargetKey& key = pass.target.key();
  std::vector<float> values(size_t{key.width} * key.height * key.samples);
  const uint32_t attachment = kFirstSlotAttachment + place.slot - pass.slots.first;
  const uint64_t offset = pass.readback_offset + attachment_offset(key, attachment) + place.lane * sizeof(float);
  const auto bytes = buffer.subspan(offset);
  for (size_t i = 0; i < values.size(); ++i) std::memcpy(&values[i], &bytes[i * kVec4Bytes], sizeof(float));
  return values;
}

// As depths: those of a fixed-point format are code / (2^n - 1), rounded once.
std::vector<float> copy_depth(const Pass& pass, std::span<const std::byte> buffer) {
  const TargetKey& key = pass.target.key();
  const uint32_t attachment = kFirstSlotAttachment + key.slots;
  constexpr double kMax16 = 0xFFFF;
  constexpr double kMax24 = 0xFFFFFF;
  std::vector<float> depths;
  // A shader reads a depth as float32, near enough to tell its code from the next.
  const auto exact = [](float depth, double max) { return static_cast<float>(std::nearbyint(depth * max) / max); };
  if (pass.target.is_multisampled()) {
    depths = copy_attachment<float>(pass, attachment, buffer);
    for (float& depth : depths) {
      if (key.depth_format == VK_FORMAT_D16_UNORM) depth = exact(depth, kMax16);
      if (key.depth_format == VK_FORMAT_X8_D24_UNORM_PACK32) depth = exact(depth, kMax24);
    }
    return depths;
  }
  switch (key.depth_format) {
    case VK_FORMAT_D16_UNORM:
      for (const uint16_t code : copy_attachment<uint16_t>(pass, attachment, buffer)) {
        depths.push_back(static_cast<float>(code / kMax16));
      }
      return depths;
    case VK_FORMAT_X8_D24_UNORM_PACK32:
      for (const uint32_t word : copy_attachment<uint32_t>(pass, attachment, buffer)) {
        depths.push_back(static_cast<float>((word & 0xFFFFFFU) / kMax24));  // the other bits are undefined
      }
      return depths;
    default:
      return copy_attachment<float>(pass, attachment, buffer);
  }
}

}  // namespace

Planes read_back(const CaseJob& job, std::span<const std::byte> buffer) {
  const Target& target = job.drawn->target;
  Planes planes{.width = target.width, .height = target.height, .samples = static_cast<uint32_t>(target.samples)};
  const Pass& first = job.passes.front();

  const auto hits = copy_attachment<float>(first, 0, buffer);
  planes.hits.reserve(hits.size());
  for (const float value : hits) planes.hits.push_back(static_cast<uint32_t>(value));

  // The attachment holds the primitive's number + 1 with the facing in the top bit, and 0 where nothing landed.
  planes.owner = copy_attachment<uint32_t>(first, 1, buffer);
  planes.front_facing.reserve(planes.owner.size());
  for (uint32_t& owner : planes.owner) {
    planes.front_facing.push_back((owner & kFrontFacingBit) != 0 ? 1 : 0);
    owner = owner == 0 ? kNoOwner : (owner & ~kFrontFacingBit) - 1;
  }

  if (first.target.has_depth()) planes.depth = copy_depth(first, buffer);
  planes.varyings.reserve(job.needs.packing.components.size());
  for (const ComponentPlace& place : job.needs.packing.components) {
    size_t pass = 0;
    while (place.slot >= job.passes[pass].slots.first + job.passes[pass].slots.counts.total()) ++pass;
    const Pass& drawn = job.passes[pass];
    if (place.slot - drawn.slots.first >= drawn.slots.outputs) continue;
    planes.varyings.push_back(copy_lane(drawn, place, buffer));
  }
  return planes;
}

}  // namespace fillrule::vulkan
