#include "harness/stress/generate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/stress/geometry.h"
#include "harness/stress/random.h"

namespace fillrule::stress {
namespace {

constexpr std::array kCullModes{VkCullModeFlags{VK_CULL_MODE_NONE},     VkCullModeFlags{VK_CULL_MODE_NONE},
                                VkCullModeFlags{VK_CULL_MODE_NONE},     VkCullModeFlags{VK_CULL_MODE_NONE},
                                VkCullModeFlags{VK_CULL_MODE_BACK_BIT}, VkCullModeFlags{VK_CULL_MODE_FRONT_BIT}};
constexpr std::array kCompareOps{
    VK_COMPARE_OP_ALWAYS,  VK_COMPARE_OP_ALWAYS,    VK_COMPARE_OP_LESS_OR_EQUAL,    VK_COMPARE_OP_LESS,
    VK_COMPARE_OP_GREATER, VK_COMPARE_OP_NOT_EQUAL, VK_COMPARE_OP_GREATER_OR_EQUAL, VK_COMPARE_OP_EQUAL,
    VK_COMPARE_OP_NEVER};
constexpr std::array kClearDepths{1.0F, 1.0F, 0.0F, 0.5F};

// Small targets mostly: a pixel costs the same wherever it is.
constexpr std::array<std::array<uint32_t, 2>, 3> kLargeTargets{{{128, 128}, {160, 96}, {256, 256}}};
constexpr double kLargeTargetShare = 0.06;

Target random_target(Random& random) {
  Target target;
  if (random.chance(kLargeTargetShare)) {
    const auto [width, height] = random.pick(kLargeTargets);
    target.width = width;
    target.height = height;
  }
  target.clear_depth = random.pick(kClearDepths);
  return target;
}

// A handful of combinations, as a driver compiles a pipeline for each.
std::vector<Varying> random_varyings(Random& random) {
  const Varying smooth{.name = "smooth", .components = 2, .interpolation = Interpolation::kSmooth};
  const Varying noperspective{
      .name = "noperspective", .components = 2, .interpolation = Interpolation::kNoperspective};
  const Varying flat{.name = "flat", .components = 1, .interpolation = Interpolation::kFlat};
  switch (random.below(5)) {
    case 0:
    case 1:
      return {smooth};
    case 2:
      return {noperspective};
    case 3:
      return {flat, smooth};
    default:
      return {smooth, noperspective, flat};
  }
}

// The components of one triangle or mesh: of one magnitude, constant now and then.
void add_values(Draw& draw, uint32_t components, size_t vertices, Random& random) {
  const double magnitude = random.chance(0.7) ? 1 : random.power_of_two(-20, 20);
  const double offset = random.chance(0.8) ? 0 : random.uniform(-1000, 1000) * magnitude;
  const bool constant = random.chance(0.1);
  for (uint32_t c = 0; c < components; ++c) {
    const double first = random.uniform(-1, 1);
    for (size_t i = 0; i < vertices; ++i) {
      const double value = constant || i == 0 ? first : random.uniform(-1, 1);
      draw.varyings.push_back(static_cast<float>(offset + magnitude * value));
    }
  }
}

// From [component][vertex] to the [vertex][component] of Draw, for the vertices since `first_value`.
void transpose(std::vector<float>& values, size_t first_value, size_t components) {
  const std::vector<float> by_component(values.begin() + static_cast<std::ptrdiff_t>(first_value), values.end());
  if (components == 0) return;
  const size_t vertices = by_component.size() / components;
  for (size_t i = 0; i < by_component.size(); ++i) {
    values[first_value + i] = by_component[(i % components) * vertices + i / components];
  }
}

class Generator {
 public:
  Generator(uint64_t seed, Family family, uint64_t number)
      : family_(family), random_(seed, index_of(family), number) {
    const uint32_t count = triangles_per_case(family);
    case_.name = fmt::format("stress/{}/{}-{}", name_of(family), seed, number);
    case_.title = fmt::format("{} random triangles of the family {}", count, name_of(family));
    case_.why = "Drawn to find what nobody thought of.";
    case_.spec = "Basic Polygon Rasterization";
    case_.origin = fmt::format("fillrule stress --seed {}", seed);
    case_.tags = {"random"};
    case_.target = random_target(random_);
    case_.varyings = random_varyings(random_);
    components_ = component_count(case_.varyings);
  }

  Case make() {
    const uint32_t count = triangles_per_case(family_);
    if (family_ == Family::kSharedEdges) {
      add_mesh(count);
    } else if (count == 4) {
      for (uint32_t cell = 0; cell < count; ++cell) add_cell(cell);
    } else {
      const uint32_t draws = 1 + random_.below(2);
      for (uint32_t draw = 0; draw < draws; ++draw) add_list(count / draws);
    }
    return std::move(case_);
  }

