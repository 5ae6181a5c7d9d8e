// The workloads of `fillrule bench`, each a scene that is the same in every run.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "harness/bench/scene.h"

namespace fillrule::bench {

struct Workload {
  std::string name;
  std::string what;  // in a line
  std::function<Scene()> make;
};

const std::vector<Workload>& workloads();

// The families behind them, for scaling curves too.

// Full-screen quads back to front, w from 1 to 4.
Scene fill_scene(uint32_t quads, uint32_t target_size);
// Random triangles of one area.
Scene random_triangles_scene(uint32_t triangles, double area_pixels, uint32_t target_size);
// A watertight grid of quads, its inner vertices jittered.
Scene grid_scene(uint32_t triangles, uint32_t target_size);
// Random lines of one length.
Scene lines_scene(uint32_t lines, double length_pixels, uint32_t target_size);
// A torus with bumps, seen from outside.
Scene mesh_scene(uint32_t target_size);
// The camera within a tangle of triangles: most of them reach behind it.
Scene clip_scene(uint32_t triangles, uint32_t target_size);

}  // namespace fillrule::bench
