// A scene around a model of somebody's own, for a quick look at it.
#pragma once

#include <string>

#include "cases/model/case.h"
#include "cases/model/result.h"
#include "harness/scene/assets.h"

namespace fillrule::scene {

// The model of an OBJ file in the middle of a target of 512 x 512 pixels, seen from the front, above and the right,
// whole, lit from behind the viewer's left shoulder. Its case has to be built.
Result<Case> scene_of_model(const std::string& path, Assets& assets);

}  // namespace fillrule::scene
