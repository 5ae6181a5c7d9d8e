// What is drawn: one conformance case, with every sweep variable already replaced by its value.
//
// Plain values without arithmetic, in Vulkan's own enumerations (vulkan_core.h; no driver is needed). Positions are
// final clip-space floats, so that every party gets identical bits.
#pragma once

#include <vulkan/vulkan_core.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fillrule {

// The limits of the format. 16384 is the largest viewport of the reference drivers.
inline constexpr uint32_t kMaxTargetSize = 16384;
inline constexpr uint32_t kMaxVaryings = 8;
inline constexpr uint32_t kMaxVaryingComponents = 4;

// Clip space, (x, y, z, w), before any clipping or division.
using ClipPosition = std::array<float, 4>;

// How a varying is interpolated (Vulkan specification, "Interpolation decorations"); SPIR-V has no enumeration for
// it.
enum class Interpolation : uint8_t { kSmooth, kNoperspective, kFlat };

struct Varying {
  std::string name;
  uint32_t components = 1;  // 1 to 4
  Interpolation interpolation = Interpolation::kSmooth;
  bool operator==(const Varying&) const = default;
};

struct Target {
  uint32_t width = 64;   // pixels
  uint32_t height = 64;  // pixels
  VkFormat depth_format = VK_FORMAT_D32_SFLOAT;
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
  float clear_depth = 1.0F;
};

// The fixed-function state of one draw. The viewport and the scissor are in framebuffer coordinates: pixels, origin
// at the top left, y down.
struct RasterState {
  VkViewport viewport{};
  VkRect2D scissor{};
  VkCullModeFlags cull_mode = VK_CULL_MODE_NONE;
  VkFrontFace front_face = VK_FRONT_FACE_COUNTER_CLOCKWISE;
  bool depth_test = false;
  bool depth_write = true;  // without a depth test nothing is written, as Vulkan has it
  VkCompareOp depth_compare = VK_COMPARE_OP_LESS;
};

struct Draw {
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  RasterState state;
  std::vector<ClipPosition> positions;
  // [vertex][component]: for each vertex the components of all the case's varyings, in the order of declaration.
  std::vector<float> varyings;
  std::optional<std::vector<uint32_t>> indices;  // absent: vertices are used in their order
};

// The metamorphic checks: what must come out when a case is drawn in another way (harness/judge/metamorphic.h). A
// case may opt out of one by name, with a reason.
inline constexpr std::array<std::string_view, 6> kChecks{"second_run",        "any_number_of_threads",
                                                         "rotated_vertices",  "flipped_winding",
                                                         "scaled_clip_space", "scissor_crop"};

struct OptOut {
  std::string check;
  std::string reason;
  bool operator==(const OptOut&) const = default;
};

struct Case {
  // The head. `name` is the file's path below the suite's folder without its ending, then the sweep's values:
  // "clipping/near_plane[angle=30]".
  std::string name;
  std::string file;
  std::string title;
  std::string why;
  std::string spec;
  std::string origin;
  std::vector<std::string> tags;
  std::vector<OptOut> opt_outs;

  Target target;
  std::vector<Varying> varyings;
  std::vector<Draw> draws;
};

// The number of floats that each vertex carries besides its position.
uint32_t component_count(const std::vector<Varying>& varyings);

// The number of vertices that a draw feeds to primitive assembly.
uint32_t element_count(const Draw& draw);

// The number of complete primitives that a draw assembles, culled, clipped and degenerate ones counted.
uint32_t primitive_count(const Draw& draw);

}  // namespace fillrule
