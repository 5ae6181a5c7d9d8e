// What can be turned on and off in a view.
#pragma once

#include <optional>
#include <string>

#include "cases/model/case.h"
#include "cases/model/scene.h"
#include "harness/view/actions.h"

namespace fillrule::view {

class Switches {
 public:
  // All as in the file.
  explicit Switches(const Case& looked_at);

  // What the switch is at now, in words; empty of an action that is no switch.
  std::string flip(Action action);

  // What has not been flipped stays as it is.
  void apply(RasterState& state) const;
  void apply(Scene& scene) const;

  [[nodiscard]] bool own_size() const { return own_size_; }  // the file's, not the window's

 private:
  std::optional<bool> wireframe_;
  std::optional<bool> culling_;
  bool is_wireframe_ = false;  // in the file
  bool is_culling_ = false;
  bool texture_ = true;
  bool lights_ = true;
  bool own_size_ = false;
};

}  // namespace fillrule::view
