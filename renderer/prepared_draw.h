// A draw as it is asked for, checked, and what follows from its state before any vertex is seen.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "cases/model/case.h"
#include "cases/model/result.h"
#include "renderer/coverage.h"
#include "renderer/depth.h"
#include "renderer/primitive_assembly.h"
#include "renderer/primitive_setup.h"
#include "renderer/sample_locations.h"

namespace fillrule::renderer {

struct Options {
  uint32_t subpixel_bits = kMaxSubpixelBits;  // kMinSubpixelBits to kMaxSubpixelBits
  uint32_t threads = 1;                       // any number gives the same bytes
  Fill fill = Fill::kEdgeFunction;            // so does either fill
};

// What a draw needs besides its program. Fixed-function state is Vulkan's.
struct DrawInput {
  uint32_t target_width = 0;  // pixels
  uint32_t target_height = 0;
  uint32_t samples = 1;         // of a pixel: 1, 2, 4, 8 or 16
  bool sample_shading = false;  // the fragment program runs for each sample, not for each pixel
  VertexStream vertices;
  RasterState state;
  DepthBuffer depth;
};

// Everything of a draw that does not depend on the program.
struct PreparedDraw {
  DrawInput input;
  uint32_t subpixel_bits;
  CoverageRule coverage_rule;
  DepthStage depth;
  PrimitiveAssembly assembly;
  PixelRect viewport_pixels;  // by their centres
  SetupState setup;
  std::span<const SampleLocation> sample_locations;
  std::array<SampleArea, kMaxSamples> sample_areas;  // the first input.samples of them

  [[nodiscard]] std::span<const SampleArea> samples() const { return {sample_areas.data(), input.samples}; }
};

// Refuses what the pipeline cannot draw: a state outside of Vulkan's limits, an index without a vertex, a topology of
// lines or points.
Result<PreparedDraw> prepare_draw(const DrawInput& input, const Options& options);

}  // namespace fillrule::renderer
