#include "harness/view/parties.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "harness/programs/shaded.h"
#include "harness/report/names.h"
#include "harness/scene/painters.h"
#include "harness/terminal/worst.h"

namespace fillrule::view {
namespace {

glm::vec3 background_of(const Case& built) {
  const Color& color = built.scene->background;
  return {color[0], color[1], color[2]};
}

Result<void> paint(const scene::Painter& painter, const Drawable& drawable, Image& image) {
  const Result<Planes> planes = painter(drawable.built, drawable.shading);
  if (!planes) return tl::unexpected(planes.error());
  image = image_of(scene::picture_of(*planes, drawable.built.scene->background));
  return {};
}

// The renderer's colours and nothing else.
Draws fast_draws(const renderer::Options& options) {
  const auto target = std::make_shared<programs::ColorTarget>();
  return [options, target](const Drawable& drawable, Image& image) -> Result<void> {
    auto drawn =
        programs::draw_colors(drawable.built, drawable.shading, background_of(drawable.built), options, *target);
    if (!drawn) return drawn;
    image.width = target->width;
    image.height = target->height;
    std::swap(image.rgba, target->rgba);
    return {};
  };
}

// Whichever party is at fault somewhere in the sample's planes.
std::pair<bool, bool> faults_at(const judge::CaseVerdict& verdict, size_t sample) {
  std::pair<bool, bool> faults;
  for (const judge::PlaneVerdict& plane : verdict.planes) {
    const judge::Verdict one = plane.map[sample];
    faults.first = faults.first || one == judge::Verdict::kCandidateFault || one == judge::Verdict::kBothFault;
    faults.second = faults.second || one == judge::Verdict::kReferenceFault || one == judge::Verdict::kBothFault;
  }
  return faults;
}

std::string text_of(const judge::PlaneVerdict& plane, const judge::SampleRecord& record) {
  return fmt::format("({}, {}) {}: {}, {}", record.x, record.y, terminal::component_name(plane, record),
                     report::name_of(record.verdict), terminal::values_text(plane, record));
}

// One for each pixel.
std::vector<Mismatch> mismatches_of(const judge::CaseVerdict& verdict) {
  std::vector<std::pair<judge::SampleRecord, const judge::PlaneVerdict*>> records;
  for (const judge::PlaneVerdict& plane : verdict.planes) {
    for (const judge::SampleRecord& record : plane.worst_samples) {
      if (record.verdict >= judge::Verdict::kReferenceFault) records.emplace_back(record, &plane);
    }
  }
  std::stable_sort(records.begin(), records.end(),
                   [](const auto& a, const auto& b) { return judge::graver(a.first, b.first); });
  std::vector<Mismatch> mismatches;
  for (const auto& [record, plane] : records) {
    const auto is_there = [x = record.x, y = record.y](const Mismatch& one) { return one.x == x && one.y == y; };
    if (std::any_of(mismatches.begin(), mismatches.end(), is_there)) continue;
    mismatches.push_back({.x = record.x, .y = record.y, .text = text_of(*plane, record)});
  }
  return mismatches;
}

}  // namespace

Result<Draws> candidate_draws(const run::RunOptions& options) {
  run::CandidateOptions candidate_options = options.candidate_options;
  candidate_options.driver_files = options.driver_files;
  Result<run::Candidate> candidate = run::make_candidate(options.candidate, candidate_options);
  if (!candidate) return tl::unexpected(candidate.error());
  Draws fast;
  if (options.candidate == "renderer") {
    fast = fast_draws({.subpixel_bits = candidate->subpixel_bits,
                       .threads = candidate_options.threads,
                       .isa = candidate_options.isa});
  }
  return [candidate = std::move(*candidate), fast](const Drawable& drawable, Image& image) -> Result<void> {
    const Case& built = drawable.built;
    if (built.scene) {
      if (fast && built.target.samples == VK_SAMPLE_COUNT_1_BIT) return fast(drawable, image);
      if (!candidate.paint) return failure(fmt::format("{} cannot draw in colour", candidate.name));
      return paint(candidate.paint, drawable, image);
    }
    if (auto can = candidate.check(built); !can) return can;
    const Result<Planes> planes = candidate.draw(built, 0);
    if (!planes) return tl::unexpected(planes.error());
    image = image_of(report::picture_of(built, *planes, report::range_of(*planes, nullptr)));
    return {};
  };
}

Draws reference_draws(const run::RunOptions& options) {
  const scene::Painter painter = scene::driver_painter_on_demand(
      {.driver = options.reference, .driver_files = options.driver_files, .validation = options.validation});
  return [painter](const Drawable& drawable, Image& image) { return paint(painter, drawable, image); };
}

Result<Judged> judge_view(run::SuiteRunner& runner, const Drawable& drawable) {
  const Result<run::Drawing> drawing = runner.draw(drawable.built);
  if (!drawing) return tl::unexpected(drawing.error());
  Judged judged{.version = drawable.version,
                .difference = image_of(report::difference_picture(drawable.built, drawing->verdict))};
  if (!drawable.built.scene) {
    const Planes* const reference = drawing->reference ? &*drawing->reference : nullptr;
    const report::ValueRange range = report::range_of(drawing->candidate, reference);
    judged.candidate = image_of(report::picture_of(drawable.built, drawing->candidate, range));
    if (reference != nullptr) judged.reference = image_of(report::picture_of(drawable.built, *reference, range));
  }
  for (size_t sample = 0; sample < drawing->verdict.samples; ++sample) {
    const auto [by_candidate, by_reference] = faults_at(drawing->verdict, sample);
    judged.candidate_faults += by_candidate ? 1 : 0;
    judged.reference_faults += by_reference ? 1 : 0;
  }
  judged.mismatches = mismatches_of(drawing->verdict);
  if (const auto& colors = drawing->scene_colors) {
    judged.colors = *colors ? (*colors)->message : to_string(colors->error());
  }
  return judged;
}

}  // namespace fillrule::view
