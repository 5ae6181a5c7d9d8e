// The program `varyings` for the renderer: final clip-space positions and up to 8 varyings, every fragment written to
// the planes of the output contract. Its twin for the reference is GLSL.
#pragma once

#include <array>
#include <bit>
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

  struct PrimitiveData {
    uint32_t owner = 0;
    uint32_t front_facing = 0;
    // The components of each vertex, the provoking one first.
    std::array<const float*, 3> components{};
  };

  [[nodiscard]] ClipPosition position(uint32_t vertex) const { return draw_->positions[vertex]; }

  [[nodiscard]] PrimitiveData primitive_data(const renderer::ShadedPrimitive& primitive) const {
    PrimitiveData data{.owner = first_primitive_ + primitive.primitive,
                       .front_facing = primitive.front_facing ? 1U : 0U};
    for (size_t i = 0; i < 3; ++i) {
      const size_t first_component = size_t{primitive.vertices[i]} * vertex_component_count_;
      data.components[i] = draw_->varyings.data() + first_component;
    }
    return data;
  }

  void fragment(const PrimitiveData& data, const renderer::Fragment& fragment) const {
    const size_t pixel = static_cast<size_t>(fragment.y) * width_ + static_cast<size_t>(fragment.x);
    const auto for_each_sample = [&](const auto& visit) {
      for (uint32_t samples = fragment.samples; samples != 0; samples &= samples - 1) {
        visit(pixel * samples_ + static_cast<size_t>(std::countr_zero(samples)));
      }
    };
    for_each_sample([&](size_t sample) {
      ++hits_[sample];
      owner_[sample] = data.owner;
      front_facing_[sample] = data.front_facing;
    });
    if (component_count_ == 0) {
      return;
    }
    evaluate(data, fragment,
             [&](float* plane, float value) { for_each_sample([&](size_t sample) { plane[sample] = value; }); });
  }

 private:
  static constexpr size_t kMaxComponents = size_t{kMaxVaryings} * kMaxVaryingComponents;

  // The weights that a component is interpolated with: two for each kind of sampling.
  static constexpr uint32_t weights_index(Sampling sampling, Interpolation interpolation) {
    return 2 * static_cast<uint32_t>(sampling) + (interpolation == Interpolation::kNoperspective ? 1U : 0U);
  }

  // How a component gets its value.
  enum class Kind : uint8_t { kInterpolated, kFlat, kFragCoord };

  struct Component {
    float* plane = nullptr;
    Kind kind = Kind::kInterpolated;
    uint32_t weights = 0;
    uint32_t index = 0;  // in the vertex' components, or in the built-in
  };

  // Calls write(plane, value) for each component.
  template <typename Write>
  void evaluate(const PrimitiveData& data, const renderer::Fragment& fragment, const Write& write) const {
    // Of these, only what a varying uses is filled in.
    std::array<renderer::VertexWeights, 6> weights;
    std::array<float, 4> frag_coord;
    const auto set_weights = [&](Sampling sampling, const renderer::PixelWeights& at_point) {
      weights[weights_index(sampling, Interpolation::kSmooth)] = at_point.smooth;
      weights[weights_index(sampling, Interpolation::kNoperspective)] = at_point.noperspective;
    };
    set_weights(Sampling::kCenter, fragment.weights());
    if (has_centroid_) {
      set_weights(Sampling::kCentroid, fragment.weights(fragment.centroid));
    }
    if (has_sample_) {
      set_weights(Sampling::kSample, fragment.weights(fragment.position));
    }
    if (has_frag_coord_) {
      frag_coord = fragment.frag_coord();
    }
    const auto& [value0, value1, value2] = data.components;
    for (uint32_t i = 0; i < component_count_; ++i) {
      const Component& component = components_[i];
      const uint32_t index = component.index;
      if (component.kind == Kind::kInterpolated) {
        write(component.plane,
              renderer::interpolate(value0[index], value1[index], value2[index], weights[component.weights]));
      } else {
        write(component.plane, component.kind == Kind::kFlat ? value0[index] : frag_coord[index]);
      }
    }
  }

  const Draw* draw_;
  uint32_t first_primitive_;
  size_t width_;
  size_t samples_;
  uint32_t* hits_;
  uint32_t* owner_;
  uint32_t* front_facing_;
  std::array<Component, kMaxComponents> components_;
  uint32_t component_count_ = 0;
  uint32_t vertex_component_count_ = 0;
  bool has_frag_coord_ = false;
  bool has_centroid_ = false;
  bool has_sample_ = false;
};

// What the renderer can draw with this program.
FeatureSet renderer_features();

// Draws a whole case with the renderer. An error names what the renderer cannot draw, or what is inconsistent in the
// case.
Result<Planes> draw_case(const Case& drawn_case, const renderer::Options& options);

}  // namespace fillrule::programs
