#include "harness/report/coverage_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

#include "harness/run/counted.h"

namespace fillrule::report {
namespace {

using explain::Boundary;
using explain::PrimitiveFacts;
using OracleCoverage = judge::OracleAnswer::Coverage;

// Where the sample of a pixel would have to be looked for in the party's picture.
struct Displacement {
  std::string_view text;
  std::function<std::pair<int64_t, int64_t>(int64_t x, int64_t y)> source;
};

std::vector<Displacement> displacements(int64_t width, int64_t height) {
  std::vector<Displacement> all;
  const auto shift = [&all](std::string_view text, int64_t dx, int64_t dy) {
    all.push_back({text, [dx, dy](int64_t x, int64_t y) { return std::pair(x + dx, y + dy); }});
  };
  shift("as if the picture were shifted by a pixel to the right", 1, 0);
  shift("as if the picture were shifted by a pixel to the left", -1, 0);
  shift("as if the picture were shifted down by a pixel", 0, 1);
  shift("as if the picture were shifted up by a pixel", 0, -1);
  shift("as if the picture were shifted by a pixel to the right and down", 1, 1);
  shift("as if the picture were shifted by a pixel to the left and up", -1, -1);
  all.push_back({"as if the picture were upside down",
                 [height](int64_t x, int64_t y) { return std::pair(x, height - 1 - y); }});
  all.push_back(
      {"as if left and right were exchanged", [width](int64_t x, int64_t y) { return std::pair(width - 1 - x, y); }});
  return all;
}

// True if the party's owners, looked up there, are right at every sample that can be looked up.
bool right_elsewhere(const Planes& party, const judge::CaseVerdict& verdict, const Displacement& displacement) {
  bool any = false;
  for (uint32_t y = 0; y < party.height; ++y) {
    for (uint32_t x = 0; x < party.width; ++x) {
      const auto [from_x, from_y] = displacement.source(x, y);
      if (from_x < 0 || from_y < 0 || from_x >= party.width || from_y >= party.height) continue;
      const size_t from = (static_cast<size_t>(from_y) * party.width + static_cast<size_t>(from_x)) * party.samples;
      const size_t to = (size_t{y} * party.width + x) * party.samples;
      for (size_t s = 0; s < party.samples; ++s) {
        const judge::OracleAnswer& right = verdict.oracle[to + s];
        const bool is_open = right.coverage == OracleCoverage::kMay || right.coverage == OracleCoverage::kUndefined;
        if (is_open || !right.owner) continue;
        if (party.owner[from + s] != *right.owner) return false;
        any = any || *right.owner != kNoOwner;
      }
    }
  }
  return any;
}

std::string list_of(const std::set<uint32_t>& numbers) {
  constexpr size_t kMost = 4;
  std::string text;
  size_t count = 0;
  for (const uint32_t number : numbers) {
    if (count++ == kMost) return text + fmt::format(" and {} more", numbers.size() - kMost);
    text += fmt::format("{}{}", count == 1 ? "" : ", ", number);
  }
  return text;
}

std::string primitives_are(const std::set<uint32_t>& numbers, std::string_view what) {
  return numbers.size() == 1 ? fmt::format("primitive {} is {}", *numbers.begin(), what)
                             : fmt::format("primitives {} are {}", list_of(numbers), what);
}

// Those that are to be seen, of which the party shows nothing; empty if other samples are missing too.
std::set<uint32_t> lost_primitives(const Planes& party, const judge::CaseVerdict& verdict,
                                   std::span<const SampleMark> marks) {
  std::set<uint32_t> lost;
  for (size_t i = 0; i < marks.size(); ++i) {
    if (marks[i].kind != SampleClass::kMissing) continue;
    if (!verdict.oracle[i].owner) return {};
    lost.insert(*verdict.oracle[i].owner);
  }
  for (const uint32_t owner : party.owner) {
    if (lost.contains(owner)) return {};
  }
  return lost;
}

bool is_culled(const PrimitiveFacts& primitive) {
  return primitive.exclusion == explain::Exclusion::kCulledByFacing ||
         primitive.exclusion == explain::Exclusion::kCulledByDistances;
}

// What is known of one missing or extra sample.
struct Seen {
  SampleClass fault = SampleClass::kRight;
  const PrimitiveFacts* primitive = nullptr;  // that is missing or too much there
  const Boundary* boundary = nullptr;         // the one that decides
  double distance = 0;                        // pixels
};

constexpr std::string_view kOnEdges =
    "all that were looked into lie exactly on an edge, where the top-left rule decides";

class Pattern {
 public:
  Pattern(const Case& test_case, const run::Drawing& drawing, bool of_reference, std::span<const SampleMark> marks,
          std::span<const explain::Explanation> explanations)
      : case_(test_case),
        drawing_(drawing),
        of_reference_(of_reference),
        party_(of_reference ? *drawing.reference : drawing.candidate),
        verdict_(drawing.verdict),
        marks_(marks) {
    for (const explain::Explanation& one : explanations) look_into(one, of_reference ? 1 : 0);
  }

