#include "harness/report/json.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "harness/report/names.h"

namespace fillrule::report {
namespace {

using Json = nlohmann::ordered_json;

// JSON has no NaN and no infinity: those become text.
Json number(double value) {
  if (std::isfinite(value)) return value;
  if (std::isnan(value)) return "nan";
  return value > 0 ? "inf" : "-inf";
}

Json record_json(const judge::SampleRecord& record) {
  Json json{{"x", record.x},
            {"y", record.y},
            {"sample", record.sample},
            {"component", record.component},
            {"verdict", name_of(record.verdict)},
            {"candidate", number(record.candidate)},
            {"expected", number(record.expected)},
            {"tolerance", number(record.tolerance)},
            {"severity", number(record.severity)}};
  if (record.reference) json["reference"] = number(*record.reference);
  return json;
}

Json plane_json(const judge::PlaneVerdict& plane) {
  Json json{{"identical", plane.count(judge::Verdict::kIdentical)},
            {"permitted", plane.count(judge::Verdict::kPermitted)},
            {"imprecise", plane.count(judge::Verdict::kImprecise)},
            {"candidate_faults", plane.candidate_faults()},
            {"reference_faults", plane.reference_faults()},
            {"both_at_fault", plane.count(judge::Verdict::kBothFault)},
            {"components", plane.components}};
  if (plane.bounds) {
    json["bounds"] = {plane.bounds->min_x, plane.bounds->min_y, plane.bounds->max_x, plane.bounds->max_y};
  }
  if (plane.first) json["first"] = record_json(*plane.first);
  if (plane.worst) json["worst"] = record_json(*plane.worst);
  return json;
}

Json case_json(const run::CaseResult& result) {
  Json planes = Json::object();
  for (const judge::PlaneVerdict& plane : result.verdict.planes) planes[plane.name] = plane_json(plane);
  Json json{{"name", result.name},
            {"file", result.file},
            {"status", name_of(result.status)},
            {"show", result.show_command},
            {"explain", result.explain_command},
            {"seconds", result.seconds},
            {"samples", result.verdict.samples},
            {"covered_samples", result.verdict.covered_samples},
            {"may_samples", result.verdict.may_samples},
            {"undefined_samples", result.verdict.undefined_samples},
            {"planes", std::move(planes)}};
  if (!result.message.empty()) json["message"] = result.message;
  if (!result.reason.empty()) json["reason"] = result.reason;
  json["checks"] = Json::array();
  for (const judge::CheckResult& check : result.checks) {
    json["checks"].push_back({{"name", check.name}, {"outcome", name_of(check.outcome)}, {"message", check.message}});
  }
  return json;
}

Json deviations_json(const run::DeviationReport& deviations) {
  const auto faults_json = [](const std::vector<run::DeviationReport::Fault>& faults) {
    Json json = Json::array();
    for (const auto& fault : faults) {
      json.push_back({{"case", fault.case_name}, {"plane", fault.plane}, {"samples", fault.samples}});
    }
    return json;
  };
  Json gone = Json::array();
  for (const run::Deviation& one : deviations.gone) gone.push_back({{"cases", one.cases}, {"planes", one.planes}});
  return {{"known", faults_json(deviations.known)},
          {"unexpected", faults_json(deviations.unexpected)},
          {"gone", std::move(gone)}};
}

Json timing_json(const run::RunTiming& timing) {
  return {{"wall_seconds", timing.wall_seconds},
          {"processor_seconds", timing.processor_seconds},
          {"reference_seconds", timing.reference_seconds()},
          {"candidate_seconds", timing.candidate_seconds},
          {"oracle_seconds", timing.oracle_seconds},
          {"judge_seconds", timing.judge_seconds},
          {"check_seconds", timing.check_seconds}};
}

}  // namespace

std::string to_json(const run::RunResult& result, const run::DeviationReport& deviations) {
  const run::Summary& summary = result.summary;
  Json json{{"summary",
             {{"cases", summary.cases},
              {"passed", summary.passed},
              {"failed", summary.failed},
              {"skipped", summary.skipped},
              {"identical", summary.identical},
              {"permitted", summary.permitted},
              {"imprecise", summary.imprecise},
              {"candidate_faults", summary.candidate_faults},
              {"reference_faults", summary.reference_faults},
              {"failed_checks", summary.failed_checks},
              {"wall_seconds", summary.wall_seconds}}},
            {"candidate", {{"name", result.candidate}, {"subpixel_bits", result.candidate_subpixel_bits}}},
            {"reference",
             {{"driver", result.reference.driver},
              {"name", result.reference.name},
              {"version", result.reference.version},
              {"subpixel_bits", result.reference.subpixel_bits}}},
            {"profile", result.profile},
            {"timing", timing_json(result.timing.run)}};
  if (result.shard.total > 1) {
    json["shard"] = {
        {"index", result.shard.index}, {"total", result.shard.total}, {"suite_cases", result.shard.suite_cases}};
  }
  if (result.timing.warm) {
    json["timing"]["warm"] = {{"suite", timing_json(result.timing.warm->suite)},
                              {"reference_alone", timing_json(result.timing.warm->reference_alone)}};
  }
  json["deviations"] = deviations_json(deviations);
  json["cases"] = Json::array();
  for (const run::CaseResult& one : result.cases) json["cases"].push_back(case_json(one));
  // Names come from file paths, which need not be UTF-8.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<void> write_text(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) return tl::unexpected(Error{.file = path, .what = "cannot be written"});
  return {};
}

}  // namespace fillrule::report
