#include "harness/report/value_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

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
  double tolerance = 0;  // of the right value: how far snapping and rounding may move it
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
  place.tolerance = std::isfinite(value->standing.tolerance) ? value->standing.tolerance : 0;
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
};

bool explains(const Alternative& alternative, std::span<const Place> places) {
  return std::ranges::all_of(places, [&](const Place& place) {
    const double expected = alternative.formula(place);
    // Another value is moved by snapping about as far as the right one.
    return std::abs(expected - place.value) <= 4 * place.tolerance + 1e-5 * std::abs(expected);
  });
}

std::vector<Alternative> depth_alternatives() {
  const auto z = [](const Place& place, bool divided) {
    Triple values{};
    for (size_t i = 0; i < 3; ++i) {
      const ClipPosition& p = place.draw->positions[place.vertices[i]];
      values[i] = divided ? double{p[2]} / double{p[3]} : double{p[2]};
    }
    return values;
  };
  return {{"interpolated with perspective correction, which depth never is",
           [z](const Place& place) { return dot(place.perspective, z(place, true)); }},
          {"the clip-space z, without the division by w",
           [z](const Place& place) { return dot(place.perspective, z(place, false)); }},
          {"upside down: one minus what is right",
           [z](const Place& place) { return 1 - dot(place.window, z(place, true)); }}};
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
  const std::vector<Alternative> alternatives =
      name == "depth" ? depth_alternatives() : varying_alternatives(test_case, name);
  for (const Alternative& alternative : alternatives) {
    if (explains(alternative, places)) return alternative.text;
  }
  return std::nullopt;
}

}  // namespace fillrule::report
