// How every library of the project reports an error: it returns one. Only the command line prints and exits.
#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>

namespace fillrule {

// What went wrong and where. `line` and `column` count from 1, 0 where there is no place in a file to name.
struct Error {
  std::string file;
  uint32_t line = 0;
  uint32_t column = 0;
  std::string what;
  std::string hint;  // what to do about it; empty if nothing useful can be said
};

template <typename T>
using Result = tl::expected<T, Error>;

// "file:line:column: what", then the hint on a line of its own; the parts that are absent are left out.
std::string to_string(const Error& error);

// An error that belongs to no file.
tl::unexpected<Error> failure(std::string what, std::string hint = {});

}  // namespace fillrule
