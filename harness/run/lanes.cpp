#include "harness/run/lanes.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace fillrule::run {

Lanes::Lanes(std::span<const Case> cases, DeviceOfSlots& device_of) : device_of_(device_of) {
  std::map<vulkan::SlotCounts, std::vector<size_t>> by_slots;
  for (size_t i = 0; i < cases.size(); ++i) by_slots[vulkan::pack(cases[i].varyings).counts].push_back(i);
  for (auto& [slots, numbers] : by_slots) groups_.push_back({.slots = slots, .cases = std::move(numbers)});
  std::ranges::stable_sort(groups_, std::ranges::greater(), [](const Group& group) { return group.cases.size(); });
  for (const Group& group : groups_) {
    if (const auto owner = device_of_.find(group.slots); owner != device_of_.end()) add_left(group, owner->second);
  }
}

std::vector<size_t> Lanes::next(size_t device, size_t most) {
  const std::lock_guard lock(mutex_);
  std::vector<size_t> batch;
  for (Group& group : groups_) {
    if (batch.size() == most) break;
    if (group.drawn == group.cases.size() || !is_for(group, device)) continue;
    const size_t count = std::min(most - batch.size(), group.cases.size() - group.drawn);
    const auto begin = group.cases.begin() + static_cast<ptrdiff_t>(group.drawn);
    batch.insert(batch.end(), begin, begin + static_cast<ptrdiff_t>(count));
    group.drawn += count;
    left_[device] -= count;
  }
  return batch;
}

bool Lanes::is_behind(size_t device, size_t cases) {
  const std::lock_guard lock(mutex_);
  size_t others = 0;
  for (size_t other = 0; other < left_.size(); ++other) {
    if (other != device) others = std::max(others, left_[other]);
  }
  return device < left_.size() && left_[device] > others + cases;
}

// A group is that device's which asks for it first.
bool Lanes::is_for(const Group& group, size_t device) {
  const auto [owner, is_new] = device_of_.emplace(group.slots, device);
  if (is_new) add_left(group, device);
  return owner->second == device;
}

void Lanes::add_left(const Group& group, size_t device) {
  if (left_.size() <= device) left_.resize(device + 1);
  left_[device] += group.cases.size();
}

}  // namespace fillrule::run
