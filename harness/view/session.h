// Everything behind the window: a view, its pictures, and what the user does and is told.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/result.h"
#include "harness/run/suite_runner.h"
#include "harness/view/image.h"
#include "harness/view/input.h"
#include "harness/view/layout.h"
#include "harness/view/parties.h"
#include "harness/view/view.h"

namespace fillrule::view {

struct SessionOptions {
  run::RunOptions run;       // candidate, reference, threads, profile
  bool is_judged = true;     // false: the candidate alone
  std::string folder = ".";  // where views are baked to
};

class Session {
 public:
  // Of a case that is not built. Errors: what cannot be read; a party that is not there.
  static Result<Session> create(Case looked_at, const SessionOptions& options);
  Session(Session&& other) noexcept;
  Session& operator=(Session&& other) noexcept;
  ~Session();

  [[nodiscard]] size_t pane_count() const;
  [[nodiscard]] bool is_scene() const;
  void resize(int window_width, int window_height);

  void handle(const Input& input);
  void do_action(const ActionRow& action, const Input& input);

  // So many seconds later: draws what has changed, and takes what is finished.
  void advance(double seconds);
  // Until the view as it is now is drawn and judged.
  void settle();

  struct Pane {
    std::string title;
    Rect room;
    const Image* image = nullptr;  // null: nothing yet
    Placement placement;           // of the image
    uint64_t stamp = 0;            // another one for each image
  };
  [[nodiscard]] std::vector<Pane> panes() const;

  // The mismatch that is looked at.
  [[nodiscard]] const Mismatch* mismatch() const;

  [[nodiscard]] std::string window_title() const;
  [[nodiscard]] std::string status() const;
  [[nodiscard]] bool shows_help() const;
  [[nodiscard]] bool is_over() const;  // quit

 private:
  struct State;
  explicit Session(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace fillrule::view
