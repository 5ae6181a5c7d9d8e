// The reference: cases drawn headless through Vulkan 1.3 on any installed driver, and read back as Planes.
//
// Positions go to the driver as they are, in clip space; planes come back in framebuffer coordinates (pixels, origin
// at the top left). Every step between them is the driver's: Vulkan specification, "Fixed-Function Vertex
// Post-Processing", "Rasterization" and "Fragment Operations".
#pragma once

#include <vulkan/vulkan_core.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/features.h"
#include "cases/model/planes.h"
#include "cases/model/result.h"
#include "cases/model/texture.h"

namespace fillrule::vulkan {

// Sizes in pixels that a device draws as they are: 1, and min + i * step up to max; with step 0 all from min to max.
struct SizeRange {
  float min = 1;
  float max = 1;
  float step = 0;
};

// What a device says of itself.
struct DeviceInfo {
  std::string name;              // "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string driver;            // the short name that Options::driver takes: "lavapipe", "swiftshader", ...
  VkDriverId driver_id{};        // 0 where the driver does not tell
  std::string driver_version;    // "Mesa 22.3.6 (LLVM 15.0.6)", "5.0.0"
  uint32_t api_version = 0;      // as in VK_MAKE_API_VERSION
  uint32_t subpixel_bits = 0;    // subPixelPrecisionBits
  uint32_t max_target_size = 0;  // pixels, of width and of height
  std::array<uint32_t, 2> max_viewport_size{};  // pixels
  std::array<float, 2> viewport_bounds{};       // framebuffer coordinates
  SizeRange line_widths;
  SizeRange point_sizes;
  FeatureSet features;            // of cases that it can draw
  bool has_primitive_id = false;  // gl_PrimitiveID in a fragment shader (feature geometryShader)
};

// The devices of every installed driver and of the drivers in `driver_files` (ICD manifests); empty if there are
// none. The files are added to the environment variable VK_ADD_DRIVER_FILES, so call this before other threads run.
Result<std::vector<DeviceInfo>> list_devices(std::span<const std::string> driver_files = {});

// The GLSL pair that is drawn with: generic text, specialised by macros.
//   INTERPOLATED(S)     S(i, qualifiers) for each vec4 slot i that the vertices fill, as in S(0, centroid smooth)
//   NUM_INTERPOLATED    how many there are
//   FRAG_COORDS(S), POINT_COORDS(S)   S(i) for each slot i that gl_FragCoord or gl_PointCoord (twice) fills
//   NUM_CLIP_DISTANCES, NUM_CULL_DISTANCES   in the vertex stage alone
//   PRIMITIVE_ID        1 if the fragment stage may read gl_PrimitiveID
//   VARIANT             of the draw's resources; 0 without
//
// Vertex inputs: the position at location 0, the slots from location 1, the point size (float) behind them, which the
// stage writes whatever is drawn, then clip and cull distances (float each). Fragment outputs: a hit (float) at
// location 0, the primitive's number + 1 with the facing in the top bit (uint) at location 1, then the slots, or a
// colour alone. Push constants: uint first_primitive, vertices_per_primitive, first_provoking_vertex.
//
// A program with uniforms finds a storage block (readonly, std140) of that size at set 0, binding 0, and a sampler2D
// at binding 1.
struct Program {
  std::string vertex_glsl;
  std::string fragment_glsl;
  // The fragment stage writes one vec4 instead of every slot: what is read back are the components of the first slot.
  bool draws_color = false;
  uint32_t uniform_bytes = 0;  // 0: the program reads nothing beside its vertices
};

// What a program with uniforms reads in one draw.
struct DrawResources {
  std::span<const std::byte> uniforms;
  std::shared_ptr<const Texture> texture;  // null: one white texel
  // Which parts of the program the draw needs, in a way of the program's own. What is left out need not be compiled.
  uint32_t variant = 0;
};

// Where the primitive's number comes from.
enum class PrimitiveNumber : uint8_t {
  kBest,            // gl_PrimitiveID where the device has it, else the provoking vertex
  kProvokingVertex  // a flat varying of the provoking vertex; indexed draws are expanded
};

struct Options {
  std::string driver = "lavapipe";
  std::vector<std::string> driver_files;  // as in list_devices
  Program program;
  PrimitiveNumber primitive_number = PrimitiveNumber::kBest;
  bool validation = false;  // loads VK_LAYER_KHRONOS_validation, with synchronization validation
  // What one submission uses, unless a single case needs more. Small enough that images and buffers stay near the
  // processor's caches: 512 MiB cost lavapipe a quarter more time per case.
  uint64_t bytes_in_flight = uint64_t{32} << 20U;
};

// Lavapipe compiles a shader when something is drawn with it first. Optimising it takes half of that, which shaders
// that draw a few thousand pixels do not bring in again; what they compute is the same. It holds for devices that are
// opened later, in a process that has opened none: a driver that is to be judged is left as it is shipped, and so is
// what is timed by itself (color_draw.h). Whatever the user has set stays.
void prefer_fast_compilation();

// One device, kept for all cases. Not for use by two threads at once.
class Reference {
 public:
  // Fails if the driver is not there (the error names those that are), cannot do what is needed, or the program does
  // not compile.
  static Result<Reference> create(const Options& options);

  Reference(Reference&& other) noexcept;
  Reference& operator=(Reference&& other) noexcept;
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;
  ~Reference();

  [[nodiscard]] const DeviceInfo& device() const;

  // Draws all cases in as few submissions as bytes_in_flight allows. Result i belongs to case i; the error of one
  // leaves the others drawn.
  std::vector<Result<Planes>> draw(std::span<const Case* const> cases);

  // Draws one case with a program that has uniforms; `resources` has an entry for each draw of the case.
  Result<Planes> draw(const Case& drawn, std::span<const DrawResources> resources);

  // Everything the validation layers had to say so far.
  [[nodiscard]] std::vector<std::string> validation_messages() const;

 private:
  struct State;
  explicit Reference(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace fillrule::vulkan
