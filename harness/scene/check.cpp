#include "harness/scene/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
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

bool transforms(const Case& built) {
  return built.scene->transform_on == TransformOn::kBoth;
}

// What the parties draw.
struct Subject {
  Case drawn;
  programs::CaseShading shading;
  // What everything is judged with, where the vertex stages transform.
  TransformError error;
  uint32_t bits_less = 0;  // subpixel bits
};

Result<Subject> subject_of(const Case& built, Assets& assets) {
  if (!built.scene) return failure("a case without a scene");
  Result<programs::CaseShading> shading = shading_of(built, assets, transforms(built));
  if (!shading) return tl::unexpected(shading.error());
  if (!transforms(built)) return Subject{.drawn = built, .shading = std::move(*shading)};
  Result<Case> object = object_case(built, assets);
  if (!object) return tl::unexpected(object.error());
  return Subject{.drawn = std::move(*object), .shading = std::move(*shading)};
}

// The same with the latitude to judge it with.
Result<Subject> judged_subject(const Case& built, Assets& assets, uint32_t subpixel_bits) {
  Result<Subject> subject = subject_of(built, assets);
  if (!subject || !transforms(built)) return subject;
  const Result<TransformError> error = transform_error(subject->drawn, subject->shading, subpixel_bits);
  if (!error) return tl::unexpected(error.error());
  subject->error = *error;
  subject->bits_less = 1;
  return subject;
}

// Everything but the colours.
judge::CaseVerdict judge_geometry(const Case& built, const judge::Oracle& oracle, const ColorParty& candidate,
                                  const ColorParty* reference) {
  Case geometry = built;
  geometry.varyings.clear();
  for (Draw& draw : geometry.draws) draw.varyings.clear();
  const Planes candidate_geometry = without_colors(*candidate.planes);
  const judge::Party judged{.planes = &candidate_geometry, .subpixel_bits = candidate.subpixel_bits};
  if (reference == nullptr) return judge::judge(geometry, oracle, judged, nullptr, {});
  const Planes reference_geometry = without_colors(*reference->planes);
  const judge::Party against{.planes = &reference_geometry, .subpixel_bits = reference->subpixel_bits};
  return judge::judge(geometry, oracle, judged, &against, {});
}

// To the bit.
bool has_same_geometry(const Planes& a, const Planes& b) {
  const auto same_bits = [](float x, float y) { return std::bit_cast<uint32_t>(x) == std::bit_cast<uint32_t>(y); };
  return a.hits == b.hits && a.owner == b.owner && a.front_facing == b.front_facing &&
         std::ranges::equal(a.depth, b.depth, same_bits);
}

std::string outside_in_words(const PartyColors& colors) {
  return fmt::format("{} of {} samples have a colour that their varyings do not explain; first {}", colors.outside,
                     colors.judged, colors.first);
}

// Errors: what a party cannot draw.
Result<SceneVerdict> judge_subject(const Case& built, const Subject& subject, const PaintingParty& candidate,
                                   const PaintingParty* reference, const KnownCase& known) {
  const Result<Planes> candidate_planes = candidate.paint(subject.drawn, subject.shading);
  if (!candidate_planes) return tl::unexpected(candidate_planes.error());
  std::optional<Result<Planes>> reference_planes;
  std::optional<ColorParty> reference_party;
  if (reference != nullptr) {
    reference_planes = reference->paint(subject.drawn, subject.shading);
    if (!*reference_planes) return tl::unexpected(reference_planes->error());
    reference_party = ColorParty{&**reference_planes, reference->subpixel_bits - subject.bits_less};
  }
  const ColorParty candidate_party{&*candidate_planes, candidate.subpixel_bits - subject.bits_less};
  const judge::Oracle* oracle = known.oracle;
  std::optional<judge::Oracle> own_oracle;
  if (oracle == nullptr || subject.bits_less > 0) {
    own_oracle.emplace(built, candidate_party.subpixel_bits,
                       reference_party ? std::optional(reference_party->subpixel_bits) : std::nullopt);
    oracle = &*own_oracle;
  }
  const ColorParty* const against = reference_party ? &*reference_party : nullptr;
  SceneVerdict verdict{.colors =
                           judge_colors(built, subject.shading, *oracle, candidate_party, against, subject.error)};
  const bool is_known =
      known.faultless != nullptr && subject.bits_less == 0 && has_same_geometry(*known.faultless, *candidate_planes);
  if (!is_known) verdict.planes = judge_geometry(built, *oracle, candidate_party, against);
  return verdict;
}

judge::CheckResult check_of(const Result<SceneVerdict>& verdict) {
  judge::CheckResult result{.name = "scene_colors", .outcome = judge::CheckResult::Outcome::kFailed};
  if (!verdict) {
    result.message = to_string(verdict.error());
    return result;
  }
  const ColorVerdict& colors = verdict->colors;
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

}  // namespace

Result<Planes> paint_scene(const Case& built, Assets& assets, const Painter& paint) {
  const Result<Subject> subject = subject_of(built, assets);
  if (!subject) return tl::unexpected(subject.error());
  return paint(subject->drawn, subject->shading);
}

Result<SceneVerdict> judge_scene(const Case& built, Assets& assets, const PaintingParty& candidate,
                                 const PaintingParty* reference, const KnownCase& known) {
  const Result<Subject> subject = judged_subject(built, assets, candidate.subpixel_bits);
  if (!subject) return tl::unexpected(subject.error());
  return judge_subject(built, *subject, candidate, reference, known);
}

Result<judge::CheckResult> check_scene(const Case& built, Assets& assets, const PaintingParty& candidate,
                                       const PaintingParty* reference, const KnownCase& known) {
  const Result<Subject> subject = judged_subject(built, assets, candidate.subpixel_bits);
  if (!subject) return tl::unexpected(subject.error());
  return check_of(judge_subject(built, *subject, candidate, reference, known));
}

}  // namespace fillrule::scene
