#include "harness/report/html_explanation.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace fillrule::report {
namespace {

using explain::Boundary;
using explain::PrimitiveFacts;

Json owner_json(uint32_t owner) {
  return owner == kNoOwner ? Json() : Json(owner);
}

std::string_view word_for(exact::Coverage coverage) {
  switch (coverage) {
    case exact::Coverage::kMust:
      return "must";
    case exact::Coverage::kMay:
      return "may";
    case exact::Coverage::kMustNot:
      return "must not";
  }
  return "";
}

std::string_view word_for(judge::Standing::Class level) {
  switch (level) {
    case judge::Standing::Class::kExact:
      return "exact";
    case judge::Standing::Class::kWithin:
      return "within";
    case judge::Standing::Class::kImprecise:
      return "imprecise";
    case judge::Standing::Class::kOutside:
      return "outside";
  }
  return "";
}

Json boundary_json(const Boundary& boundary) {
  Json json{{"name", boundary.name},
            {"form", {json_number(boundary.form[0]), json_number(boundary.form[1]), json_number(boundary.form[2])}},
            {"value", json_number(boundary.value)},
            {"distance", json_number(boundary.distance)},
            {"latitude", json_number(boundary.latitude)},
            {"answer", word_for(boundary.answer)}};
  if (boundary.top) json["top"] = true;
  if (boundary.left) json["left"] = true;
  return json;
}

// Of the sample on the primitive, from its three edge functions; null where there are not three.
Json barycentric_json(const PrimitiveFacts& primitive) {
  double sum = 0;
  Json json = Json::array();
  for (const Boundary& boundary : primitive.boundaries) {
    if (boundary.kind == Boundary::Kind::kEdge) sum += boundary.value;
  }
  for (const Boundary& boundary : primitive.boundaries) {
    if (boundary.kind == Boundary::Kind::kEdge) json.push_back(json_number(boundary.value / sum));
  }
  return json.size() == 3 ? json : Json();
}

Json primitive_json(const PrimitiveFacts& primitive) {
  Json json{{"number", primitive.number},
            {"draw", primitive.draw},
            {"vertices", primitive.vertices},
            {"orientation", primitive.orientation},
            {"front", primitive.front_facing},
            {"coverage", word_for(primitive.coverage.coverage)},
            {"barycentric", barycentric_json(primitive)},
            {"boundaries", Json::array()}};
  Json& notes = json["notes"] = Json::array();
  if (primitive.facing_in_doubt) notes.push_back("rounding may turn it over");
  if (primitive.undefined) notes.push_back("undefined");
  if (primitive.thin && !primitive.undefined) notes.push_back("thinner than a subpixel");
  if (primitive.clipped) notes.push_back("to be clipped");
  if (primitive.culled) notes.push_back("culled");
  if (primitive.scissored) notes.push_back("outside of the scissor");
  for (const Boundary& boundary : primitive.boundaries) json["boundaries"].push_back(boundary_json(boundary));
  return json;
}

Json view_json(const explain::View& view) {
  Json json{{"bits", view.subpixel_bits},
            {"hits", {view.possible.least_hits, view.possible.most_hits}},
            {"outcomes", Json::array()},
            {"primitives", Json::array()}};
  // Pieces of one primitive may give the same outcome.
  for (const judge::Outcome& outcome : view.possible.outcomes) {
    Json one{{"owner", owner_json(outcome.owner)}, {"depth_of", owner_json(outcome.depth_writer)}};
    Json& all = json["outcomes"];
    if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(std::move(one));
  }
  for (const PrimitiveFacts& primitive : view.primitives) json["primitives"].push_back(primitive_json(primitive));
  return json;
}

Json party_json(const explain::PartyFacts& party) {
  Json json{{"role", party.role},          {"view", party.view},
            {"hits", party.hits},          {"owner", owner_json(party.owner)},
            {"front", party.front_facing}, {"values", Json::object()}};
  for (const explain::Value& value : party.values) {
    const judge::Standing& standing = value.standing;
    Json one{{"expected", json_number(standing.expected)},
             {"tolerance", json_number(standing.tolerance)},
             {"severity", json_number(standing.severity)},
             {"ulps", json_number(value.ulps)},
             {"level", word_for(standing.level)}};
    if (value.tolerance) {
      one["snapping"] = json_number(value.tolerance->snapping);
      one["rounding"] = json_number(value.tolerance->rounding);
    }
    json["values"][value.name] = std::move(one);
  }
  return json;
}

}  // namespace

Json json_number(double value) {
  if (std::isfinite(value)) return value;
  if (std::isnan(value)) return "nan";
  return value > 0 ? "inf" : "-inf";
}

Json explanation_json(const explain::Explanation& explanation) {
  Json json{{"x", explanation.x},         {"y", explanation.y},           {"sample", explanation.sample},
            {"at", explanation.position}, {"reason", explanation.reason}, {"views", Json::array()},
            {"parties", Json::array()}};
  for (const explain::View& view : explanation.views) json["views"].push_back(view_json(view));
  for (const explain::PartyFacts& party : explanation.parties) json["parties"].push_back(party_json(party));
  return json;
}

}  // namespace fillrule::report
