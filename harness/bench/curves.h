// How cost grows: one quantity of a scene varied, all else equal.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "harness/bench/scene.h"

namespace fillrule::bench {

struct CurvePoint {
  std::string name;      // "triangles=1000"
  double work = 0;       // triangles or pixels that the scene has
  uint32_t threads = 0;  // 0: as asked for
  std::function<Scene()> make;
};

struct Curve {
  std::string name;
  std::string unit;  // of work
  std::vector<CurvePoint> points;
};

// Triangles from 1,000 to 4,000,000, their size from 0.5 to 10,000 px, threads from 1 to `threads`, targets from 64
// to 4096 px.
std::vector<Curve> scaling_curves(uint32_t threads);

}  // namespace fillrule::bench
