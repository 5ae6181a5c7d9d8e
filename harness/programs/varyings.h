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
#include "renderer/row_weights.h"

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
    if (is_plain_) {
      plain_fragment(data, fragment, pixel);
      return;
    }
    for_each_sample(pixel, fragment.samples, [&](size_t sample) {
      ++hits_[sample];
      owner_[sample] = data.owner;
      front_facing_[sample] = data.front_facing;
    });
    if (component_count_ == 0) {
      return;
    }
    const Inputs inputs = inputs_of(fragment);
    for (uint32_t i = 0; i < component_count_; ++i) {
      const float value = value_of(components_[i], data, inputs);
      for_each_sample(pixel, fragment.samples, [&](size_t sample) { components_[i].plane[sample] = value; });
    }
  }

  // The same for a block of pixels of one sample, row by row where that pays.
  template <typename L>
  [[gnu::always_inline]] void block(const PrimitiveData& data, int32_t x, int32_t y, uint64_t landed,
                                    const renderer::PrimitiveInterpolation& interpolation) const {
    constexpr int kFew = L::kWidth > 1 ? 1 : 2;  // cost less one by one
    const bool by_rows = is_plain_ && static_cast<size_t>(x) + renderer::kBlockSize <= width_;
    for (; landed != 0; landed >>= renderer::kBlockSize, ++y) {
      const auto row = static_cast<uint32_t>(landed & 0xFFU);
      if (by_rows && std::popcount(row) > kFew && plain_row<L>(data, x, y, row, interpolation)) {
        continue;
      }
      for (uint32_t rest = row; rest != 0; rest &= rest - 1) {
        fragment(data, {.x = x + std::countr_zero(rest), .y = y, .interpolation = interpolation});
      }
    }
  }

 private:
  struct Component {
    float* plane = nullptr;
    Interpolation interpolation = Interpolation::kSmooth;
    Sampling sampling = Sampling::kCenter;
    VaryingSource source = VaryingSource::kVertices;
    uint32_t index = 0;  // of the component in the vertex, or in the built-in
  };

  // One sample a pixel, and nothing but vertices' values at its centre: no question is asked for each component.
  void plain_fragment(const PrimitiveData& data, const renderer::Fragment& fragment, size_t pixel) const {
    ++hits_[pixel];
    owner_[pixel] = data.owner;
    front_facing_[pixel] = data.front_facing;
    const auto& [value0, value1, value2] = data.components;
    uint32_t i = 0;
    for (; i < flat_end_; ++i) {
      components_[i].plane[pixel] = value0[components_[i].index];
    }
    if (i == component_count_) {
      return;
    }
    const renderer::PixelWeights weights = fragment.weights();
    for (; i < component_count_; ++i) {
      const uint32_t index = components_[i].index;
      components_[i].plane[pixel] = renderer::interpolate(value0[index], value1[index], value2[index],
                                                          i < smooth_end_ ? weights.smooth : weights.noperspective);
    }
  }

  // The fragments of a row of a block. False, and nothing written, where their weights have to be constrained.
  template <typename L>
  [[nodiscard, gnu::always_inline]] bool plain_row(const PrimitiveData& data, int32_t x, int32_t y, uint32_t row,
                                                   const renderer::PrimitiveInterpolation& interpolation) const {
    const size_t pixel = static_cast<size_t>(y) * width_ + static_cast<size_t>(x);
    if (flat_end_ < component_count_) {
      const renderer::RowWeights<L> weights(interpolation, x, y);
      if (!weights.are_plausible()) {
        return false;
      }
      if (flat_end_ < smooth_end_) {
        write_components<L>(data, flat_end_, smooth_end_, weights.smooth(), pixel, row);
      }
      if (smooth_end_ < component_count_) {
        write_components<L>(data, smooth_end_, component_count_, weights.noperspective(), pixel, row);
      }
    }
    for (uint32_t i = 0; i < renderer::kBlockSize; i += L::kWidth) {
      const typename L::Some own = L::some(row >> i);
      uint32_t* const hits = hits_ + pixel + i;
      L::store(own, L::load(hits) + 1, hits);
      L::store(own, typename L::Int{} + static_cast<int32_t>(data.owner), owner_ + pixel + i);
      L::store(own, typename L::Int{} + static_cast<int32_t>(data.front_facing), front_facing_ + pixel + i);
      for (uint32_t c = 0; c < flat_end_; ++c) {
        L::store(own, L::all(data.components[0][components_[c].index]), components_[c].plane + pixel + i);
      }
    }
    return true;
  }

  // Components [first, end), all of these weights.
  template <typename L>
  [[gnu::always_inline]] void write_components(const PrimitiveData& data, uint32_t first, uint32_t end,
                                               const renderer::RowOfWeights<L>& weights, size_t pixel,
                                               uint32_t row) const {
    const auto& [value0, value1, value2] = data.components;
    for (uint32_t c = first; c < end; ++c) {
      const uint32_t index = components_[c].index;
      float* const plane = components_[c].plane + pixel;
      renderer::RowOfValues<L> values;
      if (!renderer::interpolate_row<L>(value0[index], value1[index], value2[index], weights, values)) {
        write_finite<L>(value0[index], value1[index], value2[index], weights, plane, row);
        continue;
      }
      for (uint32_t i = 0; i < renderer::kBlockSize; i += L::kWidth) {
        L::store(L::some(row >> i), values[i / L::kWidth], plane + i);
      }
    }
  }

  // Pixel by pixel, where a value overflows a float.
  template <typename L>
  [[gnu::always_inline]] static void write_finite(float value0, float value1, float value2,
                                                  const renderer::RowOfWeights<L>& weights, float* plane,
                                                  uint32_t row) {
    std::array<std::array<double, renderer::kBlockSize>, 3> of_pixels;
    for (size_t v = 0; v < 3; ++v) {
      for (size_t i = 0; i < weights[v].size(); ++i) {
        L::store(weights[v][i], of_pixels[v].data() + i * L::kWidth);
      }
    }
    for (; row != 0; row &= row - 1) {
      const auto i = static_cast<size_t>(std::countr_zero(row));
      plane[i] = renderer::interpolate(value0, value1, value2, {of_pixels[0][i], of_pixels[1][i], of_pixels[2][i]});
    }
  }

  // What a fragment's values come from; only what a varying uses is filled in.
  struct Inputs {
    std::array<renderer::PixelWeights, 3> weights;  // for each kind of sampling
    std::array<float, 4> frag_coord{};
    std::array<float, 2> point_coord{};
  };

  // Calls visit(index of the sample in the planes) for each bit of `samples`.
  template <typename Visit>
  void for_each_sample(size_t pixel, uint32_t samples, const Visit& visit) const {
    for (; samples != 0; samples &= samples - 1) {
      visit(pixel * samples_ + static_cast<size_t>(std::countr_zero(samples)));
    }
  }

  [[nodiscard]] Inputs inputs_of(const renderer::Fragment& fragment) const {
    Inputs inputs;
    inputs.weights[static_cast<size_t>(Sampling::kCenter)] = fragment.weights();
    if (has_centroid_) {
      inputs.weights[static_cast<size_t>(Sampling::kCentroid)] = fragment.weights(fragment.centroid);
    }
    if (has_sample_) {
      inputs.weights[static_cast<size_t>(Sampling::kSample)] = fragment.weights(fragment.position);
    }
    if (has_frag_coord_) {
      inputs.frag_coord = fragment.frag_coord();
    }
    if (has_point_coord_) {
      inputs.point_coord = fragment.point_coord();
    }
    return inputs;
  }

  [[nodiscard]] static float value_of(const Component& component, const PrimitiveData& data, const Inputs& inputs) {
    const uint32_t i = component.index;
    if (component.source == VaryingSource::kFragCoord) {
      return inputs.frag_coord[i];
    }
    if (component.source == VaryingSource::kPointCoord) {
      return inputs.point_coord[i];
    }
    const auto& [value0, value1, value2] = data.components;
    if (component.interpolation == Interpolation::kFlat) {
      return value0[i];
    }
    const auto& [smooth, noperspective] = inputs.weights[static_cast<size_t>(component.sampling)];
    const bool is_smooth = component.interpolation == Interpolation::kSmooth;
    return renderer::interpolate(value0[i], value1[i], value2[i], is_smooth ? smooth : noperspective);
  }

  const Draw* draw_;
  uint32_t first_primitive_;
  size_t width_;
  size_t samples_;
  uint32_t* hits_;
  uint32_t* owner_;
  uint32_t* front_facing_;
  std::array<Component, size_t{kMaxVaryings} * kMaxVaryingComponents> components_;
  uint32_t component_count_ = 0;
  uint32_t vertex_component_count_ = 0;
  // Flat components come first, smooth ones next.
  uint32_t flat_end_ = 0;
  uint32_t smooth_end_ = 0;
  bool is_plain_ = true;
  bool has_frag_coord_ = false;
  bool has_point_coord_ = false;
  bool has_centroid_ = false;
  bool has_sample_ = false;
};

// What the renderer can draw with this program.
FeatureSet renderer_features();

// Draws a whole case with the renderer. An error names what the renderer cannot draw, or what is inconsistent in the
// case.
Result<Planes> draw_case(const Case& drawn_case, const renderer::Options& options);

}  // namespace fillrule::programs
