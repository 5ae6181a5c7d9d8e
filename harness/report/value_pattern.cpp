#include "harness/report/value_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <vector>

#include "reference/exact/depth_format.h"

namespace fillrule::report {
namespace {

using Triple = std::array<double, 3>;

// A sample in a triangle.
struct Place {
  const Draw* draw = nullptr;
  std::array<uint32_t, 3> vertices{};
  Triple perspective{};  // weights of the vertices in space
  Triple window{};       // ... and in the picture
  double value = 0;      // the party's
  double expected = 0;   // the right one; of several the middle
  double tolerance = 0;  // of the right value: how far snapping and rounding may move it
  double spread = 0;     // ... and what is left open of it
};

double dot(const Triple& a, const Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Triple normalised(const Triple& weights) {
  const double sum = weights[0] + weights[1] + weights[2];
  return {weights[0] / sum, weights[1] / sum, weights[2] / sum};
}

// None where the party shows no triangle there, or one without three edges.
std::optional<Place> place_of(const Case& test_case, const std::string& name, const WrongValue& seen) {
  const explain::PartyFacts& party = seen.explanation->parties[seen.party];
  const auto value = std::ranges::find(party.values, name, &explain::Value::name);
  const auto& primitives = seen.explanation->views[party.view].primitives;
  const auto primitive = std::ranges::find(primitives, party.owner, &explain::PrimitiveFacts::number);
  if (value == party.values.end() || primitive == primitives.end()) return std::nullopt;
  const auto edges =
      std::ranges::count(primitive->boundaries, explain::Boundary::Kind::kEdge, &explain::Boundary::kind);
  if (edges != 3 || primitive->kind != exact::Piece::Kind::kTriangle) return std::nullopt;
  Place place{.draw = &test_case.draws[primitive->draw],
              .vertices = {primitive->vertices[0], primitive->vertices[1], primitive->vertices[2]},
              .value = double{value->value}};
  place.expected = value->standing.expected;
  // The standing's tolerance is the inaccuracy and what is left open, added up; a bias that may be one of several is
  // no inaccuracy. In a fixed-point format what is stored is either of the two closest codes, a step apart at most.
  const double inaccuracy = value->standing.tolerance - value->standing.spread;
  const double step = name == "depth" ? 2 * exact::half_step(test_case.target.depth_format) : 0;
  place.spread = value->standing.spread;
  place.tolerance = (std::isfinite(inaccuracy) ? inaccuracy : 0) + step;
  Triple edge_values{};
  for (size_t i = 0; i < 3; ++i) edge_values[i] = primitive->boundaries[i].value;
  place.perspective = normalised(edge_values);
  for (size_t i = 0; i < 3; ++i) edge_values[i] *= double{place.draw->positions[place.vertices[i]][3]};
  place.window = normalised(edge_values);
  return place;
}

// One component of the vertices' varyings.
struct Component {
  std::string name;
  uint32_t offset = 0;  // in a vertex's floats
  Interpolation interpolation = Interpolation::kSmooth;
};

std::vector<Component> components_of(const Case& test_case) {
  std::vector<Component> components;
  for (const Varying& varying : test_case.varyings) {
    if (varying.source != VaryingSource::kVertices) continue;
    for (uint32_t c = 0; c < varying.components; ++c) {
      components.push_back({varying.components == 1 ? varying.name : fmt::format("{}.{}", varying.name, "xyzw"[c]),
                            static_cast<uint32_t>(components.size()), varying.interpolation});
    }
  }
  return components;
}

using Formula = std::function<double(const Place&)>;

struct Alternative {
  std::string text;
  Formula formula;
  // The formula takes the middle of the biases that are right; the party may have started from another one of them.
  // So many times the bias goes into it, and so many times the spread it may be off.
  double biases = 0;
};

bool explains(const Alternative& alternative, std::span<const Place> places) {
  return std::ranges::all_of(places, [&](const Place& place) {
    const double expected = alternative.formula(place);
    // For words only, no verdict: another value is moved by snapping about as far as the right one, here up to four
    // times, as its slope may be another.
    const double slack = 4 * place.tolerance + alternative.biases * place.spread;
    return std::abs(expected - place.value) <= slack + 1e-5 * std::abs(expected);
  });
}

// Of the vertices, in clip space or divided by w.
Triple z_of(const Place& place, bool divided) {
  Triple values{};
  for (size_t i = 0; i < 3; ++i) {
    const ClipPosition& p = place.draw->positions[place.vertices[i]];
    values[i] = divided ? double{p[2]} / double{p[3]} : double{p[2]};
  }
  return values;
}

// A depth in the view volume as one in the window, "Controlling the Viewport".
double window_depth(const Place& place, double depth) {
  const RasterState& state = place.draw->state;
  const double min{state.viewport.minDepth};
  const double range = double{state.viewport.maxDepth} - min;
  return min + range * (state.negative_one_to_one ? (depth + 1) / 2 : depth);
}

// The right depth without the bias, and the bias.
double unbiased(const Place& place) {
  return window_depth(place, dot(place.window, z_of(place, true)));
}
double bias_of(const Place& place) {
  return place.draw->state.depth_bias ? place.expected - unbiased(place) : 0;
}

std::vector<Alternative> depth_alternatives() {
  return {{"interpolated with perspective correction, which depth never is",
           [](const Place& place) {
             return window_depth(place, dot(place.perspective, z_of(place, true))) + bias_of(place);
           }},
          {"the clip-space z, without the division by w",
           [](const Place& place) {
             return window_depth(place, dot(place.perspective, z_of(place, false))) + bias_of(place);
           }},
          {"upside down: one minus what is right", [](const Place& place) { return 1 - place.expected; }}};
}

std::vector<Alternative> biased_depth_alternatives() {
  return {{"what is right before the depth bias is added", unbiased},
          {"what is right with the depth bias subtracted",
           [](const Place& place) { return unbiased(place) - bias_of(place); }, 1},
          {"what is right with twice the depth bias",
           [](const Place& place) { return unbiased(place) + 2 * bias_of(place); }, 2}};
}

bool all_biased(std::span<const Place> places) {
  return std::ranges::all_of(places, [](const Place& place) { return place.draw->state.depth_bias.has_value(); });
}

// A bias is one number for all of a polygon; either of two values compared may be off by its tolerance.
bool off_by_one_amount(std::span<const Place> places) {
  const Place& first = places.front();
  return std::ranges::all_of(places, [&first](const Place& place) {
    const double difference = (place.value - place.expected) - (first.value - first.expected);
    return std::abs(difference) <= place.tolerance + first.tolerance;
  });
}

Triple at_vertices(const Case& test_case, const Place& place, uint32_t offset) {
  const uint32_t stride = vertex_component_count(test_case.varyings);
  Triple values{};
  for (size_t i = 0; i < 3; ++i) {
    values[i] = double{place.draw->varyings[size_t{place.vertices[i]} * stride + offset]};
  }
  return values;
}

double interpolated(const Case& test_case, const Place& place, const Component& component, Interpolation as) {
  const Triple values = at_vertices(test_case, place, component.offset);
  if (as == Interpolation::kFlat) return values[0];
  return dot(as == Interpolation::kSmooth ? place.perspective : place.window, values);
}

std::vector<Alternative> varying_alternatives(const Case& test_case, const std::string& name) {
  const std::vector<Component> components = components_of(test_case);
  const auto own = std::ranges::find(components, name, &Component::name);
  if (own == components.end()) return {};
  std::vector<Alternative> alternatives;
  const auto add = [&](std::string text, const Component& component, Interpolation as) {
    alternatives.push_back({std::move(text), [&test_case, component, as](const Place& place) {
                              return interpolated(test_case, place, component, as);
                            }});
  };
  if (own->interpolation != Interpolation::kNoperspective) {
    add("interpolated without perspective correction (affine)", *own, Interpolation::kNoperspective);
  }
  if (own->interpolation != Interpolation::kSmooth) {
    add("interpolated with perspective correction (smooth)", *own, Interpolation::kSmooth);
  }
  constexpr std::array<const char*, 3> kOrdinals{"first", "second", "third"};
  for (size_t i = 0; i < 3; ++i) {
    alternatives.push_back({fmt::format("that of the {} vertex (flat)", kOrdinals[i]),
                            [&test_case, offset = own->offset, i](const Place& place) {
                              return at_vertices(test_case, place, offset)[i];
                            }});
  }
  for (const Component& other : components) {
    if (other.name == name) continue;
    add(fmt::format("what {} should hold", other.name), other, other.interpolation);
  }
  return alternatives;
}

}  // namespace

std::optional<std::string> pattern_of(const Case& test_case, const std::string& name,
                                      std::span<const WrongValue> seen) {
  std::vector<Place> places;
  for (const WrongValue& one : seen) {
    if (const std::optional<Place> place = place_of(test_case, name, one)) places.push_back(*place);
  }
  if (places.size() < 2 || places.size() < seen.size()) return std::nullopt;
  const bool is_biased = name == "depth" && all_biased(places);
  std::vector<Alternative> alternatives =
      name == "depth" ? depth_alternatives() : varying_alternatives(test_case, name);
  if (is_biased) std::ranges::move(biased_depth_alternatives(), std::back_inserter(alternatives));
  for (const Alternative& alternative : alternatives) {
    if (explains(alternative, places)) return alternative.text;
  }
  if (is_biased && off_by_one_amount(places)) {
    return "off by the same amount at all that were looked into, which points to the depth bias";
  }
  return std::nullopt;
}

}  // namespace fillrule::report
