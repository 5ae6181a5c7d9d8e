// What comes out of a drawing: the output contract that every party fulfils, so that all of them can be compared.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fillrule {

// The value of `owner` where nothing landed.
inline constexpr uint32_t kNoOwner = 0xFFFFFFFFU;

// One value for each sample, row by row from the top left, the samples of a pixel side by side:
// index = (y * width + x) * samples + sample.
//
// A fragment *lands* when it is inside viewport, scissor and target and passes the depth test. Where nothing landed,
// owner is kNoOwner, depth is the target's clear value and everything else is 0.
struct Planes {
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t samples = 1;

  std::vector<uint32_t> hits;          // how many fragments landed; coverage is hits != 0
  std::vector<uint32_t> owner;         // the primitive that landed last, counted over all draws of the case from 0
  std::vector<uint32_t> front_facing;  // 1 if that primitive is front-facing
  std::vector<float> depth;            // the depth attachment: window space, [0, 1]; empty without one
  // One plane for each component of each varying, in the order of declaration: the values of the fragment that
  // landed last, unquantised.
  std::vector<std::vector<float>> varyings;

  // Every plane at its cleared state.
  static Planes cleared(uint32_t width, uint32_t height, uint32_t samples, uint32_t components, float clear_depth) {
    const size_t size = size_t{width} * height * samples;
    Planes planes{.width = width, .height = height, .samples = samples};
    planes.hits.assign(size, 0);
    planes.owner.assign(size, kNoOwner);
    planes.front_facing.assign(size, 0);
    planes.depth.assign(size, clear_depth);
    planes.varyings.resize(components);
    for (std::vector<float>& plane : planes.varyings) plane.resize(size);
    return planes;
  }
};

}  // namespace fillrule
