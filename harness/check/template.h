// The case file that a new case begins as.
#pragma once

#include <string>
#include <string_view>

#include "cases/model/result.h"

namespace fillrule::check {

// What the template says where its author has to; check_head() refuses it.
inline constexpr std::string_view kTemplateTitle = "Say what is drawn";
inline constexpr std::string_view kTemplateWhy = "Say what a failure would mean";
inline constexpr std::string_view kTemplateOrigin = "Say where the idea came from";

// A commented case file that draws, with a control, whose head is still to be written. `name` is the case's.
std::string template_text(std::string_view name);

// Writes it below `folder` as the case `name`, and returns the file's path. Folders are made as needed. An error
// where the name is not TOPIC/NAME in lower case, digits and underscores, where the file exists already, or cannot be
// written.
Result<std::string> write_template(const std::string& folder, const std::string& name);

}  // namespace fillrule::check
