#include "harness/explain/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "harness/explain/internal.h"
#include "harness/explain/oracle.h"

namespace fillrule::explain {

class CaseExplainer::State {
 public:
  State(const Case& test_case, const NamedParty& candidate, const NamedParty* reference,
        const judge::Profile& profile, const judge::CaseVerdict& verdict)
      : case_(test_case), candidate_(candidate), reference_(reference), profile_(profile), verdict_(verdict) {}

  Explanation at(const SampleId& id) {
    result_ = {};
    const Target& target = case_.target;
    const auto samples = static_cast<uint32_t>(target.samples);
    const size_t pixel = (size_t{id.y} * target.width + id.x) * samples;
    const uint32_t sample = id.sample ? *id.sample : gravest_sample(pixel, samples);
    index_ = pixel + sample;
    const exact::Position position = exact::sample_place(target, index_).position;
    result_.case_name = case_.name;
    result_.x = id.x;
    result_.y = id.y;
    result_.sample = sample;
    result_.samples = samples;
    result_.position = {position.x, position.y};
    add_party("candidate", candidate_);
    if (reference_ != nullptr) add_party("reference", *reference_);
    for (size_t view = 0; view < result_.views.size(); ++view) add_primitives(view);
    for (const judge::PlaneVerdict& plane : verdict_.planes) {
      result_.planes.push_back({.name = plane.name, .kind = plane.kind, .verdict = plane.map[index_]});
    }
    result_.reason = reason_of(result_);
    return std::move(result_);
  }

 private:
  [[nodiscard]] uint32_t gravest_sample(size_t pixel, uint32_t samples) const {
    uint32_t gravest = 0;
    auto verdict = judge::Verdict::kIdentical;
    for (uint32_t sample = 0; sample < samples; ++sample) {
      for (const judge::PlaneVerdict& plane : verdict_.planes) {
        if (plane.map[pixel + sample] <= verdict) continue;
        verdict = plane.map[pixel + sample];
        gravest = sample;
      }
    }
    return gravest;
  }

  // The oracle for so many subpixel bits, made on first need. The candidate's comes first, and the profile binds the
  // candidate alone.
  Oracle& oracle_for(uint32_t subpixel_bits) {
    for (const auto& oracle : oracles_) {
      if (oracle->subpixel_bits == subpixel_bits) return *oracle;
    }
    judge::Replay::Rules rules;
    if (oracles_.empty()) rules = {.top_left = profile_.top_left, .diamond_exit = profile_.diamond_exit};
    return *oracles_.emplace_back(std::make_unique<Oracle>(case_, subpixel_bits, rules));
  }

  // The view for so many subpixel bits. Views are in the order of the oracles.
  size_t view_for(uint32_t subpixel_bits) {
    for (size_t i = 0; i < result_.views.size(); ++i) {
      if (result_.views[i].subpixel_bits == subpixel_bits) return i;
    }
    Oracle& oracle = oracle_for(subpixel_bits);
    View view{.subpixel_bits = subpixel_bits, .primitives = {}, .possible = oracle.replay.at(index_)};
    const std::vector<exact::Piece>& pieces = oracle.expectation.pieces();
    for (const judge::Outcome& outcome : view.possible.outcomes) {
      view.depth_owners.push_back(outcome.depth_writer == kNoOwner ? kNoOwner : pieces[outcome.depth_writer].owner);
    }
    result_.views.push_back(std::move(view));
    return result_.views.size() - 1;
  }

  void add_party(const std::string& role, const NamedParty& named) {
    const Planes& planes = *named.party.planes;
    const size_t view = view_for(named.party.subpixel_bits);
    result_.parties.push_back(
        {.role = role,
         .name = named.name,
         .view = view,
         .hits = planes.hits[index_],
         .owner = planes.owner[index_],
         .front_facing = planes.front_facing[index_] != 0,
         .values = values_of(case_, *oracles_[view], result_.views[view].possible, planes, index_)});
  }

  void add_primitives(size_t index) {
    std::vector<uint32_t> shown;
    for (const PartyFacts& party : result_.parties) {
      if (party.view == index) shown.push_back(party.owner);
    }
    View& view = result_.views[index];
    view.primitives = primitives_of(case_, oracles_[index]->expectation, index_, view.subpixel_bits, shown);
  }

  const Case& case_;
  const NamedParty& candidate_;
  const NamedParty* reference_;
  judge::Profile profile_;
  const judge::CaseVerdict& verdict_;
  size_t index_ = 0;
  std::vector<std::unique_ptr<Oracle>> oracles_;
  Explanation result_;
};

CaseExplainer::CaseExplainer(const Case& test_case, const NamedParty& candidate, const NamedParty* reference,
                             const judge::Profile& profile, const judge::CaseVerdict& verdict)
    : state_(std::make_unique<State>(test_case, candidate, reference, profile, verdict)) {}

CaseExplainer::~CaseExplainer() = default;

Explanation CaseExplainer::at(const SampleId& id) {
  return state_->at(id);
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
  if (sample.sample && *sample.sample >= samples) {
    return failure(fmt::format("sample {} is not in a target of {} {} per pixel", *sample.sample, samples,
                               samples == 1 ? "sample" : "samples"),
                   samples == 1 ? std::string("the only one is 0") : fmt::format("N is 0 to {}", samples - 1));
  }
  const judge::CaseVerdict verdict =
      judge::judge(test_case, candidate.party, reference != nullptr ? &reference->party : nullptr,
                   {.profile = profile, .keep_maps = true});
  return CaseExplainer(test_case, candidate, reference, profile, verdict).at(sample);
}

}  // namespace fillrule::explain
