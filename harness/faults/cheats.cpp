#include "harness/faults/cheats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "cases/format/suggestion.h"
#include "harness/faults/rasterizer.h"

namespace fillrule::faults {
namespace {

constexpr auto kCheats = std::to_array<CheatEntry>({
    {Cheat::kBlank, "blank", "nothing is drawn"},
    {Cheat::kAllCovered, "all_covered", "every sample without a hit gets one, of primitive 0"},
    {Cheat::kShiftedByPixel, "shifted_by_pixel", "the right picture, moved one pixel to the right"},
    {Cheat::kShiftedByHalf, "shifted_by_half", "the right picture of a viewport that is half a pixel further right"},
    {Cheat::kSwappedVaryings, "swapped_varyings", "the first two components of the varyings change places"},
    {Cheat::kConstantDepth, "constant_depth", "depth is 0.5 everywhere"},
});

template <typename Value>
void move_right(std::vector<Value>& plane, size_t row, size_t samples, Value clear) {
  for (size_t begin = 0; begin < plane.size(); begin += row) {
    const auto first = plane.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = first + static_cast<std::ptrdiff_t>(row);
    std::shift_right(first, last, static_cast<std::ptrdiff_t>(samples));
    std::fill_n(first, samples, clear);
  }
}

void move_right(Planes& planes, float clear_depth) {
  const size_t samples = planes.samples;
  const size_t row = planes.width * samples;
  move_right(planes.hits, row, samples, 0U);
  move_right(planes.owner, row, samples, kNoOwner);
  move_right(planes.front_facing, row, samples, 0U);
  move_right(planes.depth, row, samples, clear_depth);
  for (std::vector<float>& plane : planes.varyings) move_right(plane, row, samples, 0.0F);
}

}  // namespace

std::span<const CheatEntry> cheats() {
  return kCheats;
}

Result<Cheat> cheat_named(std::string_view name) {
  const auto* const found = std::ranges::find(kCheats, name, &CheatEntry::name);
  if (found != kCheats.end()) return found->cheat;
  std::vector<std::string> names;
  names.reserve(kCheats.size());
  for (const CheatEntry& entry : kCheats) names.emplace_back(entry.name);
  return failure(fmt::format("there is no cheat '{}'", name), format::suggestion(name, names, "the cheats are"));
}

Planes draw_cheat(const Case& drawn, Cheat cheat, uint32_t subpixel_bits) {
  Case moved = drawn;
  switch (cheat) {
    case Cheat::kBlank:
      moved.draws.clear();
      return draw_case(moved, Fault::kNone, subpixel_bits);
    case Cheat::kShiftedByHalf:
      for (Draw& draw : moved.draws) draw.state.viewport.x += 0.5F;
      return draw_case(moved, Fault::kNone, subpixel_bits);
    default:
      break;
  }
  Planes planes = draw_case(drawn, Fault::kNone, subpixel_bits);
  if (cheat == Cheat::kAllCovered) {
    for (size_t i = 0; i < planes.hits.size(); ++i) {
      if (planes.hits[i] != 0) continue;
      planes.hits[i] = 1;
      planes.owner[i] = 0;
    }
  }
  if (cheat == Cheat::kShiftedByPixel) {
    moved.draws.clear();
    const Planes cleared = draw_case(moved, Fault::kNone, subpixel_bits);
    move_right(planes, cleared.depth.empty() ? 0 : cleared.depth.front());
  }
  if (cheat == Cheat::kSwappedVaryings && planes.varyings.size() > 1) {
    std::swap(planes.varyings[0], planes.varyings[1]);
  }
  if (cheat == Cheat::kConstantDepth) std::ranges::fill(planes.depth, 0.5F);
  return planes;
}

}  // namespace fillrule::faults
