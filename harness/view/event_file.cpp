#include "harness/view/event_file.h"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>

#include "cases/format/suggestion.h"
#include "harness/view/actions.h"

namespace fillrule::view {
namespace {

struct Word {
  std::string text;
  uint32_t column = 0;  // from 1
};

std::vector<Word> words_of(const std::string& line) {
  std::vector<Word> words;
  for (size_t i = 0; i < line.size() && line[i] != '#';) {
    if (line[i] == ' ' || line[i] == '\t' || line[i] == '\r') {
      ++i;
      continue;
    }
    const size_t end = std::min(line.find_first_of(" \t\r#", i), line.size());
    words.push_back({.text = line.substr(i, end - i), .column = static_cast<uint32_t>(i + 1)});
    i = end;
  }
  return words;
}

const std::vector<std::string> kVerbs{"frame", "move", "press", "release", "wheel", "key", "down", "up", "wait"};
const std::vector<std::string> kButtons{"left", "middle", "right"};
constexpr double kFarthest = 1e6;  // pixels

class Parser {
 public:
  explicit Parser(std::string file) : file_(std::move(file)) {}

  Result<void> read_line(const std::string& line) {
    ++line_;
    words_ = words_of(line);
    if (words_.empty()) return {};
    const std::string& verb = words_[0].text;
    if (verb == "wait") return take(0).map([&] { add({.kind = Input::Kind::kWait}); });
    if (verb == "frame") return read_frame();
    if (verb == "move") return read_move();
    if (verb == "wheel") return read_wheel();
    if (verb == "press" || verb == "release") return read_button(verb == "press");
    if (verb == "key" || verb == "down" || verb == "up") return read_key(verb);
    return at(0, fmt::format("\"{}\" is no event", verb), format::suggestion(verb, kVerbs, "an event is one of"));
  }

  std::vector<RecordedInput> take_events() { return std::move(events_); }

 private:
  [[nodiscard]] tl::unexpected<Error> at(size_t word, std::string what, std::string hint = {}) const {
    return tl::unexpected(Error{.file = file_,
                                .line = line_,
                                .column = words_[word].column,
                                .what = std::move(what),
                                .hint = std::move(hint)});
  }

  // So many words must follow the first.
  [[nodiscard]] Result<void> take(size_t count) const {
    if (words_.size() > count + 1) return at(count + 1, fmt::format("\"{}\" is too much", words_[count + 1].text));
    if (words_.size() < count + 1) {
      return at(0, fmt::format("\"{}\" needs {} value{} behind it", words_[0].text, count, count == 1 ? "" : "s"));
    }
    return {};
  }

  [[nodiscard]] Result<double> number(size_t word) const {
    const std::string& text = words_[word].text;
    double value = 0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size() || !(std::abs(value) <= kFarthest)) {
      return at(word, fmt::format("\"{}\" is no number from -{:.0f} to {:.0f}", text, kFarthest, kFarthest));
    }
    return value;
  }

  void add(const Input& input) { events_.push_back({.frame = frame_, .input = input}); }

  Result<void> read_frame() {
    if (auto taken = take(1); !taken) return taken;
    const Result<double> value = number(1);
    if (!value) return tl::unexpected(value.error());
    const auto frame = static_cast<uint32_t>(std::max(*value, 0.0));
    if (frame != *value || frame < frame_) {
      return at(1, fmt::format("\"{}\" is no frame from {}", words_[1].text, frame_), "frames go upwards from 0");
    }
    frame_ = frame;
    return {};
  }

  Result<void> read_move() {
    if (auto taken = take(2); !taken) return taken;
    const Result<double> x = number(1);
    if (!x) return tl::unexpected(x.error());
    const Result<double> y = number(2);
    if (!y) return tl::unexpected(y.error());
    add({.kind = Input::Kind::kMove, .x = *x, .y = *y});
    return {};
  }

  Result<void> read_wheel() {
    if (auto taken = take(1); !taken) return taken;
    const Result<double> steps = number(1);
    if (!steps) return tl::unexpected(steps.error());
    add({.kind = Input::Kind::kWheel, .y = *steps});
    return {};
  }

  Result<void> read_button(bool press) {
    if (auto taken = take(1); !taken) return taken;
    for (size_t i = 0; i < kButtons.size(); ++i) {
      if (words_[1].text != kButtons[i]) continue;
      add({.kind = press ? Input::Kind::kPress : Input::Kind::kRelease, .button = static_cast<MouseButton>(i)});
      return {};
    }
    return at(1, fmt::format("\"{}\" is no mouse button", words_[1].text),
              format::suggestion(words_[1].text, kButtons, "the buttons are"));
  }

  Result<void> read_key(const std::string& verb) {
    if (auto taken = take(1); !taken) return taken;
    std::string key = words_[1].text;
    const bool shift = key.starts_with("shift+");
    if (shift) key.erase(0, 6);
    if (!is_key(key)) {
      return at(1, fmt::format("no action has a key \"{}\"", key),
                format::suggestion(key, key_names(), "the keys are"));
    }
    const Input down{.kind = Input::Kind::kKeyDown, .key = key, .place = key, .shift = shift};
    Input up = down;
    up.kind = Input::Kind::kKeyUp;
    if (verb != "up") add(down);
    if (verb != "down") add(up);
    return {};
  }

  std::string file_;
  uint32_t line_ = 0;
  uint32_t frame_ = 0;
  std::vector<Word> words_;
  std::vector<RecordedInput> events_;
};

std::string line_of(const Input& input) {
  const std::string& button = kButtons[static_cast<size_t>(input.button)];
  // By its place, as keys are held by their place; where they differ, by what is printed on it.
  const std::string key = (input.shift ? "shift+" : "") + (is_key(input.key) ? input.key : input.place);
  switch (input.kind) {
    case Input::Kind::kMove:
      return fmt::format("move {} {}", input.x, input.y);
    case Input::Kind::kPress:
      return "press " + button;
    case Input::Kind::kRelease:
      return "release " + button;
    case Input::Kind::kWheel:
      return fmt::format("wheel {}", input.y);
    case Input::Kind::kKeyDown:
      return "down " + key;
    case Input::Kind::kKeyUp:
      return "up " + key;
    case Input::Kind::kWait:
      return "wait";
  }
  return {};
}

}  // namespace

Result<std::vector<RecordedInput>> parse_events(std::string_view text, const std::string& file_label) {
  Parser parser(file_label);
  std::istringstream stream{std::string(text)};
  for (std::string line; std::getline(stream, line);) {
    if (auto read = parser.read_line(line); !read) return tl::unexpected(read.error());
  }
  return parser.take_events();
}

Result<std::vector<RecordedInput>> read_events(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(file), {});
  if (!file.is_open() || file.bad()) return tl::unexpected(Error{.file = path, .what = "cannot be read"});
  return parse_events(text, path);
}

std::string write_events(const std::vector<RecordedInput>& events) {
  std::string text;
  std::optional<uint32_t> frame;
  for (const RecordedInput& event : events) {
    if (frame != event.frame) text += fmt::format("frame {}\n", event.frame);
    frame = event.frame;
    text += line_of(event.input) + '\n';
  }
  return text;
}

}  // namespace fillrule::view
