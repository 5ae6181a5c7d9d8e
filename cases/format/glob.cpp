#include "cases/format/glob.h"

#include <algorithm>
#include <vector>

namespace fillrule::format {
namespace {

// reached[i]: the text so far matches the pattern's first i characters.
using Reached = std::vector<bool>;

// A star also matches nothing.
void skip_stars(std::string_view pattern, Reached& reached) {
  for (size_t i = 0; i < pattern.size(); ++i) {
    if (reached[i] && pattern[i] == '*') reached[i + 1] = true;
  }
}

Reached match(std::string_view pattern, std::string_view text) {
  Reached reached(pattern.size() + 1, false);
  reached[0] = true;
  skip_stars(pattern, reached);
  for (const char c : text) {
    Reached next(pattern.size() + 1, false);
    for (size_t i = 0; i < pattern.size(); ++i) {
      if (!reached[i]) continue;
      if (pattern[i] == '*') next[i] = true;
      if (pattern[i] == '?' || pattern[i] == c) next[i + 1] = true;
    }
    reached = std::move(next);
    if (std::find(reached.begin(), reached.end(), true) == reached.end()) break;
    skip_stars(pattern, reached);
  }
  return reached;
}

}  // namespace

bool glob_matches(std::string_view pattern, std::string_view text) {
  return match(pattern, text).back();
}

bool glob_can_match(std::string_view pattern, std::string_view beginning) {
  const Reached reached = match(pattern, beginning);
  return std::find(reached.begin(), reached.end(), true) != reached.end();
}

}  // namespace fillrule::format
