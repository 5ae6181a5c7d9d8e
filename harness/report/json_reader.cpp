#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>

#include "harness/report/json.h"
#include "harness/report/names.h"

namespace fillrule::report {
namespace {

// In order, as the planes of a case are.
using Json = nlohmann::ordered_json;

double number(const Json& json) {
  if (json.is_number()) return json.get<double>();
  const auto text = json.get<std::string>();
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (text != "inf" && text != "-inf") throw std::invalid_argument("\"" + text + "\" is no number");
  return text == "inf" ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
}

// The one of these that is written so.
template <typename Enum>
Enum named(const Json& json, std::initializer_list<Enum> values) {
  const auto name = json.get<std::string>();
  for (const Enum value : values) {
    if (name_of(value) == name) return value;
  }
  throw std::invalid_argument("\"" + name + "\" is not known");
}

judge::SampleRecord record(const Json& json) {
  using judge::Verdict;
  judge::SampleRecord record{
      .x = json.at("x"),
      .y = json.at("y"),
      .sample = json.at("sample"),
      .component = json.at("component"),
      .verdict = named(json.at("verdict"), {Verdict::kIdentical, Verdict::kPermitted, Verdict::kImprecise,
                                            Verdict::kReferenceFault, Verdict::kCandidateFault, Verdict::kBothFault}),
      .candidate = number(json.at("candidate")),
      .expected = number(json.at("expected")),
      .tolerance = number(json.at("tolerance")),
      .severity = number(json.at("severity"))};
  if (json.contains("reference")) record.reference = number(json.at("reference"));
  return record;
}

judge::PlaneKind kind_of(const std::string& plane) {
  if (plane == "coverage") return judge::PlaneKind::kCoverage;
  if (plane == "hits") return judge::PlaneKind::kHits;
  if (plane == "owner") return judge::PlaneKind::kOwner;
  if (plane == "front_facing") return judge::PlaneKind::kFrontFacing;
  return plane == "depth" ? judge::PlaneKind::kDepth : judge::PlaneKind::kVarying;
}

judge::PlaneVerdict plane(const std::string& name, const Json& json) {
  judge::PlaneVerdict plane{.name = name, .kind = kind_of(name), .components = json.at("components")};
  const uint64_t both = json.at("both_at_fault");
  const uint64_t candidate_faults = json.at("candidate_faults");
  const uint64_t reference_faults = json.at("reference_faults");
  if (both > candidate_faults || both > reference_faults) throw std::invalid_argument("counts that do not add up");
  plane.counts = {json.at("identical"),    json.at("permitted"),    json.at("imprecise"),
                  reference_faults - both, candidate_faults - both, both};
  if (json.contains("bounds")) {
    const Json& box = json.at("bounds");
    plane.bounds = judge::Bounds{.min_x = box.at(0), .min_y = box.at(1), .max_x = box.at(2), .max_y = box.at(3)};
  }
  if (json.contains("first")) plane.first = record(json.at("first"));
  if (json.contains("worst")) plane.worst = record(json.at("worst"));
  return plane;
}

judge::CheckResult check(const Json& json) {
  using Outcome = judge::CheckResult::Outcome;
  return {.name = json.at("name"),
          .outcome = named(json.at("outcome"),
                           {Outcome::kPassed, Outcome::kFailed, Outcome::kOptedOut, Outcome::kDoesNotFit}),
          .message = json.at("message")};
}

run::CaseResult case_result(const Json& json) {
  using run::Status;
  run::CaseResult result{.name = json.at("name"),
                         .file = json.at("file"),
                         .status = named(json.at("status"), {Status::kPassed, Status::kFailed, Status::kSkipped}),
                         .message = json.value("message", ""),
                         .reason = json.value("reason", ""),
                         .show_command = json.at("show"),
                         .explain_command = json.at("explain"),
                         .seconds = json.at("seconds"),
                         .verdict = {.samples = json.at("samples"),
                                     .covered_samples = json.at("covered_samples"),
                                     .may_samples = json.at("may_samples"),
                                     .undefined_samples = json.at("undefined_samples")}};
  uint32_t component = 0;
  for (const auto& [name, value] : json.at("planes").items()) {
    result.verdict.planes.push_back(plane(name, value));
    judge::PlaneVerdict& read = result.verdict.planes.back();
    if (read.kind != judge::PlaneKind::kVarying) continue;
    read.first_component = component;
    component += read.components;
  }
  for (const Json& one : json.at("checks")) result.checks.push_back(check(one));
  return result;
}

// The reference's time is what the other parts leave.
run::RunTiming timing(const Json& json) {
  return {.wall_seconds = json.at("wall_seconds"),
          .processor_seconds = json.at("processor_seconds"),
          .candidate_seconds = json.at("candidate_seconds"),
          .oracle_seconds = json.at("oracle_seconds"),
          .judge_seconds = json.at("judge_seconds"),
          .check_seconds = json.at("check_seconds")};
}

run::RunResult run_result(const Json& json) {
  const Json& reference = json.at("reference");
  run::RunResult result{.candidate = json.at("candidate").at("name"),
                        .candidate_subpixel_bits = json.at("candidate").at("subpixel_bits"),
                        .reference = {.driver = reference.at("driver"),
                                      .name = reference.at("name"),
                                      .version = reference.at("version"),
                                      .subpixel_bits = reference.at("subpixel_bits")},
                        .profile = json.at("profile"),
                        .timing = {.run = timing(json.at("timing"))}};
  if (json.contains("shard")) {
    const Json& shard = json.at("shard");
    result.shard = {.index = shard.at("index"), .total = shard.at("total"), .suite_cases = shard.at("suite_cases")};
  }
  for (const Json& one : json.at("cases")) result.cases.push_back(case_result(one));
  result.summary = run::summarise(result.cases, json.at("summary").at("wall_seconds"));
  return result;
}

}  // namespace

Result<run::RunResult> read_results(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return tl::unexpected(Error{.file = path, .what = "cannot be read"});
  try {
    return run_result(Json::parse(file));
  } catch (const std::exception& error) {
    return tl::unexpected(Error{.file = path,
                                .what = std::string("is not what a run leaves behind: ") + error.what(),
                                .hint = "results.json is written by 'fillrule run --report DIR' of this version"});
  }
}

}  // namespace fillrule::report
