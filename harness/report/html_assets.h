// The files of harness/report/html/, embedded at build time.
#pragma once

#include <string_view>

namespace fillrule::report {

std::string_view html_template();
std::string_view html_style();
// All modules as one.
std::string_view html_script();

}  // namespace fillrule::report
