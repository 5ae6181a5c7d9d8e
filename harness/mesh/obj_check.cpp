#include "harness/mesh/obj_check.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace fillrule::mesh {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";
// Of a polygon: more are a broken file, and would make triangulating it take forever.
constexpr size_t kMaxCorners = 4096;

// The words of a line, up to a comment.
std::vector<std::string_view> words_of(std::string_view line) {
  line = line.substr(0, line.find('#'));
  std::vector<std::string_view> words;
  for (size_t begin = line.find_first_not_of(kBlanks); begin != std::string_view::npos;
       begin = line.find_first_not_of(kBlanks, begin)) {
    const size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = end;
    if (begin == line.size()) break;
  }
  return words;
}

// False if the word is no number that is finite as float32.
bool is_coordinate(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() && std::isfinite(static_cast<float>(value));
}

std::optional<int64_t> index_of(std::string_view word) {
  int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

class Checker {
 public:
  explicit Checker(const std::string& file_label) : file_label_(file_label) {}

  // `line` counts from 1; the words are of `text`.
  Result<void> check(const std::vector<std::string_view>& words, std::string_view text, uint32_t line) {
    line_ = line;
    text_ = text;
    const std::string_view keyword = words.front();
    if (keyword == "v") return check_coordinates(words, 3, positions_);
    if (keyword == "vn") return check_coordinates(words, 3, normals_);
    if (keyword == "vt") return check_coordinates(words, 1, uvs_);
    if (keyword == "f") return check_face(words);
    return {};
  }

  [[nodiscard]] bool has_faces() const { return has_faces_; }

 private:
  [[nodiscard]] tl::unexpected<Error> wrong(std::string_view word, std::string what, std::string hint = {}) const {
    return tl::unexpected(Error{.file = file_label_,
                                .line = line_,
                                .column = static_cast<uint32_t>(word.data() - text_.data()) + 1,
                                .what = std::move(what),
                                .hint = std::move(hint)});
  }

  Result<void> check_coordinates(const std::vector<std::string_view>& words, size_t least, int64_t& count) {
    if (words.size() < least + 1) {
      return wrong(words[0], fmt::format("\"{}\" with {} numbers instead of {}", words[0], words.size() - 1, least));
    }
    for (size_t i = 1; i < words.size(); ++i) {
      if (!is_coordinate(words[i])) return wrong(words[i], fmt::format("\"{}\" is no finite number", words[i]));
    }
    ++count;
    return {};
  }

  Result<void> check_face(const std::vector<std::string_view>& words) {
    const size_t corners = words.size() - 1;
    if (corners < 3 || corners > kMaxCorners) {
      return wrong(words[0], fmt::format("a face of {} vertices", corners), fmt::format("3 to {}", kMaxCorners));
    }
    for (size_t i = 1; i < words.size(); ++i) {
      if (auto good = check_corner(words[i]); !good) return good;
    }
    has_faces_ = true;
    return {};
  }

  // v, v/vt, v//vn or v/vt/vn; each counts from 1, or back from the last one if it is negative.
  [[nodiscard]] Result<void> check_corner(std::string_view corner) const {
    const std::array counts{positions_, uvs_, normals_};
    constexpr std::array<std::string_view, 3> kNames{"v", "vt", "vn"};
    std::string_view rest = corner;
    for (size_t i = 0; i < 3; ++i) {
      const size_t slash = rest.find('/');
      const std::string_view word = rest.substr(0, slash);
      const bool is_last = slash == std::string_view::npos;
      if (!word.empty() || i != 1 || is_last) {
        const auto index = index_of(word);
        if (!index) {
          return wrong(corner, fmt::format("\"{}\" is no vertex of a face", corner),
                       "v, v/vt, v//vn or v/vt/vn, whole numbers");
        }
        const int64_t number = *index < 0 ? counts[i] + 1 + *index : *index;
        if (number < 1 || number > counts[i]) {
          return wrong(corner, fmt::format(R"({} in "{}" names no "{}")", *index, corner, kNames[i]),
                       fmt::format("there are {} so far", counts[i]));
        }
      }
      if (is_last) return {};
      rest.remove_prefix(slash + 1);
    }
    return wrong(corner, fmt::format("\"{}\" is no vertex of a face", corner), "v, v/vt, v//vn or v/vt/vn");
  }

  const std::string& file_label_;
  std::string_view text_;
  uint32_t line_ = 0;
  int64_t positions_ = 0;
  int64_t uvs_ = 0;
  int64_t normals_ = 0;
  bool has_faces_ = false;
};

bool is_geometry(std::string_view keyword) {
  for (const std::string_view known : {"v", "vt", "vn", "f", "g", "o", "s"}) {
    if (keyword == known) return true;
  }
  return false;
}

}  // namespace

Result<std::string> checked_obj(std::string_view text, const std::string& file_label) {
  Checker checker(file_label);
  std::string geometry;
  geometry.reserve(text.size());
  uint32_t line_number = 0;
  std::string joined;
  uint32_t first_line = 0;
  while (!text.empty()) {
    ++line_number;
    const size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (joined.empty()) first_line = line_number;
    while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    const bool continues = line.ends_with('\\') && !text.empty();
    joined += line.substr(0, line.size() - (line.ends_with('\\') ? 1 : 0));
    joined += ' ';
    if (continues) continue;
    const std::vector<std::string_view> words = words_of(joined);
    if (!words.empty() && is_geometry(words.front())) {
      if (const auto good = checker.check(words, joined, first_line); !good) return tl::unexpected(good.error());
      geometry += fmt::format("{}\n", fmt::join(words, " "));
    }
    joined.clear();
  }
  if (!checker.has_faces()) {
    return tl::unexpected(Error{.file = file_label, .what = "no faces in this file", .hint = "a face is: f 1 2 3"});
  }
  return geometry;
}

}  // namespace fillrule::mesh
