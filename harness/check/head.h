// The head of a case file: the words in it.
#pragma once

#include <vector>

#include "cases/model/case.h"
#include "cases/model/result.h"

namespace fillrule::check {

// What is wrong with the words of a head: empty, those of the template, or naming no section of the specification.
std::vector<Error> check_head(const Case& head);

}  // namespace fillrule::check