 private:
  static uint64_t index_of(Family family) { return static_cast<uint64_t>(family); }

  [[nodiscard]] VkRect2D whole_target() const {
    return {.offset = {.x = 0, .y = 0}, .extent = {.width = case_.target.width, .height = case_.target.height}};
  }

  // The cell's quarter of the target.
  [[nodiscard]] VkRect2D quarter(uint32_t cell) const {
    const uint32_t width = case_.target.width / 2;
    const uint32_t height = case_.target.height / 2;
    return {.offset = {.x = static_cast<int32_t>(cell % 2 * width), .y = static_cast<int32_t>(cell / 2 * height)},
            .extent = {.width = width, .height = height}};
  }

  VkViewport viewport_of(const VkRect2D& area) {
    VkViewport viewport{.x = static_cast<float>(area.offset.x),
                        .y = static_cast<float>(area.offset.y),
                        .width = static_cast<float>(area.extent.width),
                        .height = static_cast<float>(area.extent.height),
                        .minDepth = 0,
                        .maxDepth = 1};
    if (random_.chance(0.1)) std::swap(viewport.minDepth, viewport.maxDepth);
    return viewport;
  }

  // Fractions, offsets, upside down, any range of depths.
  VkViewport odd_viewport(const VkRect2D& area) {
    VkViewport viewport = viewport_of(area);
    viewport.x += static_cast<float>(random_.uniform(-20, 20));
    viewport.y += static_cast<float>(random_.uniform(-20, 20));
    viewport.width *= static_cast<float>(random_.uniform(0.3, 3));
    viewport.height *= static_cast<float>(random_.uniform(0.3, 3));
    if (random_.chance(0.3)) {
      viewport.y += viewport.height;
      viewport.height = -viewport.height;
    }
    viewport.minDepth = static_cast<float>(random_.uniform(0, 1));
    viewport.maxDepth = random_.chance(0.2) ? viewport.minDepth : static_cast<float>(random_.uniform(0, 1));
    return viewport;
  }

  RasterState state(const VkViewport& viewport, const VkRect2D& scissor) {
    RasterState state{.viewport = viewport, .scissor = scissor};
    state.cull_mode = random_.pick(kCullModes);
    state.front_face = random_.chance(0.5) ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE;
    state.depth_test = random_.chance(0.6);
    state.depth_write = random_.chance(0.9);
    state.depth_compare = random_.chance(0.5) ? VK_COMPARE_OP_ALWAYS : random_.pick(kCompareOps);
    return state;
  }

  void add_triangle(Draw& draw) {
    for (const ClipPosition& vertex : random_triangle(family_, draw.state.viewport, random_)) {
      draw.positions.push_back(vertex);
    }
    add_vertex_values(draw, 3);
  }

  void add_vertex_values(Draw& draw, size_t vertices) {
    const size_t first_value = draw.varyings.size();
    add_values(draw, components_, vertices, random_);
    transpose(draw.varyings, first_value, components_);
  }

  void add_cell(uint32_t cell) {
    const VkRect2D area = quarter(cell);
    VkViewport viewport{};
    VkRect2D scissor = area;
    if (family_ == Family::kViewport) {
      viewport = odd_viewport(area);
    } else if (random_.chance(0.3)) {
      viewport = viewport_of(whole_target());
    } else {
      viewport = viewport_of(area);
      if (random_.chance(0.5)) scissor = whole_target();
    }
    Draw draw{.state = state(viewport, scissor)};
    add_triangle(draw);
    case_.draws.push_back(std::move(draw));
  }

  void add_list(uint32_t count) {
    Draw draw{.state = state(viewport_of(whole_target()), whole_target())};
    for (uint32_t i = 0; i < count; ++i) add_triangle(draw);
    case_.draws.push_back(std::move(draw));
  }

  void add_mesh(uint32_t count) {
    Draw draw{.state = state(viewport_of(whole_target()), whole_target())};
    Mesh mesh = random_mesh(count, draw.state.viewport, random_);
    draw.topology = mesh.topology;
    draw.positions = std::move(mesh.positions);
    draw.indices = std::move(mesh.indices);
    add_vertex_values(draw, draw.positions.size());
    case_.draws.push_back(std::move(draw));
  }

  Family family_;
  Random random_;
  Case case_;
  uint32_t components_ = 0;
};

}  // namespace

Case random_case(uint64_t seed, Family family, uint64_t number) {
  return Generator(seed, family, number).make();
}

}  // namespace fillrule::stress
