// "Did you mean": what a misspelt word was probably meant to be.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fillrule::format {

// The candidate nearest to `text` by edit distance (insert, delete, replace, swap of neighbours), if one is near.
std::optional<std::string> closest(std::string_view text, const std::vector<std::string>& candidates);

// `did you mean "near"?`, or `<label>: a, b, c` if none is near; empty if there are no candidates.
std::string suggestion(std::string_view text, const std::vector<std::string>& candidates, std::string_view label);

}  // namespace fillrule::format
