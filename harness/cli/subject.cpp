#include "harness/cli/subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "cases/format/suite.h"
#include "harness/scene/model_scene.h"

namespace fillrule::cli {

Result<Case> find_subject(const SuiteOptions& options, scene::Assets& assets, const std::string& command) {
  const std::string& name = options.selectors.front();
  if (name.ends_with(".obj")) return scene::scene_of_model(name, assets);
  const format::Suite suite = format::load_suite(options.root, options.selectors);
  if (!suite.errors.empty()) return tl::unexpected(suite.errors.front());
  if (suite.cases.size() != 1) {
    return failure(fmt::format("{} cases match \"{}\"; {} draws one", suite.cases.size(), name, command),
                   fmt::format("for instance \"{}\"", suite.cases.front().name));
  }
  return suite.cases.front();
}

Result<std::pair<uint32_t, uint32_t>> parse_size(const std::string& text) {
  std::pair<uint32_t, uint32_t> size;
  const size_t times = std::min(text.find('x'), text.size());
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), text.data() + times, size.first);
  const auto second = std::from_chars(std::min(text.data() + times + 1, end), end, size.second);
  const auto is_good = [](uint32_t pixels) { return pixels >= 1 && pixels <= kMaxTargetSize; };
  const bool is_whole = first.ptr == text.data() + times && second.ptr == end;
  if (!is_whole || first.ec != std::errc() || second.ec != std::errc() || !is_good(size.first) ||
      !is_good(size.second)) {
    return failure(fmt::format("--size takes WIDTHxHEIGHT, not \"{}\"", text),
                   fmt::format("each 1 to {}, for instance 640x480", kMaxTargetSize));
  }
  return size;
}

}  // namespace fillrule::cli
