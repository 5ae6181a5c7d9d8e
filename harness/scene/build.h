// From a scene to what is drawn.
//
// The geometry is transformed on the host once, in double, and rounded to clip-space floats: what comes out is a case
// like any other, whose coverage, depth and varyings the oracle judges. Its varyings are the position and the normal
// in the world and the texture coordinates, so that colours are a function of them.
#pragma once

#include <string>
#include <vector>

#include "cases/format/suite.h"
#include "cases/model/case.h"
#include "cases/model/result.h"
#include "harness/programs/shading.h"
#include "harness/scene/assets.h"

namespace fillrule::scene {

// The case with its draws and varyings made from its scene, which must be there; as they are seen by the scene's
// camera.
Result<Case> build(const Case& scene_case, Assets& assets);

// Builds every scene of the suite in place. One that cannot be built is taken out, with an error.
void build_scenes(format::Suite& suite, Assets& assets);

// format::load_suite(), with every scene built.
format::Suite load_suite(const std::string& root, const std::vector<std::string>& selectors,
                         const format::Preview& preview = {});

// What a built case's draws are shaded with; with `transforms` the vertex stage applies the matrices (object_case()).
Result<programs::CaseShading> shading_of(const Case& built, Assets& assets, bool transforms = false);

// The built case with positions and normals of object space instead, for a vertex stage that transforms. No party but
// the program `shaded` can make anything of it.
Result<Case> object_case(const Case& built, Assets& assets);

}  // namespace fillrule::scene
