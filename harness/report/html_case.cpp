#include "harness/report/html_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <tuple>

#include "harness/report/html_explanation.h"
#include "harness/report/names.h"
#include "harness/report/outlines.h"
#include "harness/report/packed.h"
#include "reference/exact/samples.h"

namespace fillrule::report {
namespace {

using judge::SampleRecord;

// A sample and the plane that is worst there.
struct WorstSample {
  const judge::PlaneVerdict* plane;
  SampleRecord record;
};

// The gravest first, each sample once.
std::vector<WorstSample> worst_samples(const judge::CaseVerdict& verdict) {
  std::vector<WorstSample> all;
  for (const judge::PlaneVerdict& plane : verdict.planes) {
    for (const SampleRecord& record : plane.worst_samples) all.push_back({&plane, record});
  }
  // Planes are in the order in which one follows from the other, which stays among equals.
  std::stable_sort(all.begin(), all.end(),
                   [](const WorstSample& a, const WorstSample& b) { return judge::graver(a.record, b.record); });
  std::vector<WorstSample> unique;
  std::vector<std::tuple<uint32_t, uint32_t, uint32_t>> seen;
  for (const WorstSample& one : all) {
    const std::tuple place(one.record.y, one.record.x, one.record.sample);
    if (unique.size() == kListedSamples) break;
    if (std::find(seen.begin(), seen.end(), place) != seen.end()) continue;
    seen.push_back(place);
    unique.push_back(one);
  }
  return unique;
}

std::vector<std::string> channels_of(const Case& test_case, const Planes& planes) {
  std::vector<std::string> names{"hits", "owner", "front_facing"};
  if (!planes.depth.empty()) names.emplace_back("depth");
  for (const Varying& varying : test_case.varyings) {
    for (uint32_t c = 0; c < varying.components; ++c) {
      names.push_back(varying.components == 1 ? varying.name : fmt::format("{}.{}", varying.name, "xyzw"[c]));
    }
  }
  return names;
}

std::string packed_planes(const run::Drawing& drawing, const std::vector<SampleMark>& marks) {
  const Planes& candidate = drawing.candidate;
  const Planes* const reference = drawing.reference ? &*drawing.reference : nullptr;
  Packer packer;
  const auto add_words = [&](const std::vector<uint32_t> Planes::*plane) {
    if (reference != nullptr) packer.add_words(reference->*plane);
    packer.add_words(candidate.*plane, reference != nullptr ? reference->*plane : std::vector<uint32_t>{});
  };
  const auto add_floats = [&](const std::vector<float>& of_candidate, const std::vector<float>* of_reference) {
    if (of_reference != nullptr) packer.add_floats(*of_reference);
    packer.add_floats(of_candidate, of_reference != nullptr ? *of_reference : std::vector<float>{});
  };
  add_words(&Planes::hits);
  add_words(&Planes::owner);
  add_words(&Planes::front_facing);
  if (!candidate.depth.empty()) add_floats(candidate.depth, reference != nullptr ? &reference->depth : nullptr);
  for (size_t c = 0; c < candidate.varyings.size(); ++c) {
    add_floats(candidate.varyings[c], reference != nullptr ? &reference->varyings[c] : nullptr);
  }
  std::vector<uint8_t> bytes(marks.size());
  for (const judge::PlaneVerdict& plane : drawing.verdict.planes) {
    std::ranges::transform(plane.map, bytes.begin(),
                           [](judge::Verdict verdict) { return static_cast<uint8_t>(verdict); });
    packer.add_bytes(bytes);
  }
  std::ranges::transform(marks, bytes.begin(), [](const SampleMark& mark) {
    return static_cast<uint8_t>(static_cast<uint8_t>(mark.kind) | (mark.reference_alone ? 0x10U : 0U));
  });
  packer.add_bytes(bytes);
  constexpr uint32_t kSeveralOwners = kNoOwner - 1;
  std::vector<uint32_t> owners;
  owners.reserve(marks.size());
  const std::vector<judge::OracleAnswer>& oracle = drawing.verdict.oracle;
  std::ranges::transform(oracle, bytes.begin(),
                         [](const auto& answer) { return static_cast<uint8_t>(answer.coverage); });
  for (const judge::OracleAnswer& answer : oracle) owners.push_back(answer.owner.value_or(kSeveralOwners));
  packer.add_bytes(bytes);
  packer.add_words(owners);
  return packer.packed();
}

Json worst_json(const WorstSample& worst) {
  const SampleRecord& record = worst.record;
  Json json{{"plane", worst.plane->name},
            {"x", record.x},
            {"y", record.y},
            {"sample", record.sample},
            {"component", record.component},
            {"verdict", name_of(record.verdict)},
            {"candidate", json_number(record.candidate)},
            {"expected", json_number(record.expected)},
            {"tolerance", json_number(record.tolerance)},
            {"severity", json_number(record.severity)}};
  if (record.reference) json["reference"] = json_number(*record.reference);
  return json;
}

Json plane_json(const judge::PlaneVerdict& plane) {
  return {{"name", plane.name},
          {"components", plane.components},
          {"counts", plane.counts},
          {"candidate_faults", plane.candidate_faults()},
          {"reference_faults", plane.reference_faults()}};
}

Json outline_json(const Outline& outline) {
  constexpr std::array<const char*, 3> kKinds{"triangle", "line", "point"};
  Json json{{"primitive", outline.primitive},
            {"draw", outline.draw},
            {"kind", kKinds[static_cast<size_t>(outline.kind)]},
            {"vertices", outline.vertices},
            {"corners", Json::array()}};
  if (outline.kind != Outline::Kind::kTriangle) json["size"] = outline.size;
  for (const OutlineCorner& corner : outline.corners) {
    json["corners"].push_back({static_cast<float>(corner.x), static_cast<float>(corner.y), corner.made_by});
  }
  return json;
}

// What the page says of the case before anything is unpacked, and what it is drawn in.
Json head_json(const Case& test_case, const run::CaseResult& result, const Diagnosis& diagnosis) {
  Json json{{"name", test_case.name},
            {"file", test_case.file},
            {"title", test_case.title},
            {"why", test_case.why},
            {"spec", test_case.spec},
            {"status", name_of(result.status)},
            {"message", result.message},
            {"show", result.show_command},
            {"explain", result.explain_command},
            {"sentence", diagnosis.sentence},
            {"class", name_of(diagnosis.main)},
            {"class_counts", diagnosis.counts},
            {"checks", Json::array()},
            {"width", test_case.target.width},
            {"height", test_case.target.height},
            {"samples", static_cast<uint32_t>(test_case.target.samples)},
            {"locations", Json::array()}};
  for (const judge::CheckResult& check : result.checks) {
    if (check.outcome != judge::CheckResult::Outcome::kFailed) continue;
    json["checks"].push_back({{"name", check.name}, {"message", check.message}});
  }
  for (const exact::Position& place : exact::sample_locations(test_case.target.samples)) {
    json["locations"].push_back({place.x, place.y});
  }
  return json;
}

}  // namespace

HtmlCase html_case(const Case& test_case, const run::CaseResult& result, const run::Drawing& drawing,
                   const Parties& parties) {
  std::vector<SampleMark> marks(drawing.verdict.samples);
  for (size_t i = 0; i < marks.size(); ++i) marks[i] = mark_of(drawing, i);

  const explain::NamedParty candidate{
      .name = parties.candidate,
      .party = {.planes = &drawing.candidate, .subpixel_bits = parties.candidate_subpixel_bits}};
  explain::NamedParty reference{.name = parties.reference,
                                .party = {.subpixel_bits = parties.reference_subpixel_bits}};
  if (drawing.reference) reference.party.planes = &*drawing.reference;
  explain::CaseExplainer explainer(test_case, candidate, drawing.reference ? &reference : nullptr, parties.profile,
                                   drawing.verdict);
  Json worst = Json::array();
  Json explained = Json::array();
  std::vector<explain::Explanation> explanations;
  for (const WorstSample& one : worst_samples(drawing.verdict)) {
    worst.push_back(worst_json(one));
    if (explanations.size() == kExplainedSamples) continue;
    explanations.push_back(explainer.at({.x = one.record.x, .y = one.record.y, .sample = one.record.sample}));
    explained.push_back(explanation_json(explanations.back()));
  }

  HtmlCase encoded{.diagnosis = diagnose(test_case, drawing, marks, explanations), .json = {}};
  Json details = head_json(test_case, result, encoded.diagnosis);
  details["has_reference"] = drawing.reference.has_value();
  details["channels"] = channels_of(test_case, drawing.candidate);
  details["planes"] = Json::array();
  for (const judge::PlaneVerdict& plane : drawing.verdict.planes) details["planes"].push_back(plane_json(plane));
  details["worst"] = std::move(worst);
  details["explanations"] = std::move(explained);
  details["outlines"] = Json::array();
  for (const Outline& outline : outlines_of(test_case, kMostOutlines)) {
    details["outlines"].push_back(outline_json(outline));
  }
  const std::string text = details.dump(-1, ' ', false, Json::error_handler_t::replace);
  encoded.json = Json{{"details", packed_text(text)}, {"planes", packed_planes(drawing, marks)}}.dump();
  return encoded;
}

}  // namespace fillrule::report
