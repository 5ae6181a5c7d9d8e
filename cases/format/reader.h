// Reads case files: TOML in, cases out, with every sweep expanded and every position in clip space.
//
// cases/README.md describes the format.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/result.h"

namespace fillrule::format {

// All cases of one file in the order of its sweep. A file with an error has no cases, and all the errors that could
// be found.
struct CaseFile {
  std::vector<Case> cases;
  std::vector<Error> errors;
};

// The whole file. Fails, naming it and the reason, for what cannot be read.
Result<std::string> read_text(const std::string& path);

// `name` is the cases' name before the sweep's suffix: "clipping/near_plane".
CaseFile read_file(const std::string& path, const std::string& name);

// The same for text in memory; errors call it `file_label`.
CaseFile parse(std::string_view text, const std::string& file_label, const std::string& name);

}  // namespace fillrule::format
