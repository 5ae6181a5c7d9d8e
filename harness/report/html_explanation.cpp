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

std::string_view word_for(explain::Exclusion exclusion) {
  switch (exclusion) {
    case explain::Exclusion::kNone:
      return "";
    case explain::Exclusion::kCulledByFacing:
      return "culled as it faces";
    case explain::Exclusion::kCulledByDistances:
      return "culled by its cull distances";
    case explain::Exclusion::kOutsideVolume:
      return "outside of the clip volume";
    case explain::Exclusion::kScissored:
      return "outside of the scissor";
    case explain::Exclusion::kMasked:
      return "taken away by the sample mask";
  }
  return "";
}

std::string_view word_for(exact::Piece::Kind kind) {
  switch (kind) {
    case exact::Piece::Kind::kTriangle:
      return "triangle";
    case exact::Piece::Kind::kLine:
      return "line";
    case exact::Piece::Kind::kBresenhamLine:
      return "Bresenham line";
    case exact::Piece::Kind::kPoint:
      return "point";
    case exact::Piece::Kind::kClipEdges:
      return "what clipping may add";
  }
  return "";
}

Json bresenham_json(const explain::BresenhamFacts& facts) {
  Json json{{"x_major", facts.x_major}, {"width", facts.width}, {"distance", json_number(facts.distance)}};
  if (facts.diamond_exit) json["diamond_exit"] = *facts.diamond_exit;
  return json;
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
            {"kind", word_for(primitive.kind)},
            {"coverage", word_for(primitive.coverage.coverage)},
            {"answer", word_for(primitive.answer)},
            {"barycentric", barycentric_json(primitive)},
            {"boundaries", Json::array()}};
  if (!primitive.polygon.empty()) json["polygon"] = primitive.polygon;
  Json& notes = json["notes"] = Json::array();
  if (primitive.facing_in_doubt) notes.push_back("rounding may turn it over");
  if (primitive.undefined) notes.push_back("undefined");
  if (primitive.thin && !primitive.undefined) notes.push_back("thinner than a subpixel");
  if (primitive.clipped) notes.push_back("to be clipped");
  if (primitive.open) notes.push_back("may be drawn or not");
  if (primitive.exclusion != explain::Exclusion::kNone) notes.push_back(word_for(primitive.exclusion));
  if (primitive.bresenham) json["bresenham"] = bresenham_json(*primitive.bresenham);
  for (const Boundary& boundary : primitive.boundaries) json["boundaries"].push_back(boundary_json(boundary));
  return json;
}

Json view_json(const explain::View& view) {
  Json json{{"bits", view.subpixel_bits},
            {"hits", {view.possible.least_hits, view.possible.most_hits}},
            {"outcomes", Json::array()},
            {"primitives", Json::array()}};
  // Pieces of one primitive may give the same outcome.
  for (size_t i = 0; i < view.possible.outcomes.size(); ++i) {
    Json one{{"owner", owner_json(view.possible.outcomes[i].owner)}, {"depth_of", owner_json(view.depth_owners[i])}};
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
    if (!value.left_open.empty()) one["left_open"] = value.left_open;
    if (!value.place.empty()) one["place"] = value.place;
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