  [[nodiscard]] std::string text() const {
    const bool missing = std::ranges::find(marks_, SampleClass::kMissing, &SampleMark::kind) != marks_.end();
    const bool extra = std::ranges::find(marks_, SampleClass::kExtra, &SampleMark::kind) != marks_.end();
    if (missing && std::ranges::all_of(party_.hits, [](uint32_t hits) { return hits == 0; })) {
      return "it draws nothing at all";
    }
    const std::set<uint32_t> lost = missing ? lost_primitives(party_, verdict_, marks_) : std::set<uint32_t>{};
    const std::set<uint32_t> culled = culled_ones();
    if (!lost.empty() && !culled.empty()) {
      return fmt::format("{}, and {}: culling the wrong way round", primitives_are(lost, "lost as a whole"),
                         primitives_are(culled, "drawn though culled"));
    }
    if (!culled.empty()) return primitives_are(culled, "drawn though culled");
    // A picture of upright edges may be right a pixel further, too; but then its values are wrong as well.
    if (coverage_alone() && all_on_edges()) return std::string(kOnEdges);
    if (std::string text = displacement_of(drawing_, of_reference_); !text.empty()) return text;
    if (!lost.empty() && !extra) {
      return fmt::format("{}, as by culling, clipping or a limit", primitives_are(lost, "lost as a whole"));
    }
    return boundary_text();
  }

 private:
  void look_into(const explain::Explanation& one, size_t side) {
    if (one.parties.size() <= side) return;
    const explain::PartyFacts& facts = one.parties[side];
    const explain::View& view = one.views[facts.view];
    const size_t index =
        (size_t{one.y} * case_.target.width + one.x) * static_cast<size_t>(case_.target.samples) + one.sample;
    Seen seen{.fault = marks_[index].kind};
    if (seen.fault != SampleClass::kMissing && seen.fault != SampleClass::kExtra) return;
    const uint32_t number =
        seen.fault == SampleClass::kExtra ? facts.owner : verdict_.oracle[index].owner.value_or(kNoOwner);
    const auto found = std::ranges::find(view.primitives, number, &PrimitiveFacts::number);
    if (found != view.primitives.end()) {
      seen.primitive = &*found;
      seen.boundary = found->deciding();
      if (seen.boundary != nullptr) {
        seen.distance = std::ldexp(std::abs(seen.boundary->distance), -static_cast<int>(view.subpixel_bits));
      }
    }
    seen_.push_back(seen);
  }

  // Of every extra sample.
  [[nodiscard]] std::set<uint32_t> culled_ones() const {
    std::set<uint32_t> culled;
    for (const Seen& seen : seen_) {
      if (seen.fault != SampleClass::kExtra) continue;
      if (seen.primitive == nullptr || !is_culled(*seen.primitive)) return {};
      culled.insert(seen.primitive->number);
    }
    return culled;
  }

