// Whoever is being judged, by name.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/features.h"
#include "cases/model/planes.h"
#include "cases/model/result.h"
#include "harness/scene/painters.h"
#include "renderer/isa.h"

namespace fillrule::run {

struct Candidate {
  std::string name;
  uint32_t subpixel_bits = 8;
  // What it can draw of the features that a case may need.
  FeatureSet features;
  // Why it cannot draw a case, if it cannot: what it lacks, or a limit.
  std::function<Result<void>(const Case&)> check;
  // Draws with so many threads, 0 for the number in the options. May be called by several threads at once.
  std::function<Result<Planes>(const Case&, uint32_t threads)> draw;
  // Draws scenes in colour; empty if it cannot.
  scene::Painter paint;
};

struct CandidateOptions {
  uint32_t subpixel_bits = 8;                // of the renderer; a driver has its own
  uint32_t threads = 1;                      // that the renderer draws one case with; a driver has its own
  renderer::Isa isa = renderer::best_isa();  // of the renderer
  std::vector<std::string> driver_files;     // as in vulkan::list_devices
};

// The candidates there are: "renderer", "renderer:scanline" (which fills by scanlines instead of by edge functions),
// "faults:NAME" and "cheats:NAME" (the naive rasterizer with that fault, "faults:none" without any, or cheat:
// harness/faults), and every Vulkan driver by the name that `fillrule devices` shows. Any other name is an error that
// says so.
Result<Candidate> make_candidate(const std::string& name, const CandidateOptions& options);

}  // namespace fillrule::run
