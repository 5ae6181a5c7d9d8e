// The errors of one file, collected while reading goes on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cases/model/result.h"

namespace fillrule::format {

// A place in a file; line and column count from 1, the column in characters.
struct Place {
  uint32_t line = 1;
  uint32_t column = 1;
};

class Diagnostics {
 public:
  explicit Diagnostics(std::string file) : file_(std::move(file)) {}

  // Beyond a hundred errors none is kept.
  void add(Place place, std::string what, std::string hint = {});
  // An error that an evaluation returned, which does not know its place.
  void add(Place place, const Error& error) { add(place, error.what, error.hint); }

  // The errors from number `first` on are of the case with this sweep suffix.
  void name_case(size_t first, const std::string& suffix);

  [[nodiscard]] size_t count() const { return errors_.size(); }
  [[nodiscard]] bool empty() const { return errors_.empty(); }
  [[nodiscard]] const std::string& file() const { return file_; }

  // In the order of the file.
  std::vector<Error> take();

 private:
  std::string file_;
  std::vector<Error> errors_;
};

}  // namespace fillrule::format
