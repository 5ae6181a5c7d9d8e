// Patterns for case names: * is any text (slashes included), ? any one character, everything else itself; brackets
// too, because sweeps put them into names.
#pragma once

#include <string_view>

namespace fillrule::format {

bool glob_matches(std::string_view pattern, std::string_view text);

// Whether some text that begins with `beginning` matches.
bool glob_can_match(std::string_view pattern, std::string_view beginning);

}  // namespace fillrule::format
