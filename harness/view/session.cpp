#include "harness/view/session.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "harness/view/bake.h"
#include "harness/view/gallery.h"

namespace fillrule::view {
struct Session::State {
  SessionOptions options;
  View view;
  std::unique_ptr<Gallery> gallery;

  size_t mismatch = 0;
  bool looks_at_mismatch = false;
  int window_width = 1;
  int window_height = 1;
  glm::dvec2 mouse{0};
  size_t mouse_pane = 0;
  bool is_held = false;  // a button of the mouse
  std::string told;      // the answer to the last action
  bool shows_help = false;
  bool is_over = false;

  State(SessionOptions the_options, View the_view, std::unique_ptr<Gallery> the_gallery)
      : options(std::move(the_options)), view(std::move(the_view)), gallery(std::move(the_gallery)) {}

  [[nodiscard]] size_t pane_count() const { return gallery->has_reference() ? 3 : gallery->has_judge() ? 2 : 1; }

  void fill(Pane& pane, const Image& image, uint64_t version, uint64_t stamp) const {
    if (image.rgba.empty()) return;
    pane.image = &image;
    pane.stamp = stamp;
    pane.placement = place(pane.room, image.width, image.height);
    if (version != gallery->version()) pane.title += " (of an earlier view)";
  }

  [[nodiscard]] std::vector<Pane> panes() const {
    std::vector<Pane> panes(pane_count());
    const std::vector<Rect> rooms = panes_of(window_width, window_height, panes.size());
    for (size_t i = 0; i < panes.size(); ++i) panes[i].room = rooms[i];
    const Picture& candidate = gallery->candidate();
    panes.front().title = "candidate";
    if (candidate.error.empty()) fill(panes.front(), candidate.image, candidate.version, candidate.stamp);
    if (gallery->has_reference()) {
      panes[1].title = "reference";
      const auto& reference = gallery->reference();
      if (reference) fill(panes[1], reference->image, reference->version, reference->stamp);
    }
    if (gallery->has_judge()) {
      panes.back().title = "difference";
      const auto& verdict = gallery->verdict();
      if (verdict) fill(panes.back(), verdict->judged.difference, verdict->judged.version, verdict->stamp);
    }
    return panes;
  }

  void take() {
    if (!gallery->take()) return;
    mismatch = 0;
    looks_at_mismatch = false;
  }

  // Where the mouse is on the picture of the pane that it is in, or was when its button was pressed.
  [[nodiscard]] glm::dvec2 picture_point() const {
    const std::vector<Pane> all = panes();
    const Pane& pane = all[std::min(mouse_pane, all.size() - 1)];
    const Image& image = gallery->candidate().image;
    return place(pane.room, image.width, image.height).picture_point(mouse);
  }

  void move_mouse(const glm::dvec2& to) {
    mouse = to;
    if (!is_held && view.during() == During::kAnything) {
      const std::vector<Pane> all = panes();
      for (size_t i = 0; i < all.size(); ++i) {
        if (mouse.x >= all[i].room.x) mouse_pane = i;
      }
    }
    view.mouse_moved(picture_point());
  }

  [[nodiscard]] std::string next_mismatch() {
    if (!gallery->has_judge()) return "nobody judges: there is no reference";
    const Judged* const judged = gallery->current_verdict();
    if (judged == nullptr) return "not judged yet";
    const std::vector<Mismatch>& all = judged->mismatches;
    if (all.empty()) return "no mismatch";
    mismatch = looks_at_mismatch ? (mismatch + 1) % all.size() : 0;
    looks_at_mismatch = true;
    return fmt::format("mismatch {} of {}: {}", mismatch + 1, all.size(), all[mismatch].text);
  }

  [[nodiscard]] std::string bake_view() {
    const Result<Drawable> drawable = view.drawable();
    if (!drawable) return to_string(drawable.error());
    const Result<std::string> path = bake(drawable->built, options.folder);
    return path ? "baked: " + *path : to_string(path.error());
  }

  void do_action(const ActionRow& action, const Input& input) {
    told.clear();
    switch (action.action) {
      case Action::kHelp:
        shows_help = !shows_help;
        break;
      case Action::kQuit:
        is_over = true;
        break;
      case Action::kNextMismatch:
        told = next_mismatch();
        break;
      case Action::kBake:
        told = bake_view();
        break;
      default:
        told = view.begin(action, input, picture_point());
    }
  }
};

Session::Session(std::unique_ptr<State> state) : state_(std::move(state)) {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

Result<Session> Session::create(Case looked_at, const SessionOptions& options) {
  Result<View> view = View::create(std::move(looked_at));
  if (!view) return tl::unexpected(view.error());
  auto gallery = Gallery::create(options.run, options.is_judged, view->is_scene());
  if (!gallery) return tl::unexpected(gallery.error());
  return Session(std::make_unique<State>(options, std::move(*view), std::move(*gallery)));
}

size_t Session::pane_count() const {
  return state_->pane_count();
}

bool Session::is_scene() const {
  return state_->view.is_scene();
}

void Session::resize(int window_width, int window_height) {
  state_->window_width = window_width;
  state_->window_height = window_height;
  const Rect room = state_->panes().front().room;
  state_->view.resize(static_cast<uint32_t>(room.width), static_cast<uint32_t>(room.height));
}

void Session::handle(const Input& input) {
  State& state = *state_;
  switch (input.kind) {
    case Input::Kind::kMove:
      state.move_mouse({input.x, input.y});
      return;
    case Input::Kind::kWait:
      settle();
      return;
    case Input::Kind::kPress:
    case Input::Kind::kRelease:
      state.is_held = input.kind == Input::Kind::kPress;
      break;
    default:
      break;
  }
  const ActionRow* const action = find_action(input, state.view.during());
  if (action == nullptr) return;
  if (input.kind == Input::Kind::kRelease || input.kind == Input::Kind::kKeyUp) {
    state.view.end(*action);
  } else {
    state.do_action(*action, input);
  }
}

void Session::do_action(const ActionRow& action, const Input& input) {
  state_->do_action(action, input);
}

void Session::advance(double seconds) {
  state_->view.update(seconds);
  state_->gallery->draw(state_->view);
  state_->take();
}

void Session::settle() {
  advance(0);
  state_->gallery->wait();
  state_->take();
}

std::vector<Session::Pane> Session::panes() const {
  return state_->panes();
}

const Mismatch* Session::mismatch() const {
  const Judged* const judged = state_->gallery->current_verdict();
  return state_->looks_at_mismatch && judged != nullptr ? &judged->mismatches[state_->mismatch] : nullptr;
}

std::string Session::window_title() const {
  std::string name = fmt::format("fillrule view: {}", state_->view.name());
  if (!state_->gallery->has_judge()) return name;
  const Judged* const judged = state_->gallery->current_verdict();
  if (judged == nullptr) return fmt::format("{}: judging", name);
  return fmt::format("{}: {} mismatches of the candidate, {} of the reference", name, judged->candidate_faults,
                     judged->reference_faults);
}

std::string Session::status() const {
  if (std::string error = state_->gallery->error(); !error.empty()) return error;
  const Judged* const judged = state_->gallery->current_verdict();
  std::vector<std::string> parts{state_->view.state_text(), state_->told};
  if (judged != nullptr) parts.push_back(judged->colors);
  std::erase(parts, "");
  return fmt::format("{}", fmt::join(parts, " | "));
}

bool Session::shows_help() const {
  return state_->shows_help;
}

bool Session::is_over() const {
  return state_->is_over;
}

}  // namespace fillrule::view
