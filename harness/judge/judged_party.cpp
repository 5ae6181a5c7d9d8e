#include "harness/judge/judged_party.h"

#include <bit>

namespace fillrule::judge {
namespace {

PlaneValue integer(uint32_t value) {
  return {.bits = value, .number = static_cast<double>(value)};
}

PlaneValue floating(float value) {
  return {.bits = std::bit_cast<uint32_t>(value), .number = static_cast<double>(value)};
}

}  // namespace

PlaneValue value_of(const Planes& planes, PlaneKind kind, uint32_t component, size_t index) {
  switch (kind) {
    case PlaneKind::kCoverage:
      return integer(planes.hits[index] != 0 ? 1 : 0);
    case PlaneKind::kHits:
      return integer(planes.hits[index]);
    case PlaneKind::kOwner:
      return integer(planes.owner[index]);
    case PlaneKind::kFrontFacing:
      return integer(planes.front_facing[index]);
    case PlaneKind::kDepth:
      return floating(planes.depth[index]);
    case PlaneKind::kVarying:
      return floating(planes.varyings[component][index]);
  }
  return {};
}

Standing JudgedParty::standing_of(PlaneKind kind, uint32_t component, size_t index) const {
  switch (kind) {
    case PlaneKind::kCoverage:
      return judge.coverage(*possible, index);
    case PlaneKind::kHits:
      return judge.hits(*possible, index);
    case PlaneKind::kOwner:
      return judge.owner(*possible, index);
    case PlaneKind::kFrontFacing:
      return judge.front_facing(*possible, index);
    case PlaneKind::kDepth:
      return judge.depth(*possible, index);
    case PlaneKind::kVarying:
      return judge.varying(*possible, index, component);
  }
  return {};
}

bool stand_alike(const JudgedParty& a, const JudgedParty& b, PlaneKind kind, size_t index) {
  if (a.possible != b.possible || a.party.planes->owner[index] != b.party.planes->owner[index]) return false;
  if (kind != PlaneKind::kCoverage && kind != PlaneKind::kHits) return true;
  return !a.judge.breaks_line_rule(index) && !b.judge.breaks_line_rule(index);
}

}  // namespace fillrule::judge
