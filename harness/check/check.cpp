#include "harness/check/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "harness/check/head.h"
#include "harness/check/sight.h"

namespace fillrule::check {
namespace {

constexpr std::string_view kControlHint =
    "name it in the head: control = \"topic/name\", or a value of the sweep, control = { size = 1 }";

// "size=1" and "w=2" of "topic/name[size=1,w=2]"; a value such as "ulp(1, 2)" has commas of its own.
std::vector<std::string_view> values_of(std::string_view name) {
  std::vector<std::string_view> values;
  const size_t bracket = name.find('[');
  if (bracket == std::string_view::npos) return values;
  size_t begin = bracket + 1;
  int depth = 0;
  for (size_t i = begin; i < name.size(); ++i) {
    if (name[i] == '(') ++depth;
    if (name[i] == ')') --depth;
    if (depth > 0 || (name[i] != ',' && i + 1 < name.size())) continue;
    values.push_back(name.substr(begin, i - begin));
    begin = i + 1;
  }
  return values;
}

// The values of a case's name that its control of the same file does not have; empty for one of another file.
std::string difference(std::string_view name, std::string_view control) {
  if (name.substr(0, name.find('[')) != control.substr(0, control.find('['))) return {};
  const std::vector<std::string_view> values = values_of(name);
  const std::vector<std::string_view> others = values_of(control);
  std::string text;
  for (size_t i = 0; i < values.size(); ++i) {
    if (i >= others.size() || values[i] == others[i]) continue;
    if (!text.empty()) text += ',';
    text.append(values[i]);
  }
  return text;
}

class Checker {
 public:
  Checker(std::span<const Case> cases, std::span<const Case> controls) {
    for (const Case& one : cases) cases_.try_emplace(one.name, &one);
    for (const Case& one : controls) cases_.try_emplace(one.name, &one);
  }

  // `file`: all cases of one file.
  void check_file(std::span<const Case> file) {
    for (Error& finding : check_head(file.front())) findings_.push_back(std::move(finding));
    const bool names_control = std::ranges::any_of(file, [](const Case& one) { return !one.control.empty(); });
    if (!names_control) {
      findings_.push_back(
          {.file = file.front().file, .what = "no control is named", .hint = std::string(kControlHint)});
    }
    for (const Case& one : file) check_case(one);
    for (auto& [what, finding] : of_cases_) {
      finding.error.what =
          fmt::format("{}{}: {}", finding.first_case,
                      finding.count == 1 ? "" : fmt::format(" and {} more", finding.count - 1), what);
      findings_.push_back(std::move(finding.error));
    }
    of_cases_.clear();
    check_effects(file.front().file);
  }

  std::vector<Error> take() { return std::move(findings_); }

 private:
  // What is wrong with several cases of a file in the same way is told once.
  struct CaseFinding {
    Error error;
    std::string first_case;
    size_t count = 0;
  };

  void add(const Case& one, const std::string& what, std::string hint) {
    CaseFinding& finding = of_cases_[what];
    if (++finding.count > 1) return;
    finding.first_case = one.name;
    finding.error = {.file = one.file, .hint = std::move(hint)};
  }

  // What there is to see of a case; null, and a finding, where it cannot be drawn.
  const Sight* sight_of(const Case& one) {
    const auto [place, fresh] = sights_.try_emplace(one.name);
    if (fresh) place->second = look_at(one);
    if (*place->second) return &**place->second;
    add(one, "cannot be drawn: " + place->second->error().what, place->second->error().hint);
    return nullptr;
  }

  void check_case(const Case& one) {
    const Sight* const sight = sight_of(one);
    if (sight == nullptr) return;
    check_drawn(one, *sight);
    if (one.control.empty()) return;
    const auto control = cases_.find(one.control);
    if (control == cases_.end() || one.control == one.name) {
      add(one, fmt::format("its control is no other case: \"{}\"", one.control), std::string(kControlHint));
      return;
    }
    const Sight* const beside = sight_of(*control->second);
    if (beside != nullptr) compare(one, *sight, *beside);
  }

  void check_drawn(const Case& one, const Sight& sight) {
    const bool nothing = sight.drawn == 0 && sight.allowed == 0;
    if (one.effect == Effect::kNothing && !nothing) {
      add(one, "draws something, although nothing is expected",
          fmt::format("{} samples are covered, {} may be", sight.drawn, sight.allowed));
    } else if (one.effect != Effect::kNothing && nothing) {
      add(one, "draws nothing",
          "if that is meant, say so: expect = \"nothing\", or of some cases expect = { nothing = [{ size = 0 }] }");
    } else if (one.effect != Effect::kNothing && sight.blank_passes) {
      add(one, "a blank picture passes",
          "the specification leaves open of every sample whether it is covered; draw something certain beside it");
    }
  }

  void compare(const Case& one, const Sight& sight, const Sight& control) {
    if (one.effect == Effect::kSame) {
      if (sight.coverage != control.coverage) {
        add(one, "covers other samples than its control, although the same are expected",
            "the control: " + one.control);
      }
      return;
    }
    bool& shows = shows_[difference(one.name, one.control)];
    shows = shows || sight.picture != control.picture;
  }

  // What is tested must matter somewhere: of the cases that differ from their control in the same way, at least one
  // looks different.
  void check_effects(const std::string& file) {
    for (const auto& [difference, shows] : shows_) {
      if (shows) continue;
      findings_.push_back(
          {.file = file,
           .what = fmt::format("{}no case looks other than its control: what is tested has no effect",
                               difference.empty() ? "" : difference + ": "),
           .hint =
               "if that is the point, say so: expect = \"same\", or of some cases expect = { same = [{ size = 2 }] "
               "}"});
    }
    shows_.clear();
  }

  std::unordered_map<std::string, const Case*> cases_;
  std::unordered_map<std::string, std::optional<Result<Sight>>> sights_;
  std::map<std::string, CaseFinding> of_cases_;  // of one file, by what is wrong
  std::map<std::string, bool> shows_;  // of one file, by how cases differ from their controls: do any look it?
  std::vector<Error> findings_;
};

}  // namespace

std::vector<Error> check_files(std::span<const Case> cases, std::span<const Case> controls) {
  Checker checker(cases, controls);
  while (!cases.empty()) {
    size_t count = 1;
    while (count < cases.size() && cases[count].file == cases.front().file) ++count;
    checker.check_file(cases.first(count));
    cases = cases.subspan(count);
  }
  return checker.take();
}

}  // namespace fillrule::check
