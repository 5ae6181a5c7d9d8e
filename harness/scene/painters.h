// Who draws scenes in colour: the renderer, or a driver.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "cases/model/result.h"
#include "harness/programs/shading.h"
#include "renderer/prepared_draw.h"

namespace fillrule::scene {

// Draws a built case: planes whose four varyings are r, g, b (0 to 1) and 1 where something landed. May be called by
// several threads at once.
using Painter = std::function<Result<Planes>(const Case&, const programs::CaseShading&)>;

Painter renderer_painter(const renderer::Options& options);

// A device of its own. `driver` as vulkan::DeviceInfo::driver names it.
struct DriverOptions {
  std::string driver = "lavapipe";
  std::vector<std::string> driver_files;
  bool validation = false;
};
Result<Painter> driver_painter(const DriverOptions& options);

// The same, with the device opened when it is first asked to draw.
Painter driver_painter_on_demand(const DriverOptions& options);

// Hands out what was drawn before.
Painter painted_before(Result<Planes> planes);

}  // namespace fillrule::scene