  template <typename Holds>
  [[nodiscard]] bool all(const Holds& holds) const {
    return std::ranges::all_of(seen_, holds);
  }

  [[nodiscard]] bool all_on_edges() const {
    return !seen_.empty() &&
           all([](const Seen& seen) { return seen.boundary != nullptr && seen.boundary->value == 0; });
  }

  // No sample that is covered as it should be has a wrong value.
  [[nodiscard]] bool coverage_alone() const {
    return std::ranges::none_of(marks_, [](const SampleMark& mark) {
      return mark.kind > SampleClass::kImprecise && mark.kind < SampleClass::kExtra;
    });
  }

  [[nodiscard]] std::string boundary_text() const {
    if (seen_.empty()) return "";
    if (all([](const Seen& seen) {
          return seen.primitive != nullptr && seen.primitive->exclusion == explain::Exclusion::kScissored;
        })) {
      return "all that were looked into lie outside of the scissor";
    }
    if (all([this](const Seen& seen) { return fails_depth_test(seen); })) {
      return "the primitives that cover them fail the depth test or the depth bounds";
    }
    if (!all([](const Seen& seen) { return seen.boundary != nullptr; })) return "";
    constexpr std::array<std::pair<Boundary::Kind, std::string_view>, 5> kPlanes{
        {{Boundary::Kind::kNear, "the near plane"},
         {Boundary::Kind::kFar, "the far plane"},
         {Boundary::Kind::kClipDistance, "a user clip plane"},
         {Boundary::Kind::kScissor, "the scissor"},
         {Boundary::Kind::kViewport, "the viewport"}}};
    for (const auto& [kind, name] : kPlanes) {
      if (all([kind = kind](const Seen& seen) {
            return seen.boundary->kind == kind && seen.boundary->distance < 0;
          })) {
        return fmt::format("all that were looked into lie beyond {}", name);
      }
    }
    if (all_on_edges()) return std::string(kOnEdges);
    const double furthest = std::ranges::max_element(seen_, {}, &Seen::distance)->distance;
    if (furthest > 1) return "";
    return fmt::format("all that were looked into lie within {:.2g} pixels of an edge, which points to {}", furthest,
                       what_moves_edges());
  }

  // Something else must be why it is not to be seen, and nothing but depth is left.
  [[nodiscard]] bool fails_depth_test(const Seen& seen) const {
    if (seen.fault != SampleClass::kExtra || seen.primitive == nullptr) return false;
    const RasterState& state = case_.draws[seen.primitive->draw].state;
    return seen.primitive->answer == exact::Coverage::kMust && (state.depth_test || state.depth_bounds);
  }

  [[nodiscard]] std::string_view what_moves_edges() const {
    const auto all_are = [this](exact::Piece::Kind kind) {
      return all([kind](const Seen& seen) { return seen.primitive->kind == kind; });
    };
    if (all_are(exact::Piece::Kind::kPoint)) return "the size of the points, or the place of the samples";
    if (all_are(exact::Piece::Kind::kLine)) return "the width or the ends of the lines, or the place of the samples";
    return "snapping, the place of the samples or the fill rule";
  }

  const Case& case_;
  const run::Drawing& drawing_;
  bool of_reference_;
  const Planes& party_;
  const judge::CaseVerdict& verdict_;
  std::span<const SampleMark> marks_;
  std::vector<Seen> seen_;
};

}  // namespace

std::string coverage_pattern(const Case& test_case, const run::Drawing& drawing, bool of_reference,
                             std::span<const SampleMark> marks, std::span<const explain::Explanation> explanations) {
  return Pattern(test_case, drawing, of_reference, marks, explanations).text();
}

std::string displacement_of(const run::Drawing& drawing, bool of_reference) {
  const Planes& party = of_reference ? *drawing.reference : drawing.candidate;
  for (const Displacement& one : displacements(party.width, party.height)) {
    if (right_elsewhere(party, drawing.verdict, one)) return std::string(one.text);
  }
  return "";
}

}  // namespace fillrule::report
