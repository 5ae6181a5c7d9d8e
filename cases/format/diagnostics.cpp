#include "cases/format/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace fillrule::format {
namespace {

// A generated file may be wrong in every line; nobody reads on.
constexpr size_t kMaxErrors = 100;

}  // namespace

void Diagnostics::add(Place place, std::string what, std::string hint) {
  if (errors_.size() >= kMaxErrors) return;
  errors_.push_back(Error{
      .file = file_, .line = place.line, .column = place.column, .what = std::move(what), .hint = std::move(hint)});
}

void Diagnostics::name_case(size_t first, const std::string& suffix) {
  for (size_t i = first; i < errors_.size(); ++i) errors_[i].what += fmt::format(" (in case {})", suffix);
}

std::vector<Error> Diagnostics::take() {
  std::stable_sort(errors_.begin(), errors_.end(), [](const Error& a, const Error& b) {
    return std::tie(a.line, a.column) < std::tie(b.line, b.column);
  });
  return std::exchange(errors_, {});
}

}  // namespace fillrule::format
