// The program `varyings` for the renderer: final clip-space positions and up to 8 varyings, every fragment written to
// the planes of the output contract. Its twin for the reference is GLSL.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "cases/model/case.h"
#include "cases/model/features.h"
#include "cases/model/planes.h"
#include "cases/model/result.h"
#include "renderer/pipeline.h"

namespace fillrule::programs {

class VaryingsProgram {
 public:
  // `first_primitive` is the number of primitives in the case's draws before this one. The draw's varyings must be
  // complete for every vertex, and the planes cleared to their size.
  VaryingsProgram(const std::vector<Varying>& varyings, const Draw& draw, uint32_t first_primitive, Planes& planes);

  struct TriangleData {
    uint32_t owner = 0;
    uint32_t front_facing = 0;
    // The components of each vertex, the provoking one first.
    std::array<const float*, 3> components{};
  };

  [[nodiscard]] ClipPosition position(uint32_t vertex) const { return draw_->positions[vertex]; }

  [[nodiscard]] TriangleData triangle_data(const renderer::ShadedTriangle& triangle) const {
    TriangleData data{.owner = first_primitive_ + triangle.primitive,
                      .front_facing = triangle.front_facing ? 1U : 0U};
    for (size_t i = 0; i < 3; ++i) {
      const size_t first_component = size_t{triangle.vertices[i]} * component_count_;
      data.components[i] = draw_->varyings.data() + first_component;
    }
    return data;
  }

  void fragment(const TriangleData& data, const renderer::Fragment& fragment) const {
    const size_t pixel = static_cast<size_t>(fragment.y) * width_ + static_cast<size_t>(fragment.x);
    ++hits_[pixel];
    owner_[pixel] = data.owner;
    front_facing_[pixel] = data.front_facing;
    if (component_count_ == 0) {
      return;
    }
    const auto& [value0, value1, value2] = data.components;
    const renderer::PixelWeights weights = fragment.weights();
    for (uint32_t i = 0; i < component_count_; ++i) {
      const Component& component = components_[i];
      if (component.interpolation == Interpolation::kFlat) {
        component.plane[pixel] = value0[i];
      } else {
        const bool is_smooth = component.interpolation == Interpolation::kSmooth;
        component.plane[pixel] = renderer::interpolate(value0[i], value1[i], value2[i],
                                                       is_smooth ? weights.smooth : weights.noperspective);
      }
    }
  }

 private:
  struct Component {
    float* plane = nullptr;
    Interpolation interpolation = Interpolation::kSmooth;
  };

  const Draw* draw_;
  uint32_t first_primitive_;
  size_t width_;
  uint32_t* hits_;
  uint32_t* owner_;
  uint32_t* front_facing_;
  std::array<Component, size_t{kMaxVaryings} * kMaxVaryingComponents> components_;
  uint32_t component_count_ = 0;
};

// What the renderer can draw with this program.
FeatureSet renderer_features();

// Draws a whole case with the renderer. An error names what the renderer cannot draw, or what is inconsistent in the
// case.
Result<Planes> draw_case(const Case& drawn_case, const renderer::Options& options);

}  // namespace fillrule::programs
