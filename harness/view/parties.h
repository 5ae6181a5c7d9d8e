// Who draws what the window shows, and who judges it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/result.h"
#include "harness/programs/shading.h"
#include "harness/run/candidate.h"
#include "harness/run/suite_runner.h"
#include "harness/scene/assets.h"
#include "harness/view/image.h"

namespace fillrule::view {

// A view that is ready to be drawn.
struct Drawable {
  uint64_t version = 0;  // grows with each change of the view
  Case built;
  programs::CaseShading shading;  // of a scene
};

// Draws what is looked at: a scene's colours, or the planes of a case as colours (report/picture.h). Not for use by
// two threads at once.
using Draws = std::function<Result<void>(const Drawable&, Image&)>;

// The candidate; the renderer draws scenes without their planes, as fast as it can.
Result<Draws> candidate_draws(const run::RunOptions& options);
// A scene's colours by a driver, on a device of its own.
Draws reference_draws(const run::RunOptions& options);

// A sample that is wrong, the reference's or the candidate's.
struct Mismatch {
  uint32_t x = 0;  // pixels
  uint32_t y = 0;
  std::string text;
};

// A view as the judge sees it, by its planes and, of a scene, by its colours.
struct Judged {
  uint64_t version = 0;
  Image candidate;                 // of a case that is no scene: in colours of both parties' range
  std::optional<Image> reference;  // likewise
  Image difference;                // verdicts, as report/picture.h has them
  uint64_t candidate_faults = 0;   // samples
  uint64_t reference_faults = 0;
  std::vector<Mismatch> mismatches;  // the gravest, the worst first
  std::string colors;                // what is wrong with a scene's colours, in words
};
Result<Judged> judge_view(run::SuiteRunner& runner, const Drawable& drawable);

}  // namespace fillrule::view
