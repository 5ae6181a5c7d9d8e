#include "harness/scene/check.h"

#include <fmt/format.h>

#include <optional>

#include "harness/scene/build.h"
#include "harness/scene/transform_error.h"

namespace fillrule::scene {
namespace {

// The colours are no varyings of the case.
Planes without_colors(const Planes& planes) {
  Planes rest = planes;
  rest.varyings.clear();
  return rest;
}

// What the parties draw, and by how much they may be off.
struct Subject {
  Case drawn;
  programs::CaseShading shading;
  uint32_t bits_less = 0;  // that coverage is judged with
  TransformError error;
};

Result<Subject> subject_of(const Case& built, Assets& assets, uint32_t subpixel_bits) {
  const bool transforms = built.scene->transform_on == TransformOn::kBoth;
  Result<programs::CaseShading> shading = shading_of(built, assets, transforms);
  if (!shading) return tl::unexpected(shading.error());
  if (!transforms) return Subject{.drawn = built, .shading = std::move(*shading)};
  Result<Case> object = object_case(built, assets);
  if (!object) return tl::unexpected(object.error());
  const Result<TransformError> error = transform_error(*object, *shading, subpixel_bits);
  if (!error) return tl::unexpected(error.error());
  return Subject{.drawn = std::move(*object), .shading = std::move(*shading), .bits_less = 1, .error = *error};
}

std::string outside_in_words(const PartyColors& colors) {
  return fmt::format("{} of {} samples have a colour that their varyings do not explain; first {}", colors.outside,
                     colors.judged, colors.first);
}

}  // namespace

Result<SceneVerdict> judge_scene(const Case& built, Assets& assets, const PaintingParty& candidate,
                                 const PaintingParty* reference) {
  if (!built.scene) return failure("a case without a scene");
  const Result<Subject> subject = subject_of(built, assets, candidate.subpixel_bits);
  if (!subject) return tl::unexpected(subject.error());
  const Result<Planes> candidate_planes = candidate.paint(subject->drawn, subject->shading);
  if (!candidate_planes) return tl::unexpected(candidate_planes.error());
  std::optional<Result<Planes>> reference_planes;
  if (reference != nullptr) {
    reference_planes = reference->paint(subject->drawn, subject->shading);
    if (!*reference_planes) return tl::unexpected(reference_planes->error());
  }

  SceneVerdict verdict;
  const ColorParty candidate_party{&*candidate_planes, candidate.subpixel_bits - subject->bits_less};
  std::optional<ColorParty> reference_party;
  if (reference != nullptr) {
    reference_party = ColorParty{&**reference_planes, reference->subpixel_bits - subject->bits_less};
  }
  verdict.colors = judge_colors(built, subject->shading, candidate_party,
                                reference_party ? &*reference_party : nullptr, subject->error);

  Case geometry = built;
  geometry.varyings.clear();
  for (Draw& draw : geometry.draws) draw.varyings.clear();
  const Planes candidate_geometry = without_colors(*candidate_planes);
  const judge::Party judged{.planes = &candidate_geometry, .subpixel_bits = candidate_party.subpixel_bits};
  if (reference == nullptr) {
    verdict.planes = judge::judge(geometry, judged, nullptr, {});
    return verdict;
  }
  const Planes reference_geometry = without_colors(**reference_planes);
  const judge::Party against{.planes = &reference_geometry, .subpixel_bits = reference_party->subpixel_bits};
  verdict.planes = judge::judge(geometry, judged, &against, {});
  return verdict;
}

judge::CheckResult check_scene(const Case& built, Assets& assets, const PaintingParty& candidate,
                               const PaintingParty* reference) {
  judge::CheckResult result{.name = "scene_colors"};
  const Result<SceneVerdict> verdict = judge_scene(built, assets, candidate, reference);
  if (!verdict) {
    result.outcome = judge::CheckResult::Outcome::kFailed;
    result.message = to_string(verdict.error());
    return result;
  }
  const ColorVerdict& colors = verdict->colors;
  result.outcome = judge::CheckResult::Outcome::kFailed;
  if (colors.candidate.outside > 0) {
    result.message = outside_in_words(colors.candidate);
  } else if (verdict->planes.candidate_faults() > 0) {
    result.message =
        fmt::format("{} samples of the coloured picture are at fault in coverage, owner, facing or depth",
                    verdict->planes.candidate_faults());
  } else if (!colors.alike() && colors.reference.outside == 0) {
    result.message =
        fmt::format("{} of {} samples differ from the reference's by more than 2/255", colors.apart, colors.compared);
  } else {
    result.outcome = judge::CheckResult::Outcome::kPassed;
    if (colors.reference.outside > 0) result.message = "reference fault: " + outside_in_words(colors.reference);
  }
  return result;
}

}  // namespace fillrule::scene
