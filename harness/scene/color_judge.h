// The verdict on the colours of a scene: each party held against the exact varyings, as the oracle has them, and what
// they leave open (color_bounds.h); and both parties held against each other where nobody can see a difference.
#pragma once

#include <cstdint>
#include <string>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "harness/judge/judge.h"
#include "harness/programs/shading.h"

namespace fillrule::scene {

struct ColorParty {
  const Planes* planes = nullptr;  // as a Painter draws them
  uint32_t subpixel_bits = 8;
};

struct PartyColors {
  uint64_t judged = 0;   // samples
  uint64_t outside = 0;  // beyond what the varyings' latitude explains
  std::string first;     // the first one of them, in words
};

struct ColorVerdict {
  PartyColors candidate;
  PartyColors reference;
  // Samples that both parties drew of the same primitive, and those among them that differ by more than 2/255.
  // Nothing is compared of parties with different subpixel bits: they draw other window positions, so that their
  // colours differ by what lies between, and neither is wrong. Each is held against the oracle all the same.
  uint64_t compared = 0;
  uint64_t apart = 0;

  // At 99.9 % of the samples.
  [[nodiscard]] bool alike() const { return apart * 1000 <= compared; }
};

// How much further from the exact ones the varyings may be, where the parties' vertex stages transform.
struct TransformError {
  double position_world = 0;
  double normal_world = 0;
};

// `built` is the case whose positions are final, `oracle` was made of it for the parties' subpixel bits; `reference`
// may be null.
ColorVerdict judge_colors(const Case& built, const programs::CaseShading& shading, const judge::Oracle& oracle,
                          const ColorParty& candidate, const ColorParty* reference, const TransformError& error = {});

}  // namespace fillrule::scene
