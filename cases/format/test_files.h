// What the tests of the reader share: the shortest file around a text, and its errors as one text.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "cases/format/reader.h"
#include "cases/model/case.h"

namespace fillrule::format {

// Three lines.
inline const std::string kHead = "title = 't'\nwhy = 'w'\nspec = 's'\n";
inline const std::string kDraw = "[[draw]]\npositions = [[0, 0, 0, 1]]\n";

// The errors of a file of this text after kHead, whose first line is line 4; one after the other.
inline std::string errors_of(const std::string& body) {
  std::string text;
  for (const Error& error : parse(kHead + body, "a.toml", "a").errors) text += to_string(error) + '\n';
  return text;
}

// The errors of a file with this text and a draw that is good.
inline std::string errors_with_draw(const std::string& body) {
  return errors_of(body + kDraw);
}

// The cases of a file of this text after kHead; its errors are told on the way.
inline std::vector<Case> cases_of(const std::string& body) {
  CaseFile file = parse(kHead + body, "a.toml", "a");
  for (const Error& error : file.errors) ADD_FAILURE() << to_string(error);
  return std::move(file.cases);
}

// The only case; an empty one if there is none.
inline Case case_of(const std::string& body) {
  std::vector<Case> cases = cases_of(body);
  if (cases.size() != 1) ADD_FAILURE() << cases.size() << " cases instead of one";
  return cases.empty() ? Case{} : std::move(cases.front());
}

}  // namespace fillrule::format
