#include "harness/report/printable.h"

#include <fmt/format.h>
#include <utf8proc.h>

#include <algorithm>

namespace fillrule::report {
namespace {

// The character that a text begins with; `code` is negative where the first byte begins none.
struct Character {
  utf8proc_int32_t code = -1;
  size_t bytes = 1;
};

Character first_character(std::string_view text) {
  Character character;
  const auto* const bytes = reinterpret_cast<const utf8proc_uint8_t*>(text.data());
  const utf8proc_ssize_t read = utf8proc_iterate(bytes, static_cast<utf8proc_ssize_t>(text.size()), &character.code);
  if (read > 0) character.bytes = static_cast<size_t>(read);
  return character;
}

bool is_visible(utf8proc_int32_t code) {
  switch (utf8proc_category(code)) {
    case UTF8PROC_CATEGORY_CN:  // not assigned
    case UTF8PROC_CATEGORY_CC:  // control
    case UTF8PROC_CATEGORY_CF:  // format: direction, joiners
    case UTF8PROC_CATEGORY_CS:  // surrogates
    case UTF8PROC_CATEGORY_CO:  // private use
    case UTF8PROC_CATEGORY_ZL:  // line separator
    case UTF8PROC_CATEGORY_ZP:  // paragraph separator
      return false;
    default:
      return true;
  }
}

// Where the prefix of at most so many columns ends, in bytes.
size_t end_of_prefix(std::string_view text, size_t columns) {
  size_t end = 0;
  while (end < text.size()) {
    const Character character = first_character(text.substr(end));
    const auto width = static_cast<size_t>(std::max(utf8proc_charwidth(character.code), 0));
    if (width > columns) break;
    columns -= width;
    end += character.bytes;
  }
  return end;
}

// Where the suffix of at most so many columns begins, in bytes.
size_t begin_of_suffix(std::string_view text, size_t columns) {
  const size_t all = columns_of(text);
  size_t begin = end_of_prefix(text, all - std::min(all, columns));
  if (columns_of(text.substr(begin)) > columns) begin += first_character(text.substr(begin)).bytes;
  return begin;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Character character = first_character(text);
    if (character.code >= 0 && is_visible(character.code)) {
      result += text.substr(0, character.bytes);
    } else if (character.code >= 0x80) {
      result += fmt::format("\\u{{{:x}}}", character.code);
    } else {
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
    }
    text.remove_prefix(character.bytes);
  }
  return result;
}

std::string printable_lines(std::string_view text) {
  std::string result;
  for (size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    result += printable(text.substr(0, end)) + '\n';
    text.remove_prefix(end + 1);
  }
  return result + printable(text);
}

size_t columns_of(std::string_view text) {
  size_t columns = 0;
  while (!text.empty()) {
    const Character character = first_character(text);
    columns += static_cast<size_t>(std::max(utf8proc_charwidth(character.code), 0));
    text.remove_prefix(character.bytes);
  }
  return columns;
}

std::string shortened(std::string_view text, size_t columns) {
  constexpr std::string_view kGap = "...";
  if (columns == 0 || columns_of(text) <= columns) return std::string(text);
  if (columns <= kGap.size()) return std::string(text.substr(0, end_of_prefix(text, columns)));
  const size_t kept = columns - kGap.size();
  std::string result(text.substr(0, end_of_prefix(text, kept - kept / 2)));
  result += kGap;
  return result.append(text.substr(begin_of_suffix(text, kept / 2)));
}

std::string wrapped(std::string_view text, size_t columns, size_t indent) {
  if (columns == 0) return std::string(text);
  std::string result;
  size_t used = 0;
  while (!text.empty()) {
    const size_t end = std::min(text.find(' ', text.find_first_not_of(' ')), text.size());
    const std::string_view word = text.substr(0, end);  // with the spaces before it
    const size_t width = columns_of(word);
    if (used > indent && used + width > columns) {
      const std::string_view bare = word.substr(std::min(word.find_first_not_of(' '), word.size()));
      result.append("\n").append(indent, ' ').append(bare);
      used = indent + columns_of(bare);
    } else {
      result += word;
      used += width;
    }
    text.remove_prefix(end);
  }
  return result;
}

}  // namespace fillrule::report
