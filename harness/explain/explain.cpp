#include "harness/explain/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "harness/explain/internal.h"
#include "reference/exact/samples.h"

namespace fillrule::explain {
namespace {

using judge::Standing;

// Primitives further away than this do not matter to the sample.
constexpr double kNearPixels = 1;

// What is asked again and again for parties of the same subpixel bits.
struct Oracle {
  uint32_t subpixel_bits;
  exact::Expectation expectation;
  judge::ValueCache values;
  judge::Replay replay;

  Oracle(const Case& test_case, uint32_t bits, judge::Replay::Rules rules)
      : subpixel_bits(bits),
        expectation(test_case, bits),
        values(test_case, expectation),
        replay(test_case, expectation, values, bits, rules) {}
};

// Whether the sample is so far outside of the piece's bounds that it cannot matter.
bool is_far(const exact::Piece& piece, double x, double y) {
  const auto [left, top, right, bottom] = piece.shape->bounds(piece.latitude);
  return x < left - kNearPixels || y < top - kNearPixels || x > right + kNearPixels || y > bottom + kNearPixels;
}

// In units of the last place of the float32 next to `exact`.
double error_in_ulps(float value, double exact) {
  if (std::isnan(exact)) return 0;
  const auto rounded = static_cast<float>(exact);
  const double ulp =
      double{std::nextafter(std::abs(rounded), std::numeric_limits<float>::infinity())} - double{std::abs(rounded)};
  return std::abs(double{value} - exact) / ulp;
}

}  // namespace

class CaseExplainer::State {
 public:
  State(const Case& test_case, const NamedParty& candidate, const NamedParty* reference,
        const judge::Profile& profile, const judge::CaseVerdict& verdict)
      : case_(test_case), profile_(profile), verdict_(verdict) {
    sides_.push_back({.role = "candidate", .named = candidate});
    if (reference != nullptr) sides_.push_back({.role = "reference", .named = *reference});
  }

  Explanation at(const SampleId& sample) {
    result_ = {.case_name = case_.name, .x = sample.x, .y = sample.y, .sample = sample.sample, .position = {}};
    const auto samples = static_cast<size_t>(case_.target.samples);
    index_ = (size_t{sample.y} * case_.target.width + sample.x) * samples + sample.sample;
    const exact::Position position = exact::sample_place(case_.target, index_).position;
    result_.position = {position.x, position.y};
    for (Side& side : sides_) add_party(side);
    for (size_t view = 0; view < result_.views.size(); ++view) add_primitives(view);
    for (const judge::PlaneVerdict& plane : verdict_.planes) {
      result_.planes.push_back({.name = plane.name, .kind = plane.kind, .verdict = plane.map[index_]});
    }
    result_.reason = reason_of(result_);
    return std::move(result_);
  }

 private:
  struct Side {
    const char* role;
    NamedParty named;
    std::unique_ptr<judge::PartyJudge> judge;  // made on first need
  };

  // The oracle for so many subpixel bits, made on first need.
  Oracle& oracle_for(uint32_t subpixel_bits) {
    for (const auto& oracle : oracles_) {
      if (oracle->subpixel_bits == subpixel_bits) return *oracle;
    }
    // The profile binds the candidate alone, which comes first.
    judge::Replay::Rules rules;
    if (oracles_.empty()) rules = {.top_left = profile_.top_left, .diamond_exit = profile_.diamond_exit};
    oracles_.push_back(std::make_unique<Oracle>(case_, subpixel_bits, rules));
    return *oracles_.back();
  }

  // Views are in the order of the oracles.
  size_t view_for(uint32_t subpixel_bits) {
    for (size_t i = 0; i < result_.views.size(); ++i) {
      if (result_.views[i].subpixel_bits == subpixel_bits) return i;
    }
    Oracle& oracle = oracle_for(subpixel_bits);
    result_.views.push_back({.subpixel_bits = subpixel_bits, .primitives = {}, .possible = oracle.replay.at(index_)});
    return result_.views.size() - 1;
  }

  void add_party(Side& side) {
    const NamedParty& named = side.named;
    const Planes& planes = *named.party.planes;
    PartyFacts facts{.role = side.role,
                     .name = named.name,
                     .view = view_for(named.party.subpixel_bits),
                     .hits = planes.hits[index_],
                     .owner = planes.owner[index_],
                     .front_facing = planes.front_facing[index_] != 0};
    Oracle& oracle = *oracles_[facts.view];
    const judge::Possibilities& possible = result_.views[facts.view].possible;
    if (!side.judge) {
      side.judge = std::make_unique<judge::PartyJudge>(case_, planes, oracle.expectation, oracle.values);
    }
    const judge::PartyJudge& judged = *side.judge;
    if (!planes.depth.empty()) {
      add_value(facts, "depth", planes.depth[index_], judged.depth(possible, index_), depth_tolerance(facts));
    }
    uint32_t component = 0;
    for (const Varying& varying : case_.varyings) {
      for (uint32_t c = 0; c < varying.components; ++c, ++component) {
        const std::string name =
            varying.components == 1 ? varying.name : fmt::format("{}.{}", varying.name, "xyzw"[c]);
        add_value(facts, name, planes.varyings[component][index_], judged.varying(possible, index_, component),
                  varying.interpolation == Interpolation::kFlat ? std::nullopt : varying_tolerance(facts, component));
      }
    }
    result_.parties.push_back(std::move(facts));
  }

