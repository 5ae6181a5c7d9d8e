#include "harness/check/head.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "cases/format/suggestion.h"
#include "harness/check/sections.h"
#include "harness/check/template.h"

namespace fillrule::check {
namespace {

std::string_view trimmed(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\n") - first + 1);
}

class HeadChecker {
 public:
  explicit HeadChecker(const Case& head) : head_(head) {}

  std::vector<Error> check() {
    check_words("title", head_.title, kTemplateTitle);
    check_words("why", head_.why, kTemplateWhy);
    check_words("origin", head_.origin, kTemplateOrigin);
    check_sections();
    return std::move(findings_);
  }

 private:
  void add(std::string what, std::string hint) {
    findings_.push_back({.file = head_.file, .what = std::move(what), .hint = std::move(hint)});
  }

  void check_words(std::string_view key, std::string_view text, std::string_view of_template) {
    if (trimmed(text).empty()) {
      add(fmt::format("{} is empty", key), std::string(of_template));
    } else if (text.starts_with(of_template)) {
      add(fmt::format("{} is still the template's", key), std::string(of_template));
    }
  }

  // Sections one after the other, separated by semicolons.
  void check_sections() {
    std::string_view rest = head_.spec;
    while (true) {
      const size_t end = rest.find(';');
      const std::string_view section = trimmed(rest.substr(0, end));
      if (std::ranges::find(kSections, section) == kSections.end()) {
        const std::vector<std::string> known(kSections.begin(), kSections.end());
        add(fmt::format("spec: \"{}\" is no section that is known", section),
            format::suggestion(section, known, "sections of the Vulkan specification, separated by semicolons"));
      }
      if (end == std::string_view::npos) return;
      rest.remove_prefix(end + 1);
    }
  }

  const Case& head_;
  std::vector<Error> findings_;
};

}  // namespace

std::vector<Error> check_head(const Case& head) {
  return HeadChecker(head).check();
}

}  // namespace fillrule::check
