// Who draws a scene: the renderer, or a Vulkan driver. Both to RGBA8 and D32F, cleared before, with as many threads.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cases/model/result.h"
#include "harness/bench/scene.h"
#include "renderer/isa.h"

namespace fillrule::bench {

struct Party {
  std::string name;
  std::string version;  // of a driver
  // Clears and draws; this is what is timed.
  std::function<Result<void>()> draw;
  // RGBA8 of the last draw, samples resolved, row by row from the top left, red in the lowest byte.
  std::function<Result<std::vector<uint32_t>>()> picture;
};

struct DriverOptions {
  std::string name = "lavapipe";
  std::vector<std::string> files;  // as in vulkan::list_devices
};

// The scene must outlive the party.
Party make_renderer(const Scene& scene, uint32_t threads, renderer::Isa isa);
Result<Party> make_driver(const Scene& scene, const DriverOptions& driver, uint32_t threads);

}  // namespace fillrule::bench
