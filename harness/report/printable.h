// Text from outside, made harmless: names of cases and files, and messages that hold them, may have control
// characters, escape sequences, marks that turn the direction of writing, or bytes that are no UTF-8. What comes out
// is valid UTF-8 of visible characters alone, so neither a terminal nor an XML parser is led astray. The unit of
// width is the column.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fillrule::report {

// One line: everything invisible becomes \x1b or \u{202e}, a byte that is no UTF-8 \xff.
std::string printable(std::string_view text);

// The same of several lines; their ends stay.
std::string printable_lines(std::string_view text);

// Of printable text.
size_t columns_of(std::string_view text);

// Printable text that is wider than that with its middle cut out: "coverage/a_very_lo...ng_name". 0: no limit.
std::string shortened(std::string_view text, size_t columns);

// Printable text broken at spaces into lines no wider than that, the ones after the first indented. A word that is
// wider has a line of its own. 0: no limit.
std::string wrapped(std::string_view text, size_t columns, size_t indent);

}  // namespace fillrule::report
