// Finds what is wrong with an OBJ file, line by line, before tinyobjloader reads it: that one takes bad numbers for 0
// and tells of few mistakes where they are.
#pragma once

#include <string>
#include <string_view>

#include "cases/model/result.h"

namespace fillrule::mesh {

// The lines that say something of the geometry: v, vt, vn, f, g, o and s, with continued lines joined. An error names
// file, line and what is wrong there: a coordinate that is no finite number, a face of fewer than three vertices, an
// index that names nothing.
Result<std::string> checked_obj(std::string_view text, const std::string& file_label);

}  // namespace fillrule::mesh
