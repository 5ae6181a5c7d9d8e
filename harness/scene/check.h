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

// What is known of a case before its colours are judged.
struct KnownCase {
  const judge::Oracle* oracle = nullptr;  // for the parties' subpixel bits
  const Planes* faultless = nullptr;      // what the candidate drew of it, if no sample of that is at fault
};

struct SceneVerdict {
  ColorVerdict colors;
  judge::CaseVerdict planes;  // empty where the candidate's are to the bit those of the faultless picture
};

// What is judged below, drawn by one party.
Result<Planes> paint_scene(const Case& built, Assets& assets, const Painter& paint);

// `reference` may be null. Errors: what cannot be drawn, or not be judged.
Result<SceneVerdict> judge_scene(const Case& built, Assets& assets, const PaintingParty& candidate,
                                 const PaintingParty* reference, const KnownCase& known = {});

// The same as one check of the case, named "scene_colors": failed if the candidate is at fault or a party cannot draw
// it. Errors: what neither party is to blame for, an image that cannot be read or a scene that cannot be judged.
Result<judge::CheckResult> check_scene(const Case& built, Assets& assets, const PaintingParty& candidate,
                                       const PaintingParty* reference, const KnownCase& known = {});

}  // namespace fillrule::scene
