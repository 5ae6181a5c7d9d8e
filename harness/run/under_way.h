// What is being done with which cases at this moment, for whoever has to tell what a process died of: a driver that
// crashes takes everything else with it.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "cases/model/case.h"

namespace fillrule::run {

// Says while it lives that these cases are being worked on. What it is given must outlive it. For use by many
// threads; of more than kMost at once the rest is not told of.
class UnderWay {
 public:
  static constexpr size_t kMost = 64;

  // "drawn by", "lavapipe": what is done, and by whom.
  UnderWay(std::string_view what, std::string_view party, std::span<const Case* const> cases);
  ~UnderWay();
  UnderWay(const UnderWay&) = delete;
  UnderWay& operator=(const UnderWay&) = delete;

  [[nodiscard]] std::string_view what() const { return what_; }
  [[nodiscard]] std::string_view party() const { return party_; }
  [[nodiscard]] std::span<const Case* const> cases() const { return cases_; }

  // The one in a slot, null if there is none; slot < kMost. A signal's handler may call it and what is above. Only in
  // a thread that has stopped does the object stay what it is: of the others a handler may read what is just going.
  static const UnderWay* in_slot(size_t slot);

 private:
  std::string_view what_;
  std::string_view party_;
  std::span<const Case* const> cases_;
  size_t slot_ = kMost;
};

}  // namespace fillrule::run
