// Metamorphic checks: what must come out when the same case is drawn in another way. They need no reference, and
// where they ask for equal coverage there is no tolerance.
//
// - second_run: the same bytes once more (Vulkan specification, appendix "Invariance", repeatability).
// - any_number_of_threads: the same bytes with other numbers of threads.
// - rotated_vertices: each triangle's vertices moved on by one place: the same coverage, hits and owners. The depth
//   test is off on both sides, because depths may differ in their last bits. Checks of coverage are drawn without
//   varyings.
// - flipped_winding: each triangle's second and third vertex swapped and the front face turned over: the same
// coverage,
//   hits, owners and facing, so the same triangles are culled.
// - scaled_clip_space: all four coordinates times 2^6: the geometry is the same, so what was right before is right;
// only
//   what the oracle of the original case calls a fault is one.
// - partition: with a user clip distance d, and again with -d, what each leaves adds up to the whole: the same hits
// at
//   every sample whose coverage the oracle does not leave open. Without the depth test.
// - scissor_crop: a smaller scissor gives the same bytes inside and leaves the rest cleared.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/features.h"
#include "cases/model/planes.h"
#include "cases/model/result.h"
#include "harness/judge/judge.h"

namespace fillrule::judge {

struct CheckResult {
  enum class Outcome : uint8_t { kPassed, kFailed, kOptedOut, kDoesNotFit };
  std::string name;  // one of kChecks
  Outcome outcome = Outcome::kPassed;
  std::string message;  // what failed and where, or why the check was left out
};

struct CheckedParty {
  // Draws with so many threads; 0 is the usual number.
  std::function<Result<Planes>(const Case&, uint32_t threads)> draw;
  uint32_t subpixel_bits = 8;
  FeatureSet features;  // what it can draw
};

// All of kChecks, in their order. `original` is what the party drew for the case.
std::vector<CheckResult> metamorphic_checks(const Case& test_case, const CheckedParty& party, const Planes& original);

// Where two parties' planes differ first in their bits, in words; empty if they are equal.
std::string differing_bytes(const Planes& a, const Planes& b);

}  // namespace fillrule::judge
