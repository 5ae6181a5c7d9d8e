#include "cases/model/result.h"

#include <fmt/format.h>

#include <utility>

namespace fillrule {

std::string to_string(const Error& error) {
  std::string text = error.file;
  if (error.line != 0) text += fmt::format(":{}:{}", error.line, error.column);
  if (!text.empty()) text += ": ";
  text += error.what;
  if (!error.hint.empty()) text += fmt::format("\n  hint: {}", error.hint);
  return text;
}

tl::unexpected<Error> failure(std::string what, std::string hint) {
  return tl::unexpected(Error{.what = std::move(what), .hint = std::move(hint)});
}

}  // namespace fillrule
