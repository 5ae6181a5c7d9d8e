#include "harness/view/window.h"

#include <GL/gl.h>
#include <SDL.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>
#include <string_view>

#include "harness/images/images.h"
#include "harness/view/sdl_input.h"
#include "harness/view/user_interface.h"

namespace fillrule::view {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFrameSeconds = 1.0 / 60;  // of recorded events
constexpr int kIdleMilliseconds = 12;       // without an event until the next look at what the threads have done

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

tl::unexpected<Error> no_display(const std::string& why) {
  return failure(fmt::format("there is no display to open a window on: {}", why),
                 "'fillrule render SCENE -o out.png' draws without one");
}

// SDL, its window, and the OpenGL context, for as long as the window is there.
class SdlWindow {
 public:
  SdlWindow() = default;
  ~SdlWindow() {
    if (context_ != nullptr) SDL_GL_DeleteContext(context_);
    if (window_ != nullptr) SDL_DestroyWindow(window_);
    SDL_Quit();
  }
  SdlWindow(const SdlWindow&) = delete;
  SdlWindow(SdlWindow&&) = delete;
  SdlWindow& operator=(const SdlWindow&) = delete;
  SdlWindow& operator=(SdlWindow&&) = delete;

  Result<void> open(const Rect& size, bool vertical_sync) {
    if (SDL_Init(SDL_INIT_VIDEO) != 0) return no_display(SDL_GetError());
    // What SDL falls back to, and nobody sees.
    if (std::string_view(SDL_GetCurrentVideoDriver()) == "offscreen") return no_display("neither X11 nor Wayland");
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    window_ = SDL_CreateWindow("fillrule view", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, size.width,
                               size.height, SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE);
    if (window_ == nullptr) return no_display(SDL_GetError());
    context_ = SDL_GL_CreateContext(window_);
    if (context_ == nullptr) return no_display(SDL_GetError());
    SDL_GL_SetSwapInterval(vertical_sync ? 1 : 0);
    return {};
  }

  void set_title(const std::string& title) {
    if (title != title_) SDL_SetWindowTitle(window_, title.c_str());
    title_ = title;
  }

  [[nodiscard]] Rect size() const {
    Rect rect;
    SDL_GetWindowSize(window_, &rect.width, &rect.height);
    return rect;
  }

  void swap() { SDL_GL_SwapWindow(window_); }

 private:
  SDL_Window* window_ = nullptr;
  SDL_GLContext context_ = nullptr;
  std::string title_;
};

Result<void> write_screenshot(const std::string& path, const Rect& size) {
  const size_t pixels = static_cast<size_t>(size.width) * static_cast<size_t>(size.height);
  std::vector<uint8_t> rgba(pixels * 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  std::vector<uint8_t> rgb;
  rgb.reserve(pixels * 3);
  for (int y = size.height - 1; y >= 0; --y) {  // from OpenGL's bottom row
    for (int x = 0; x < size.width; ++x) {
      const size_t first = (static_cast<size_t>(y) * static_cast<size_t>(size.width) + static_cast<size_t>(x)) * 4;
      for (size_t c = 0; c < 3; ++c) rgb.push_back(rgba[first + c]);
    }
  }
  const auto layout = images::rgb_layout(static_cast<uint32_t>(size.width), static_cast<uint32_t>(size.height));
  return images::write(path, layout, rgb);
}

// Where the input of a frame comes from: the user, a file, or the benchmark, which orbits.
class InputSource {
 public:
  explicit InputSource(const WindowOptions& options) : options_(options) {}

  // False where the window was closed.
  bool read(uint32_t frame, const Session& session, std::vector<Input>& inputs) {
    inputs.clear();
    const bool is_live = !options_.events && !options_.benchmark;
    SDL_Event event;
    if (is_live && SDL_WaitEventTimeout(&event, kIdleMilliseconds) != 0 && !take(event, is_live, inputs))
      return false;
    while (SDL_PollEvent(&event) != 0) {
      if (!take(event, is_live, inputs)) return false;
    }
    if (options_.benchmark) orbit(frame, session, inputs);
    while (options_.events && next_ < options_.events->size() && (*options_.events)[next_].frame <= frame) {
      inputs.push_back((*options_.events)[next_++].input);
    }
    for (const Input& input : inputs) {
      if (!options_.record_file.empty()) recorded_.push_back({.frame = frame, .input = input});
    }
    return true;
  }

  [[nodiscard]] Result<void> write_record() const {
    if (options_.record_file.empty()) return {};
    std::ofstream file(options_.record_file, std::ios::binary);
    file << write_events(recorded_);
    file.close();
    if (!file) return tl::unexpected(Error{.file = options_.record_file, .what = "cannot be written"});
    return {};
  }

 private:
  static bool take(const SDL_Event& event, bool is_live, std::vector<Input>& inputs) {
    if (event.type == SDL_QUIT) return false;
    // The mouse goes on beyond the window's edges while a button is held.
    if (event.type == SDL_MOUSEBUTTONDOWN) SDL_CaptureMouse(SDL_TRUE);
    if (event.type == SDL_MOUSEBUTTONUP) SDL_CaptureMouse(SDL_FALSE);
    if (!is_live) return true;
    if (const std::optional<Input> input = input_of(event)) inputs.push_back(*input);
    return true;
  }

  static void orbit(uint32_t frame, const Session& session, std::vector<Input>& inputs) {
    if (!session.is_scene()) {
      inputs.push_back({.kind = Input::Kind::kKeyDown, .key = "right", .place = "right"});
      return;
    }
    const Rect room = session.panes().front().room;
    inputs.push_back({.kind = Input::Kind::kMove, .x = room.x + frame * 2.0, .y = room.y + room.height / 2.0});
    if (frame == 0) inputs.push_back({.kind = Input::Kind::kPress});
  }

  const WindowOptions& options_;
  size_t next_ = 0;
  std::vector<RecordedInput> recorded_;
};

}  // namespace

Result<Shown> show(Session& session, const WindowOptions& options) {
  SdlWindow window;
  const Rect wanted = window_of(options.pane_width, options.pane_height, session.pane_count());
  const bool is_live = !options.events && !options.benchmark;
  if (auto opened = window.open(wanted, is_live); !opened) return tl::unexpected(opened.error());
  UserInterface interface;
  InputSource source(options);
  std::vector<Input> inputs;
  Shown shown;
  const Clock::time_point start = Clock::now();
  Clock::time_point last = start;
  for (bool is_last = false; !is_last; ++shown.frames) {
    const Rect size = window.size();
    session.resize(size.width, size.height);
    interface.resize(size.width, size.height);
    is_last = !source.read(shown.frames, session, inputs) || shown.frames + 1 == options.frames;
    for (const Input& input : inputs) interface.handle(input, session);
    const double seconds = is_live ? seconds_since(last) : kFrameSeconds;
    last = Clock::now();
    session.advance(seconds);
    is_last = is_last || session.is_over();
    shown.drawing_seconds += seconds_since(last);
    if (is_last && !options.screenshot_file.empty()) session.settle();
    interface.draw(session, seconds);
    window.set_title(session.window_title());
    if (is_last && !options.screenshot_file.empty()) {
      if (auto done = write_screenshot(options.screenshot_file, size); !done) return tl::unexpected(done.error());
    }
    window.swap();
  }
  shown.seconds = seconds_since(start);
  if (auto written = source.write_record(); !written) return tl::unexpected(written.error());
  return shown;
}

}  // namespace fillrule::view
