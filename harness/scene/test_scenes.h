// What the tests of scenes share: scenes from text and from the suite, and who draws them.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cases/format/reader.h"
#include "cases/format/suite.h"
#include "harness/scene/build.h"
#include "harness/scene/painters.h"

namespace fillrule::scene {

inline const std::string kCases = FILLRULE_SOURCE_DIR "/cases";

// The case of a file with this [scene] and [state]; not built.
inline Case parsed_scene(const std::string& text) {
  format::CaseFile file = format::parse("title = 't'\nwhy = 'w'\nspec = 's'\n" + text, "a.toml", "a");
  for (const Error& error : file.errors) ADD_FAILURE() << to_string(error);
  if (file.cases.size() != 1) ADD_FAILURE() << file.cases.size() << " cases";
  return file.cases.empty() ? Case{} : std::move(file.cases.front());
}

inline Case built_scene(const Case& parsed, Assets& assets) {
  Result<Case> built = build(parsed, assets);
  if (!built) ADD_FAILURE() << to_string(built.error());
  return built ? std::move(*built) : Case{};
}

// Built cases of the suite, by their names.
inline std::vector<Case> suite_scenes(const std::string& pattern, Assets& assets) {
  format::Suite suite = format::load_suite(kCases, std::vector{pattern});
  build_scenes(suite, assets);
  for (const Error& error : suite.errors) ADD_FAILURE() << to_string(error);
  return std::move(suite.cases);
}

inline Planes painted(const Case& built, Assets& assets, const Painter& paint) {
  const auto shading = shading_of(built, assets);
  if (!shading) {
    ADD_FAILURE() << to_string(shading.error());
    return {};
  }
  Result<Planes> planes = paint(built, *shading);
  if (!planes) ADD_FAILURE() << to_string(planes.error());
  return planes ? std::move(*planes) : Planes{};
}

// Lavapipe under the validation layers.
inline const Painter& lavapipe() {
  // Never destroyed: the layers' own static objects would be gone by then, and what they keep would not be freed.
  static const Painter* const painter =
      std::make_unique<Painter>(driver_painter_on_demand({.driver = "lavapipe", .validation = true})).release();
  return *painter;
}

}  // namespace fillrule::scene
