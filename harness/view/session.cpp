#include "harness/view/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "harness/scene/build.h"
#include "harness/view/bake.h"

namespace fillrule::view {
namespace {

using Job = std::shared_ptr<const Drawable>;

struct Drawn {
  uint64_t version = 0;  // of the view
  Image image;
  std::string error;
  uint64_t stamp = 0;  // of the image
};

struct JudgedOutcome {
  Judged judged;
  std::string error;
  uint64_t stamp = 0;
};

Drawn drawn_by(const Draws& draws, const Drawable& drawable) {
  Drawn drawn{.version = drawable.version};
  if (const Result<void> done = draws(drawable, drawn.image); !done) drawn.error = to_string(done.error());
  return drawn;
}

}  // namespace

struct Session::State {
  SessionOptions options;
  View view;
  Draws candidate_draws;

  std::optional<uint64_t> drawn_version;  // of the view, that the candidate has drawn
  Drawn candidate;
  std::optional<Drawn> reference;
  std::optional<JudgedOutcome> judged;
  uint64_t stamp = 0;  // the last one that was given to an image
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

  // Last, so that they end before what they use.
  std::unique_ptr<LatestWorker<Job, Drawn>> reference_worker;
  std::unique_ptr<LatestWorker<Job, JudgedOutcome>> judge_worker;

  State(SessionOptions the_options, View the_view, Draws draws)
      : options(std::move(the_options)), view(std::move(the_view)), candidate_draws(std::move(draws)) {}

  [[nodiscard]] bool has_reference() const { return options.is_judged && options.run.reference != run::kNoReference; }

  void start_workers(run::SuiteRunner runner) {
    const auto shared = std::make_shared<run::SuiteRunner>(std::move(runner));
    judge_worker = std::make_unique<LatestWorker<Job, JudgedOutcome>>([shared](const Job& job) {
      const Result<Judged> result = judge_view(*shared, *job);
      if (result) return JudgedOutcome{.judged = *result};
      return JudgedOutcome{.judged = {.version = job->version}, .error = to_string(result.error())};
    });
    if (!has_reference() || !view.is_scene()) return;
    reference_worker = std::make_unique<LatestWorker<Job, Drawn>>(
        [draws = reference_draws(options.run)](const Job& job) { return drawn_by(draws, *job); });
  }

  void draw() {
    drawn_version = view.changes();
    Result<Drawable> drawable = view.drawable();
    if (!drawable) {
      candidate.error = to_string(drawable.error());
      return;
    }
    const Job job = std::make_shared<const Drawable>(std::move(*drawable));
    candidate.version = job->version;
    const Result<void> done = candidate_draws(*job, candidate.image);
    candidate.error = done ? "" : to_string(done.error());
    candidate.stamp = ++stamp;
    if (reference_worker) reference_worker->submit(job);
    if (judge_worker) judge_worker->submit(job);
  }

  void take() {
    if (reference_worker) {
      if (auto drawn = reference_worker->take()) {
        reference = std::move(drawn);
        reference->stamp = ++stamp;
      }
    }
    if (!judge_worker) return;
    auto outcome = judge_worker->take();
    if (!outcome) return;
    judged = std::move(outcome);
    judged->stamp = ++stamp;
    mismatch = 0;
    looks_at_mismatch = false;
    if (view.is_scene() || !judged->error.empty()) return;
    // In colours of both parties' range.
    if (judged->judged.version == candidate.version) {
      candidate.image = judged->judged.candidate;
      candidate.stamp = ++stamp;
    }
    if (!judged->judged.reference) return;
    reference = Drawn{.version = judged->judged.version, .image = *judged->judged.reference, .stamp = ++stamp};
  }

  [[nodiscard]] bool is_judged_now() const {
    return judged && judged->error.empty() && judged->judged.version == drawn_version;
  }

