// Candidates that did no work: pictures that a suite must not let pass, made from the right one without looking at
// what the case asks for.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "cases/model/result.h"

namespace fillrule::faults {

enum class Cheat : uint8_t {
  kBlank,
  kAllCovered,
  kShiftedByPixel,
  kShiftedByHalf,
  kSwappedVaryings,
  kConstantDepth,
};

struct CheatEntry {
  Cheat cheat = Cheat::kBlank;
  std::string_view name;
  std::string_view what;
};

// In the order of the enumeration.
std::span<const CheatEntry> cheats();

// The error tells the nearest name, or all of them.
Result<Cheat> cheat_named(std::string_view name);

Planes draw_cheat(const Case& drawn, Cheat cheat, uint32_t subpixel_bits);

}  // namespace fillrule::faults