  static void add_value(PartyFacts& facts, const std::string& name, float value, Standing standing,
                        const std::optional<exact::Tolerance>& tolerance) {
    // The judge takes a smaller tolerance where that is enough.
    const bool judged = !std::isnan(standing.expected) && std::isfinite(standing.tolerance);
    if (judged && tolerance) {
      standing.tolerance = tolerance->total();
      standing.severity = std::abs(double{value} - standing.expected) / standing.tolerance;
    }
    facts.values.push_back({.name = name,
                            .value = value,
                            .standing = standing,
                            .tolerance = judged ? tolerance : std::nullopt,
                            .ulps = error_in_ulps(value, standing.expected)});
  }

  // The outcome that the party shows; null where it shows none of the right ones.
  [[nodiscard]] const judge::Outcome* outcome_of(const PartyFacts& facts) const {
    const auto& outcomes = result_.views[facts.view].possible.outcomes;
    const auto found = std::ranges::find(outcomes, facts.owner, &judge::Outcome::owner);
    return found == outcomes.end() ? nullptr : &*found;
  }

  [[nodiscard]] std::optional<exact::Tolerance> depth_tolerance(const PartyFacts& facts) {
    const judge::Outcome* const outcome = outcome_of(facts);
    if (outcome == nullptr || outcome->depth_writer == kNoOwner || !outcome->depth_certain) return std::nullopt;
    return oracles_[facts.view]
        ->values.values(outcome->depth_writer)
        .depth_tolerance(result_.position[0], result_.position[1]);
  }

  [[nodiscard]] std::optional<exact::Tolerance> varying_tolerance(const PartyFacts& facts, uint32_t component) {
    const judge::Outcome* const outcome = outcome_of(facts);
    if (outcome == nullptr || facts.owner == kNoOwner || !outcome->owner_certain) return std::nullopt;
    judge::ValueCache& values = oracles_[facts.view]->values;
    return values.values(outcome->piece).varying_tolerance(component, result_.position[0], result_.position[1]);
  }

  void add_primitives(size_t index) {
    View& view = result_.views[index];
    const exact::Expectation& expectation = oracles_[index]->expectation;
    const double near = -kNearPixels * std::ldexp(1.0, static_cast<int>(view.subpixel_bits));
    for (uint32_t number = 0; number < expectation.pieces().size(); ++number) {
      // A line or a point has no edges to tell of.
      if (expectation.pieces()[number].triangle() == nullptr) continue;
      const bool is_shown = std::ranges::any_of(result_.parties, [&](const PartyFacts& party) {
        return party.view == index && party.owner == expectation.pieces()[number].owner;
      });
      if (!is_shown && is_far(expectation.pieces()[number], result_.position[0], result_.position[1])) continue;
      PrimitiveFacts facts =
          facts_of(case_, expectation, number, result_.position[0], result_.position[1], view.subpixel_bits);
      const Boundary* const deciding = facts.deciding();
      const bool is_near = facts.undefined || (deciding != nullptr && deciding->distance >= near);
      if (is_near || is_shown) view.primitives.push_back(std::move(facts));
    }
  }

  const Case& case_;
  judge::Profile profile_;
  const judge::CaseVerdict& verdict_;
  std::vector<Side> sides_;
  size_t index_ = 0;
  std::vector<std::unique_ptr<Oracle>> oracles_;
  Explanation result_;
};

CaseExplainer::CaseExplainer(const Case& test_case, const NamedParty& candidate, const NamedParty* reference,
                             const judge::Profile& profile, const judge::CaseVerdict& verdict)
    : state_(std::make_unique<State>(test_case, candidate, reference, profile, verdict)) {}

CaseExplainer::~CaseExplainer() = default;

Explanation CaseExplainer::at(const SampleId& sample) {
  return state_->at(sample);
}

Result<Explanation> explain(const Case& test_case, const NamedParty& candidate, const NamedParty* reference,
                            const judge::Profile& profile, const SampleId& sample) {
  const Target& target = test_case.target;
  if (sample.x >= target.width || sample.y >= target.height) {
    return failure(fmt::format("pixel {},{} is not in the target of {} x {} pixels", sample.x, sample.y, target.width,
                               target.height),
                   fmt::format("X is 0 to {}, Y is 0 to {}", target.width - 1, target.height - 1));
  }
  const auto samples = static_cast<uint32_t>(target.samples);
  if (sample.sample >= samples) {
    return failure(fmt::format("sample {} is not in a target of {} samples per pixel", sample.sample, samples));
  }
  const judge::CaseVerdict verdict =
      judge::judge(test_case, candidate.party, reference != nullptr ? &reference->party : nullptr,
                   {.profile = profile, .keep_maps = true});
  return CaseExplainer(test_case, candidate, reference, profile, verdict).at(sample);
}

}  // namespace fillrule::explain
