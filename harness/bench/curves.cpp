#include "harness/bench/curves.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/bench/workloads.h"

namespace fillrule::bench {
namespace {

constexpr uint32_t kSize = 1024;

Curve triangles_curve() {
  Curve curve{.name = "triangles of a watertight grid", .unit = "triangles"};
  for (const uint32_t count : {1'000U, 10'000U, 100'000U, 1'000'000U, 4'000'000U}) {
    curve.points.push_back({.name = fmt::format("triangles={}", count), .work = count * 1.0, .make = [count] {
                              return grid_scene(count, kSize);
                            }});
  }
  return curve;
}

Curve area_curve() {
  Curve curve{.name = "area of random triangles", .unit = "triangles"};
  for (const double area : {0.5, 2.0, 10.0, 50.0, 200.0, 1'000.0, 10'000.0}) {
    // Ten layers of the target, but not more triangles than in `mid`.
    const auto count = static_cast<uint32_t>(std::min(100'000.0, 10.0 * kSize * kSize / area));
    curve.points.push_back({.name = fmt::format("px={}", area), .work = count * 1.0, .make = [count, area] {
                              return random_triangles_scene(count, area, kSize);
                            }});
  }
  return curve;
}

Curve threads_curve(uint32_t threads) {
  Curve curve{.name = "threads, filling", .unit = "pixels"};
  for (uint32_t count = 1; count <= threads; ++count) {
    curve.points.push_back(
        {.name = fmt::format("threads={}", count), .work = 16.0 * kSize * kSize, .threads = count, .make = [] {
           return fill_scene(16, kSize);
         }});
  }
  return curve;
}

Curve target_curve() {
  Curve curve{.name = "width of the target, filling", .unit = "pixels"};
  for (uint32_t size = 64; size <= 4096; size *= 2) {
    curve.points.push_back({.name = fmt::format("target={}", size), .work = 16.0 * size * size, .make = [size] {
                              return fill_scene(16, size);
                            }});
  }
  return curve;
}

}  // namespace

std::vector<Curve> scaling_curves(uint32_t threads) {
  return {triangles_curve(), area_curve(), threads_curve(threads), target_curve()};
}

}  // namespace fillrule::bench
