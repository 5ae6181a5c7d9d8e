// Which of the reference's devices draws which cases.
//
// A cold run is mostly a software driver's compilation of shaders, which each device does on one thread when
// something is first drawn. So there may be two devices, each on a thread; cases that share shaders share a device,
// or both would compile them.
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <span>
#include <vector>

#include "cases/model/case.h"
#include "reference/vulkan/packing.h"

namespace fillrule::run {

// Which device has compiled the shaders for varyings that are packed into such slots: kept from run to run.
using DeviceOfSlots = std::map<vulkan::SlotCounts, size_t>;

// Hands out cases in groups that share shaders: a device that has nothing left to draw takes the next group that is
// nobody's. For use by many threads.
class Lanes {
 public:
  Lanes(std::span<const Case> cases, DeviceOfSlots& device_of);

  // Numbers of up to `most` cases for the device; none where nothing is left for it.
  std::vector<size_t> next(size_t device, size_t most);

  // Whether the device has over `cases` more left than any other: the rest of them, at the end, while nobody else
  // draws.
  [[nodiscard]] bool is_behind(size_t device, size_t cases);

 private:
  struct Group {
    vulkan::SlotCounts slots;
    std::vector<size_t> cases;
    size_t drawn = 0;
  };
  [[nodiscard]] bool is_for(const Group& group, size_t device);
  void add_left(const Group& group, size_t device);

  std::mutex mutex_;
  DeviceOfSlots& device_of_;
  std::vector<Group> groups_;  // the largest first
  std::vector<size_t> left_;   // for each device its cases that were not handed out; of groups that are its own
};

}  // namespace fillrule::run
