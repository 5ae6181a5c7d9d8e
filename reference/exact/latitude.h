// How far an implementation may move the boundary of a primitive: the latitude that the Vulkan specification leaves
// by not saying how framebuffer coordinates are rounded (chapter "Rasterization", subPixelPrecisionBits).
//
// Derivation. Let s = 2^-subpixel_bits pixels. Rounding to nearest moves a vertex by at most s/2 in x and in y, and
// the float32 arithmetic before it by a little more. Computing fma(X * (1/w), W/2, c) rounds 1/w, the product and the
// sum once each, and c = x0 + W/2 once: four roundings of numbers whose share of the result is at most extent =
// max(|x0|, |x0 + W|), so 4 * 2^-24 * extent. With t_x, t_y the sums of both, each vertex v moves to v + d, d inside
// the box B = [-t_x, t_x] x [-t_y, t_y]. For a convex polygon P and P' the hull of its moved vertices:
//   - p is in no P' unless it is in the Minkowski sum P + B. Every point of P' is a convex combination of moved
//     vertices, hence a point of P plus a convex combination of displacements, which lies in B.
//   - p is in every P' if p + B lies in P. Else a direction n separates p from some P': n.p > max n.(v + d)
//     >= h_P(n) - h_B(n), with h the support functions; but p + B in P says n.p + h_B(n) <= h_P(n).
// Both sets are cut out by half-planes: for an edge with normal (a, b) the boundary moves by t_x |a| + t_y |b| (times
// the length of the normal), and the sum has the polygon's bounding box, grown by t_x and t_y, besides.
// Between the two sets a sample may be covered; outside of both the specification decides.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>

namespace fillrule::exact {

// In pixels: how far a vertex may be from its exact place in the framebuffer.
struct Latitude {
  double x = 0;
  double y = 0;
};

Latitude latitude_of(const VkViewport& viewport, uint32_t subpixel_bits);

}  // namespace fillrule::exact
