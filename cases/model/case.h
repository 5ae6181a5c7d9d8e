// What is drawn: one conformance case, with every sweep variable already replaced by its value.
//
// Plain values without arithmetic, in Vulkan's own enumerations (vulkan_core.h; no driver is needed). Positions are
// final clip-space floats, so that every party gets identical bits.
#pragma once

#include <vulkan/vulkan_core.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fillrule {

struct Scene;  // cases/model/scene.h

// The limits of the format. 16384 is the largest viewport of the reference drivers.
inline constexpr uint32_t kMaxTargetSize = 16384;
inline constexpr uint32_t kMaxSamples = 16;  // of a pixel
inline constexpr uint32_t kMaxVaryings = 8;
inline constexpr uint32_t kMaxVaryingComponents = 4;
inline constexpr uint32_t kMaxClipAndCullDistances = 8;

// Clip space, (x, y, z, w), before any clipping or division.
using ClipPosition = std::array<float, 4>;

// How a varying is interpolated (Vulkan specification, "Interpolation decorations"); SPIR-V has no enumeration for
// it.
enum class Interpolation : uint8_t { kSmooth, kNoperspective, kFlat };

// Where in the pixel it is evaluated: at the centre, anywhere in the part of the pixel that the primitive covers
// (SPIR-V's Centroid), or at each sample (Sample). One varying of the last kind turns on sample shading: the fragment
// stage runs for each sample.
enum class Sampling : uint8_t { kCenter, kCentroid, kSample };

// What its values are: the vertices' interpolated, or a built-in of the fragment stage, recorded as it is read.
// (gl_FrontFacing and gl_PrimitiveID are recorded always: the planes front_facing and owner.)
enum class VaryingSource : uint8_t {
  kVertices,
  kFragCoord,   // gl_FragCoord: x, y, z, 1/w
  kPointCoord,  // gl_PointCoord: s, t
};

struct Varying {
  std::string name;
  uint32_t components = 1;  // 1 to 4
  Interpolation interpolation = Interpolation::kSmooth;
  Sampling sampling = Sampling::kCenter;
  VaryingSource source = VaryingSource::kVertices;
  bool operator==(const Varying&) const = default;
};

struct Target {
  uint32_t width = 64;                           // pixels
  uint32_t height = 64;                          // pixels
  VkFormat depth_format = VK_FORMAT_D32_SFLOAT;  // D16_UNORM, X8_D24_UNORM_PACK32, D32_SFLOAT, or UNDEFINED: none
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
  float clear_depth = 1.0F;
};

// Vulkan specification, "Depth Bias Computation".
struct DepthBias {
  float constant_factor = 0;  // in units of the format's resolution
  float slope_factor = 0;     // in units of the depth's slope, 1/pixel
  float clamp = 0;            // 0: none; the largest bias where positive, the least where negative
  bool operator==(const DepthBias&) const = default;
};

// "Depth Bounds Test": a fragment passes where the stored depth is within.
struct DepthBounds {
  float min = 0;
  float max = 1;
  bool operator==(const DepthBounds&) const = default;
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
  std::optional<DepthBias> depth_bias;
  std::optional<DepthBounds> depth_bounds;
  bool depth_clamp = false;
  bool depth_clip = true;            // false: no primitive is cut at the near and far planes
  bool negative_one_to_one = false;  // the view volume is -w <= z <= w instead of 0 <= z <= w
  VkPolygonMode polygon_mode = VK_POLYGON_MODE_FILL;
  VkLineRasterizationModeEXT line_mode = VK_LINE_RASTERIZATION_MODE_RECTANGULAR_EXT;  // or Bresenham
  float line_width = 1;                                                               // pixels
  VkProvokingVertexModeEXT provoking_vertex = VK_PROVOKING_VERTEX_MODE_FIRST_VERTEX_EXT;
  uint32_t sample_mask = 0xFFFFFFFF;  // bit i: sample i
};

struct Draw {
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  RasterState state;
  std::vector<ClipPosition> positions;
  // [vertex][component]: for each vertex the components of the case's varyings that are no built-ins, in the order of
  // declaration.
  std::vector<float> varyings;
  std::optional<std::vector<uint32_t>> indices;  // absent: vertices are used in their order
  VkIndexType index_type = VK_INDEX_TYPE_UINT32;
  int32_t vertex_offset = 0;       // added to every index, after the comparison with the restart index
  bool primitive_restart = false;  // the index restart_index() ends a strip or fan and begins the next

  std::vector<float> point_sizes;  // pixels, one for each vertex; empty: 1
  // User clip and cull distances: [vertex][distance]; both counts together are at most kMaxClipAndCullDistances.
  uint32_t clip_distance_count = 0;
  uint32_t cull_distance_count = 0;
  std::vector<float> clip_distances;
  std::vector<float> cull_distances;
};

// The metamorphic checks: what must come out when a case is drawn in another way (harness/judge/metamorphic.h). A
// case may opt out of one by name, with a reason.
inline constexpr std::array<std::string_view, 7> kChecks{
    "second_run",        "any_number_of_threads", "rotated_vertices", "flipped_winding",
    "scaled_clip_space", "scissor_crop",          "partition"};

struct OptOut {
  std::string check;
  std::string reason;
  bool operator==(const OptOut&) const = default;
};

// What a case shows beside its control: another picture, the same samples covered as often, or none at all.
enum class Effect : uint8_t { kDifferent, kSame, kNothing };

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
  // The name of the case that differs from this one in nothing but what is tested. Empty: none is named, or this case
  // is the control of others in its file.
  std::string control;
  Effect effect = Effect::kDifferent;
  std::vector<OptOut> opt_outs;

  Target target;
  std::vector<Varying> varyings;
  std::vector<Draw> draws;
  // What the draws are of and how they are shaded: the file's [scene]; null where a file gives its draws itself.
  // The draws of a scene are made by harness/scene.
  std::shared_ptr<const Scene> scene;
};

// The number of planes that the varyings fill, built-ins included.
uint32_t component_count(const std::vector<Varying>& varyings);

// The number of floats that each vertex carries in Draw::varyings: the components of those that are no built-ins.
uint32_t vertex_component_count(const std::vector<Varying>& varyings);

// The index that restarts primitives: the type's largest.
uint32_t restart_index(VkIndexType type);

// The runs of elements (vertices, or indices) between restarts, empty ones left out; one run where nothing restarts.
struct ElementRun {
  uint32_t first = 0;
  uint32_t count = 0;
  bool operator==(const ElementRun&) const = default;
};
std::vector<ElementRun> element_runs(const Draw& draw);

// The number of complete primitives in a run of so many elements.
uint32_t primitives_in_run(VkPrimitiveTopology topology, uint32_t elements);

// The number of vertices that a draw feeds to primitive assembly.
uint32_t element_count(const Draw& draw);

// The number of complete primitives that a draw assembles, culled, clipped and degenerate ones counted. It runs on
// over restarts; a polygon drawn as lines or points is one primitive.
uint32_t primitive_count(const Draw& draw);

}  // namespace fillrule
