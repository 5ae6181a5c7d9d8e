#include "harness/ci_systems/junit.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <vector>

#include "harness/report/printable.h"
#include "harness/terminal/text.h"

namespace fillrule::ci_systems {
namespace {

using report::printable;
using run::CaseResult;
using run::Status;

// XML forbids control characters even where they are escaped: every text from outside is made printable.
void set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(value.c_str());
}

// A case that failed without a verdict: a party broke down.
bool is_error(const CaseResult& result) {
  return result.status == Status::kFailed && result.verdict.planes.empty();
}

struct Totals {
  uint64_t tests = 0;
  uint64_t failures = 0;
  uint64_t errors = 0;
  uint64_t skipped = 0;
  double seconds = 0;

  void add(const CaseResult& result) {
    ++tests;
    errors += is_error(result) ? 1 : 0;
    failures += result.status == Status::kFailed && !is_error(result) ? 1 : 0;
    skipped += result.status == Status::kSkipped ? 1 : 0;
    seconds += result.seconds;
  }

  void write(pugi::xml_node node) const {
    set(node, "tests", fmt::format("{}", tests));
    set(node, "failures", fmt::format("{}", failures));
    set(node, "errors", fmt::format("{}", errors));
    set(node, "skipped", fmt::format("{}", skipped));
    set(node, "time", fmt::format("{:.6f}", seconds));
  }
};

Totals totals_of(const std::vector<const CaseResult*>& cases) {
  Totals totals;
  for (const CaseResult* const one : cases) totals.add(*one);
  return totals;
}

std::string topic_of(const CaseResult& result) {
  const size_t slash = result.name.rfind('/');
  return slash == std::string::npos ? "cases" : printable(result.name.substr(0, slash));
}

// In the order in which the topics first occur.
struct Topic {
  std::string name;
  std::vector<const CaseResult*> cases;
};

std::vector<Topic> topics_of(const run::RunResult& result) {
  std::vector<Topic> topics;
  std::map<std::string, size_t> places;
  for (const CaseResult& one : result.cases) {
    const auto [place, fresh] = places.try_emplace(topic_of(one), topics.size());
    if (fresh) topics.push_back({.name = place->first, .cases = {}});
    topics[place->second].cases.push_back(&one);
  }
  return topics;
}

void write_properties(pugi::xml_node suite, const run::RunResult& result) {
  pugi::xml_node properties = suite.append_child("properties");
  const auto add = [&properties](const char* name, const std::string& value) {
    pugi::xml_node property = properties.append_child("property");
    set(property, "name", name);
    set(property, "value", printable(value));
  };
  add("candidate", result.candidate);
  add("reference", result.reference.driver);
  add("reference version", result.reference.version);
}

void write_outcome(pugi::xml_node test, const CaseResult& result) {
  if (result.status == Status::kPassed) return;
  if (result.status == Status::kSkipped) {
    set(test.append_child("skipped"), "message", printable(result.message));
    return;
  }
  const bool error = is_error(result);
  pugi::xml_node node = test.append_child(error ? "error" : "failure");
  set(node, "message", terminal::fault_text(result));
  set(node, "type",
      error                                   ? "broken down"
      : result.verdict.candidate_faults() > 0 ? "candidate fault"
                                              : "metamorphic check");
  node.append_child(pugi::node_pcdata).set_value(report::printable_lines(terminal::case_text(result, {})).c_str());
}

// `names`: those that are taken. Two names that differ in what is not printable may look the same.
void write_case(pugi::xml_node suite, const CaseResult& result, const Topic& topic, std::set<std::string>& names,
                const Attachments& attachments) {
  std::string name = printable(result.name);
  for (int n = 2; !names.insert(name).second; ++n) name = fmt::format("{} #{}", printable(result.name), n);
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "name", name);
  set(test, "classname", topic.name);
  set(test, "file", printable(result.file));
  set(test, "time", fmt::format("{:.6f}", result.seconds));
  write_outcome(test, result);
  std::string output;
  for (const std::string& path : attachments(result)) output += fmt::format("[[ATTACHMENT|{}]]\n", printable(path));
  if (!output.empty()) test.append_child("system-out").append_child(pugi::node_pcdata).set_value(output.c_str());
}

}  // namespace

std::string to_junit(const run::RunResult& result, const Attachments& attachments) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  set(declaration, "version", "1.0");
  set(declaration, "encoding", "UTF-8");
  pugi::xml_node root = document.append_child("testsuites");
  set(root, "name", "fillrule");
  Totals all;
  for (const CaseResult& one : result.cases) all.add(one);
  all.write(root);
  std::set<std::string> names;
  for (const Topic& topic : topics_of(result)) {
    pugi::xml_node suite = root.append_child("testsuite");
    set(suite, "name", topic.name);
    totals_of(topic.cases).write(suite);
    write_properties(suite, result);
    for (const CaseResult* const one : topic.cases) write_case(suite, *one, topic, names, attachments);
  }
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace fillrule::ci_systems
