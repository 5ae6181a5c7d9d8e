#include "harness/explain/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "harness/explain/internal.h"

namespace fillrule::explain {
namespace {

using judge::Standing;

// Primitives further away than this do not matter to the sample.
constexpr double kNearPixels = 1;

// What is asked again and again for parties of the same subpixel bits.
struct Oracle {
  exact::Expectation expectation;
  judge::ValueCache values;
  judge::Replay replay;

  Oracle(const Case& test_case, uint32_t subpixel_bits, judge::Replay::Rules rules)
      : expectation(test_case, subpixel_bits),
        values(test_case, expectation),
        replay(test_case, expectation, values, subpixel_bits, rules) {}
};

class Explainer {
 public:
  Explainer(const Case& test_case, const judge::Profile& profile, const SampleId& sample)
      : case_(test_case), profile_(profile) {
    result_.case_name = test_case.name;
    result_.x = sample.x;
    result_.y = sample.y;
    result_.sample = sample.sample;
    result_.position = {sample.x + 0.5, sample.y + 0.5};
    index_ = size_t{sample.y} * test_case.target.width + sample.x;
  }

  Explanation run(const NamedParty& candidate, const NamedParty* reference) {
    add_party("candidate", candidate);
    if (reference != nullptr) add_party("reference", *reference);
    for (size_t view = 0; view < oracles_.size(); ++view) add_primitives(view);
    const judge::CaseVerdict verdict =
        judge::judge(case_, candidate.party, reference != nullptr ? &reference->party : nullptr,
                     {.profile = profile_, .keep_maps = true});
    for (const judge::PlaneVerdict& plane : verdict.planes) {
      result_.planes.push_back({.name = plane.name, .kind = plane.kind, .verdict = plane.map[index_]});
    }
    result_.reason = reason_of(result_);
    return std::move(result_);
  }

 private:
  // The view for so many subpixel bits, made on first need.
  size_t view_for(uint32_t subpixel_bits) {
    for (size_t i = 0; i < result_.views.size(); ++i) {
      if (result_.views[i].subpixel_bits == subpixel_bits) return i;
    }
    // The profile binds the candidate alone, which comes first.
    judge::Replay::Rules rules;
    if (oracles_.empty()) rules = {.top_left = profile_.top_left, .diamond_exit = profile_.diamond_exit};
    oracles_.push_back(std::make_unique<Oracle>(case_, subpixel_bits, rules));
    result_.views.push_back(
        {.subpixel_bits = subpixel_bits, .primitives = {}, .possible = oracles_.back()->replay.at(index_)});
    return oracles_.size() - 1;
  }

  void add_party(const std::string& role, const NamedParty& named) {
    const Planes& planes = *named.party.planes;
    PartyFacts facts{.role = role,
                     .name = named.name,
                     .view = view_for(named.party.subpixel_bits),
                     .hits = planes.hits[index_],
                     .owner = planes.owner[index_],
                     .front_facing = planes.front_facing[index_] != 0};
    Oracle& oracle = *oracles_[facts.view];
    const judge::Possibilities& possible = result_.views[facts.view].possible;
    const judge::PartyJudge judged(case_, planes, oracle.expectation, oracle.values);
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
                            .ulps = judge::ulps_between(double{value}, standing.expected)});
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
      PrimitiveFacts facts =
          facts_of(case_, expectation, number, result_.position[0], result_.position[1], view.subpixel_bits);
      const Boundary* const deciding = facts.deciding();
      const bool is_near = facts.undefined || (deciding != nullptr && deciding->distance >= near);
      const bool is_shown = std::ranges::any_of(result_.parties, [&](const PartyFacts& party) {
        return party.view == index && party.owner == facts.number;
      });
      if (is_near || is_shown) view.primitives.push_back(std::move(facts));
    }
  }

  const Case& case_;
  judge::Profile profile_;
  size_t index_ = 0;
  std::vector<std::unique_ptr<Oracle>> oracles_;
  Explanation result_;
};

}  // namespace

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
  return Explainer(test_case, profile, sample).run(candidate, reference);
}

}  // namespace fillrule::explain
