// A scene's colours as a check of its case: drawn by both parties with the program `shaded`, and judged.
//
// Coverage, owners, hits, facing and depth of these pictures are judged by the oracle as those of any case; the
// colours by judge_colors(). Where the scene says transform_on = "both", the vertex stages transform, and everything
// is judged with the latitude that transform_error.h derives.
#pragma once

#include "harness/judge/metamorphic.h"
#include "harness/scene/assets.h"
#include "harness/scene/color_judge.h"
#include "harness/scene/painters.h"

namespace fillrule::scene {

struct PaintingParty {
  Painter paint;
  uint32_t subpixel_bits = 8;
};

struct SceneVerdict {
  ColorVerdict colors;
  judge::CaseVerdict planes;
};

// What is judged below, drawn by one party.
Result<Planes> paint_scene(const Case& built, Assets& assets, const Painter& paint);

// `reference` may be null; `oracle` is that of the case for the parties' subpixel bits, if it has been made already.
// Errors: what cannot be drawn, or not be judged.
Result<SceneVerdict> judge_scene(const Case& built, Assets& assets, const PaintingParty& candidate,
                                 const PaintingParty* reference, const judge::Oracle* oracle = nullptr);

// The same as one check of the case, named "scene_colors": failed if the candidate is at fault.
judge::CheckResult check_scene(const Case& built, Assets& assets, const PaintingParty& candidate,
                               const PaintingParty* reference, const judge::Oracle* oracle = nullptr);

}  // namespace fillrule::scene
