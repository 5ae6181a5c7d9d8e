#include "harness/run/under_way.h"

#include <array>
#include <atomic>

namespace fillrule::run {
namespace {

std::array<std::atomic<const UnderWay*>, UnderWay::kMost> slots;
static_assert(std::atomic<const UnderWay*>::is_always_lock_free, "a signal's handler reads it");

}  // namespace

UnderWay::UnderWay(std::string_view what, std::string_view party, std::span<const Case* const> cases)
    : what_(what), party_(party), cases_(cases) {
  for (size_t slot = 0; slot < slots.size(); ++slot) {
    const UnderWay* free = nullptr;
    if (slots[slot].compare_exchange_strong(free, this)) {
      slot_ = slot;
      return;
    }
  }
}

UnderWay::~UnderWay() {
  if (slot_ < kMost) slots[slot_] = nullptr;
}

const UnderWay* UnderWay::in_slot(size_t slot) {
  return slots[slot];
}

}  // namespace fillrule::run
