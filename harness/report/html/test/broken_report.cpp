// broken_report FOLDER FAULT REFERENCE CASE...: judges a renderer that is broken on purpose, and leaves its report,
// with truth.json beside it: the planes of the first failing case, plain, to hold the page against. FAULT names are
// printed without arguments; with the fault "hostile" the renderer shifts its pictures, and the cases have names that
// might break a page.
#include <fmt/core.h>

#include <bit>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cases/format/suite.h"
#include "harness/report/failures.h"
#include "harness/report/html/test/faults.h"
#include "harness/report/json.h"
#include "harness/scene/build.h"

namespace {

using fillrule::Case;
using Json = nlohmann::ordered_json;

std::vector<std::string> hostile_names() {
  return {"</script><script>window.broken = true</script>",
          "<img src=x onerror='window.broken = true'>",
          "quotes \" ' ` & &amp; <b>bold</b> <!-- ",
          "\xe2\x80\xaeturned round \xf0\x9f\x94\xba \xe4\xb8\x89\xe8\xa7\x92\xe5\xbd\xa2",
          "not UTF-8: \xff\xfe",
          std::string(3000, 'w'),
          "#case=&plane=?%zz+"};
}

Json words(const std::vector<uint32_t>& plane) {
  return plane;
}

Json words(const std::vector<float>& plane) {
  Json json = Json::array();
  for (const float value : plane) json.push_back(std::bit_cast<uint32_t>(value));
  return json;
}

Json planes_json(const fillrule::Planes& planes) {
  Json json{{"hits", words(planes.hits)},
            {"owner", words(planes.owner)},
            {"front_facing", words(planes.front_facing)},
            {"depth", words(planes.depth)},
            {"varyings", Json::array()}};
  for (const auto& plane : planes.varyings) json["varyings"].push_back(words(plane));
  return json;
}

Json verdicts_json(const fillrule::judge::CaseVerdict& verdict) {
  Json json = Json::object();
  for (const auto& plane : verdict.planes) {
    Json& map = json[plane.name] = Json::array();
    for (const auto one : plane.map) map.push_back(static_cast<int>(one));
  }
  return json;
}

// The planes of the first case that failed.
fillrule::Result<void> write_truth(const std::string& file, fillrule::run::SuiteRunner& runner,
                                   const std::vector<Case>& cases, const fillrule::run::RunResult& result) {
  for (size_t i = 0; i < cases.size(); ++i) {
    if (result.cases[i].status != fillrule::run::Status::kFailed) continue;
    const auto drawing = runner.draw(cases[i]);
    if (!drawing) return tl::unexpected(drawing.error());
    Json json{{"name", cases[i].name},
              {"width", drawing->candidate.width},
              {"height", drawing->candidate.height},
              {"samples", drawing->candidate.samples},
              {"candidate", planes_json(drawing->candidate)},
              {"verdicts", verdicts_json(drawing->verdict)}};
    if (drawing->reference) json["reference"] = planes_json(*drawing->reference);
    return fillrule::report::write_text(file, json.dump(-1, ' ', false, Json::error_handler_t::replace));
  }
  return {};
}

int fail(const fillrule::Error& error) {
  fmt::print(stderr, "{}\n", to_string(error));
  return 2;
}

int write_report(const std::string& folder, const std::string& fault, const std::string& reference,
                 const std::vector<std::string>& selectors) {
  const bool hostile = fault == "hostile";
  auto candidate = fillrule::report::make_broken(hostile ? "shifted" : fault);
  if (!candidate) return fail(candidate.error());
  fillrule::format::Suite suite = fillrule::scene::load_suite(FILLRULE_SOURCE_DIR "/cases", selectors);
  for (const fillrule::Error& error : suite.errors) return fail(error);
  const std::vector<std::string> names = hostile_names();
  for (size_t i = 0; hostile && i < suite.cases.size(); ++i) suite.cases[i].name = names[i % names.size()];
  const fillrule::run::RunOptions options{
      .reference = reference, .profile = {.top_left = true}, .checks = false, .jobs = 2};
  auto runner = fillrule::run::SuiteRunner::create(options, std::move(*candidate));
  if (!runner) return fail(runner.error());
  fillrule::run::RunResult result = runner->run(suite.cases);
  for (fillrule::run::CaseResult& one : result.cases) {
    one.show_command = fmt::format("fillrule show '{}'", one.name);
    if (const auto worst = one.verdict.worst()) {
      one.explain_command = fmt::format("fillrule explain '{}' --pixel {},{}", one.name, worst->x, worst->y);
    }
  }
  const auto deviations = fillrule::run::compare_with_known(result.cases, {});
  std::filesystem::create_directories(folder);
  const auto files = fillrule::report::write_failures(folder, folder + "/faults.json", *runner, options.profile,
                                                      suite.cases, result, deviations, options.jobs);
  for (const fillrule::Error& error : files.errors) return fail(error);
  const auto written =
      fillrule::report::write_text(folder + "/results.json", fillrule::report::to_json(result, deviations));
  if (!written) return fail(written.error());
  if (const auto truth = write_truth(folder + "/truth.json", *runner, suite.cases, result); !truth) {
    return fail(truth.error());
  }
  fmt::print("{} of {} cases failed\n", result.summary.failed, result.summary.cases);
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() < 4) {
    for (const std::string_view name : fillrule::report::broken_candidates()) fmt::print("{}\n", name);
    return 0;
  }
  return write_report(arguments[0], arguments[1], arguments[2], {arguments.begin() + 3, arguments.end()});
} catch (const std::exception& error) {
  std::fputs(error.what(), stderr);
  return 2;
}
