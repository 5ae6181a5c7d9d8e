// What a party's depth and varyings are at a sample, what they should be, and what the tolerance is made of.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/explain/oracle.h"
#include "reference/exact/depth_format.h"

namespace fillrule::explain {
namespace {

using exact::Piece;
using judge::Outcome;
using judge::Standing;

// In units of the last place of the float32 next to `exact`, beyond what is left open.
double error_in_ulps(float value, double exact, double spread) {
  if (std::isnan(exact)) return 0;
  const auto rounded = static_cast<float>(exact);
  const double ulp =
      double{std::nextafter(std::abs(rounded), std::numeric_limits<float>::infinity())} - double{std::abs(rounded)};
  return std::max(std::abs(double{value} - exact) - spread, 0.0) / ulp;
}

class ValueFacts {
 public:
  ValueFacts(const Case& test_case, Oracle& oracle, const judge::Possibilities& possible, const Planes& planes,
             size_t index)
      : case_(test_case),
        oracle_(oracle),
        possible_(possible),
        planes_(planes),
        index_(index),
        place_(exact::sample_place(test_case.target, index)),
        judge_(test_case, planes, oracle.expectation, oracle.values),
        shades_samples_(judge::shades_samples(test_case)) {
    // The outcome that the party shows; none where it shows none of the right ones.
    const auto found = std::ranges::find(possible.outcomes, planes.owner[index], &Outcome::owner);
    if (found != possible.outcomes.end()) outcome_ = &*found;
  }

  std::vector<Value> all() {
    std::vector<Value> values;
    if (!planes_.depth.empty()) values.push_back(depth());
    const std::vector<judge::ComponentSource> sources = judge::component_sources(case_.varyings);
    uint32_t component = 0;
    for (const Varying& varying : case_.varyings) {
      for (uint32_t c = 0; c < varying.components; ++c, ++component) {
        const std::string name =
            varying.components == 1 ? varying.name : fmt::format("{}.{}", varying.name, "xyzw"[c]);
        values.push_back(component_value(name, sources[component], component));
      }
    }
    return values;
  }

 private:
  using Parts = std::optional<exact::Tolerance>;

  // With all of the tolerance: the judge takes a smaller one where that is enough.
  static Value value(const std::string& name, float value, Standing standing, const Parts& parts) {
    Value result{.name = name,
                 .value = value,
                 .standing = standing,
                 .ulps = error_in_ulps(value, standing.expected, standing.spread)};
    const bool judged = !std::isnan(standing.expected) && std::isfinite(standing.tolerance);
    const double rounded = standing.tolerance - standing.spread;
    if (!judged || !parts || !(parts->total() >= rounded * (1 - 1e-6)) || !(rounded > 0)) return result;
    result.tolerance = parts;
    result.standing.tolerance = parts->total() + standing.spread;
    const double error = std::max(std::abs(double{value} - standing.expected) - standing.spread, 0.0);
    result.standing.severity = error / parts->total();
    return result;
  }

  Value depth() {
    const Standing standing = judge_.depth(possible_, index_);
    Parts parts;
    std::string open;
    if (outcome_ != nullptr && outcome_->depth_writer != kNoOwner && outcome_->depth_certain) {
      const auto [x, y] = place_.position;
      parts = oracle_.values.values(outcome_->depth_writer).depth_tolerance(x, y);
      const Piece& writer = oracle_.expectation.pieces()[outcome_->depth_writer];
      if (case_.draws[writer.draw].state.depth_bias) open = "the depth bias";
      if (exact::largest_code(case_.target.depth_format) > 0) {
        open += open.empty() ? "the two closest codes" : " and the two closest codes";
      }
    }
    Value result = value("depth", planes_.depth[index_], standing, parts);
    if (standing.spread > 0) result.left_open = open;
    if (planes_.samples > 1 && parts) result.place = "at the sample";
    return result;
  }

  // Where the component is evaluated; `anywhere` in the pixel. Empty where there is but one place.
  [[nodiscard]] std::string place_of(const judge::ComponentSource& source, bool& anywhere) const {
    anywhere = false;
    const bool built_in = source.source != VaryingSource::kVertices;
    if (planes_.samples == 1 || (!built_in && source.interpolation == Interpolation::kFlat)) return {};
    constexpr uint32_t kZ = 2;
    const bool of_fragment = source.source == VaryingSource::kFragCoord && source.number >= kZ && !shades_samples_;
    const bool centroid = !built_in && source.sampling == Sampling::kCentroid;
    anywhere = of_fragment || centroid;
    if (centroid) return "where the pixel and the primitive overlap";
    if (of_fragment) return "anywhere in the pixel";
    if (!built_in && source.sampling == Sampling::kSample) return "at the sample";
    return shades_samples_ ? "at the sample or the pixel's centre" : "at the pixel's centre";
  }

  Value component_value(const std::string& name, const judge::ComponentSource& source, uint32_t component) {
    const Standing standing = judge_.varying(possible_, index_, component);
    bool anywhere = false;
    const std::string place = place_of(source, anywhere);
    const bool interpolated =
        source.source == VaryingSource::kVertices && source.interpolation != Interpolation::kFlat;
    const bool landed = outcome_ != nullptr && outcome_->owner != kNoOwner && outcome_->owner_certain;
    Parts parts;
    if (interpolated && landed && !anywhere) {
      const bool centre = planes_.samples > 1 && source.sampling != Sampling::kSample && !shades_samples_;
      const exact::Position at = centre ? exact::Position{.x = place_.x + 0.5, .y = place_.y + 0.5} : place_.position;
      parts = oracle_.values.values(outcome_->piece).varying_tolerance(source.number, at.x, at.y);
    }
    Value result = value(name, planes_.varyings[component][index_], standing, parts);
    if (outcome_ != nullptr && outcome_->owner != kNoOwner) result.place = place;
    if (standing.spread > 0) result.left_open = anywhere ? "the place" : "the depth bias";
    return result;
  }

  const Case& case_;
  Oracle& oracle_;
  const judge::Possibilities& possible_;
  const Planes& planes_;
  size_t index_;
  exact::SamplePlace place_;
  judge::PartyJudge judge_;
  bool shades_samples_;
  const Outcome* outcome_ = nullptr;
};

}  // namespace

std::vector<Value> values_of(const Case& test_case, Oracle& oracle, const judge::Possibilities& possible,
                             const Planes& planes, size_t index) {
  return ValueFacts(test_case, oracle, possible, planes, index).all();
}

}  // namespace fillrule::explain
