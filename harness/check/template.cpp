#include "harness/check/template.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace fillrule::check {
namespace {

namespace fs = std::filesystem;

// {0} title, {1} why, {2} origin. Every line draws as it stands.
constexpr std::string_view kTemplate =
    R"(# A case file; cases/README.md documents all keys. Replace what the head says, then the geometry.
title = "{0}, for instance: A triangle whose corner moves past a pixel centre"
why = "{1}: what would the picture of a wrong rasterizer look like, and which mistake makes it so?"
# Which sections of the Vulkan specification decide, separated by semicolons.
spec = "Basic Polygon Rasterization"
# "constructed", or a test suite, or the thread of a bug: owner/repository#number.
origin = "{2}"
tags = ["subpixel"]
# The case beside each that differs in nothing but what is tested: a value of the sweep, or another case by its name,
# control = "coverage/shared_diagonal". What stands there must look different; where it should not, add
# expect = "same", and where nothing should be drawn, expect = "nothing".
control = {{ shift = 0 }}

[target]
size = [32, 32]              # pixels; small is fast

[varyings]
uv = "smooth"

# One case for each value: {3}[shift=0], {3}[shift=1] and so on.
[sweep]
shift = [0, 1, 128]          # in subpixels, 1/256 pixel

[[draw]]
space = "framebuffer"        # pixels from the top left corner; or "clip", "ndc"
positions = [["8.5 + shift / 256", 8.5], [24.5, 8.5], [8.5, 24.5]]

[draw.varyings]
uv = [[0, 0], [1, 0], [0, 1]]
)";

bool is_name(std::string_view text) {
  const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  return !text.empty() && std::ranges::all_of(text, fits);
}

// TOPIC/NAME, the topic of one or more parts.
bool is_case_name(std::string_view name) {
  if (name.find('/') == std::string_view::npos) return false;
  while (true) {
    const size_t end = name.find('/');
    if (!is_name(name.substr(0, end))) return false;
    if (end == std::string_view::npos) return true;
    name.remove_prefix(end + 1);
  }
}

}  // namespace

std::string template_text(std::string_view name) {
  return fmt::format(kTemplate, kTemplateTitle, kTemplateWhy, kTemplateOrigin, name);
}

Result<std::string> write_template(const std::string& folder, const std::string& name) {
  if (!is_case_name(name)) {
    return failure(fmt::format("\"{}\" is no name for a case", name),
                   "a name is TOPIC/NAME in lower case letters, digits and underscores, without an ending, and says "
                   "what the case shows: coverage/corner_past_a_centre");
  }
  const fs::path path = fs::path(folder) / (name + ".toml");
  const std::string file = path.generic_string();
  std::error_code error;
  if (fs::exists(path, error)) {
    return tl::unexpected(Error{.file = file, .what = "is there already", .hint = "nothing is ever overwritten"});
  }
  fs::create_directories(path.parent_path(), error);
  if (error) return tl::unexpected(Error{.file = file, .what = "its folder cannot be made: " + error.message()});
  std::ofstream stream(path, std::ios::binary);
  stream << template_text(name) << std::flush;
  if (!stream) return tl::unexpected(Error{.file = file, .what = "cannot be written"});
  return file;
}

}  // namespace fillrule::check