  [[nodiscard]] std::vector<Pane> panes() const {
    const size_t count = options.is_judged ? (has_reference() ? 3 : 2) : 1;
    std::vector<Pane> panes;
    for (const Rect& room : panes_of(window_width, window_height, count)) panes.push_back({.room = room});
    const auto fill = [&](Pane& pane, const char* name, const Image* image, uint64_t version, uint64_t image_stamp) {
      pane.title = name;
      pane.image = image != nullptr && !image->rgba.empty() ? image : nullptr;
      pane.stamp = image_stamp;
      if (pane.image == nullptr) return;
      pane.placement = place(pane.room, pane.image->width, pane.image->height);
      if (version != drawn_version) pane.title += " (of an earlier view)";
    };
    fill(panes.front(), "candidate", candidate.error.empty() ? &candidate.image : nullptr, candidate.version,
         candidate.stamp);
    if (has_reference()) fill(panes[1], "reference", nullptr, 0, 0);
    if (has_reference() && reference) {
      fill(panes[1], "reference", &reference->image, reference->version, reference->stamp);
    }
    if (options.is_judged) fill(panes.back(), "difference", nullptr, 0, 0);
    if (options.is_judged && judged) {
      fill(panes.back(), "difference", &judged->judged.difference, judged->judged.version, judged->stamp);
    }
    return panes;
  }

  // Where the mouse is on the picture of the pane that it is in, or was when its button was pressed.
  [[nodiscard]] glm::dvec2 picture_point() const {
    const std::vector<Pane> all = panes();
    const Pane& pane = all[std::min(mouse_pane, all.size() - 1)];
    const Image& image = candidate.image;
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
    if (!judge_worker) return "nobody judges: there is no reference";
    if (!is_judged_now()) return "not judged yet";
    const std::vector<Mismatch>& all = judged->judged.mismatches;
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
  Result<Draws> draws = candidate_draws(options.run);
  if (!draws) return tl::unexpected(draws.error());
  Result<View> view = View::create(std::move(looked_at));
  if (!view) return tl::unexpected(view.error());
  auto state = std::make_unique<State>(options, std::move(*view), std::move(*draws));
  if (options.is_judged) {
    Result<run::SuiteRunner> runner = run::SuiteRunner::create(options.run);
    if (!runner) return tl::unexpected(runner.error());
    state->start_workers(std::move(*runner));
  }
  return Session(std::move(state));
}

size_t Session::pane_count() const {
  return state_->panes().size();
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
  if (state_->drawn_version != state_->view.changes()) state_->draw();
  state_->take();
}

void Session::settle() {
  advance(0);
  if (state_->reference_worker) state_->reference_worker->wait();
  if (state_->judge_worker) state_->judge_worker->wait();
  state_->take();
}

std::vector<Session::Pane> Session::panes() const {
  return state_->panes();
}

const Mismatch* Session::mismatch() const {
  const State& state = *state_;
  return state.looks_at_mismatch && state.is_judged_now() ? &state.judged->judged.mismatches[state.mismatch]
                                                          : nullptr;
}

std::string Session::window_title() const {
  const State& state = *state_;
  const std::string title = "fillrule view: " + state.view.name();
  if (!state.judge_worker) return title;
  if (!state.is_judged_now()) return title + ": judging";
  const Judged& judged = state.judged->judged;
  return fmt::format("{}: {} mismatches of the candidate, {} of the reference", title, judged.candidate_faults,
                     judged.reference_faults);
}

std::string Session::status() const {
  const State& state = *state_;
  if (!state.candidate.error.empty()) return state.candidate.error;
  if (state.judged && !state.judged->error.empty()) return state.judged->error;
  if (state.reference && !state.reference->error.empty()) return state.reference->error;
  std::string text = state.view.state_text();
  const auto add = [&text](const std::string& more) {
    if (!more.empty()) text += (text.empty() ? "" : " | ") + more;
  };
  add(state.told);
  if (state.is_judged_now()) add(state.judged->judged.colors);
  return text;
}

bool Session::shows_help() const {
  return state_->shows_help;
}

bool Session::is_over() const {
  return state_->is_over;
}

}  // namespace fillrule::view
