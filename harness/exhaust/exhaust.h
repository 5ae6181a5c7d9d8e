// Goes through a small world, whole: draws it in batches with the candidate and the reference, and compares both with
// the oracle byte for byte. Batches are drawn by several threads; what is found does not depend on how many.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/exhaust/compare.h"
#include "harness/exhaust/party.h"

namespace fillrule::exhaust {

struct Options {
  World world;
  VkCullModeFlags cull_mode = VK_CULL_MODE_NONE;
  uint32_t target_size = 0;  // pixels; a power of two
  uint32_t threads = 1;
  std::string state_file;       // empty: an interruption loses everything
  bool fresh = false;           // begin anew even if there is a state file
  size_t max_differences = 20;  // that are kept in full, of each party
};

struct Parties {
  Party candidate;
  std::optional<Party> reference;
};

// What one party did.
struct Findings {
  Tally tally;
  std::vector<Difference> first;  // in the order of the triples
  bool operator==(const Findings&) const = default;
};

// What is known of the triangles so far, always the first ones of the world.
struct Progress {
  uint64_t triangles = 0;
  uint64_t covering = 0;  // of these, those that cover a pixel
  Findings candidate;
  Findings reference;
  double seconds = 0;  // drawing and comparing, of all sessions
  bool operator==(const Progress&) const = default;
};

struct Outcome {
  Progress progress;
  uint64_t resumed_from = 0;  // triangles that an earlier session had done
  bool finished = false;      // false: was told to stop
  std::string note;           // why a state file that was there was not used
};

// Called at the beginning, with what an earlier session has left, and now and then, one thread at a time; false
// stops.
using OnProgress = std::function<bool(const Progress& progress)>;

Result<Outcome> exhaust(const Options& options, const Parties& parties, const OnProgress& on_progress);

// How many triangles of a world of ordered triples have another coverage, or not the reversed winding, in another
// order of their vertices, by the oracle. 0 is why a larger world may be gone through in one order.
uint64_t asymmetric_triangles(const World& world);

}  // namespace fillrule::exhaust
