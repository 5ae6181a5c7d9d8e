#include "cases/format/number.h"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace fillrule::format {
namespace {

constexpr std::string_view kBitsPrefix = "bits:";
constexpr uint32_t kQuietNan = 0x7FC00000U;  // what TOML's nan becomes

bool starts_hexadecimal(std::string_view text) {
  return text.starts_with("0x") || text.starts_with("0X");
}

std::string_view without_sign(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return text;
}

Result<Number> parse_bits(std::string_view text) {
  std::string_view digits = text.substr(kBitsPrefix.size());
  uint32_t bits = 0;
  bool good = starts_hexadecimal(digits);
  if (good) {
    digits.remove_prefix(2);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), bits, 16);
    good = error == std::errc() && end == digits.data() + digits.size();
  }
  if (!good) {
    return failure(fmt::format("malformed float32 bits \"{}\"", text),
                   "write up to 8 hexadecimal digits, for example \"bits:0x7fc00001\"");
  }
  return Number{.value = double{std::bit_cast<float>(bits)}, .bits_float32 = bits};
}

// digits [. digits] [p [sign] digits]: from_chars alone also takes signs at other places.
bool is_hexadecimal_float(std::string_view text) {
  const size_t exponent = text.find_first_of("pP");
  const std::string_view mantissa = text.substr(0, exponent);
  const auto consists_of = [](std::string_view part, std::string_view allowed) {
    return !part.empty() && part.find_first_not_of(allowed) == std::string_view::npos;
  };
  if (!consists_of(mantissa, "0123456789abcdefABCDEF.")) return false;
  return exponent == std::string_view::npos || consists_of(without_sign(text.substr(exponent + 1)), "0123456789");
}

Result<Number> parse_hexadecimal(std::string_view text) {
  const std::string_view digits = without_sign(text).substr(2);
  double value = 0.0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::hex);
  if (!is_hexadecimal_float(digits) || error != std::errc() || end != digits.data() + digits.size()) {
    return failure(fmt::format("malformed hexadecimal float \"{}\"", text),
                   "write it as in C, for example \"0x1.8p-3\" = 0.1875");
  }
  return Number{.value = text.starts_with('-') ? -value : value};
}

}  // namespace

bool is_literal(std::string_view text) {
  const std::string_view bare = without_sign(text);
  return text.starts_with(kBitsPrefix) || starts_hexadecimal(bare) || bare == "nan" || bare == "inf";
}

Result<Number> parse_literal(std::string_view text) {
  if (text.starts_with(kBitsPrefix)) return parse_bits(text);
  const std::string_view bare = without_sign(text);
  if (starts_hexadecimal(bare)) return parse_hexadecimal(text);
  const double magnitude =
      bare == "nan" ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity();
  return Number{.value = text.starts_with('-') ? -magnitude : magnitude};
}

std::optional<float> to_float32(const Number& number) {
  if (number.bits_float32) return std::bit_cast<float>(*number.bits_float32);
  const auto rounded = static_cast<float>(number.value);
  if (std::isinf(rounded) && std::isfinite(number.value)) return std::nullopt;
  return rounded;
}

std::string format_float32(float value) {
  const auto bits = std::bit_cast<uint32_t>(value);
  if (std::isnan(value)) return bits == kQuietNan ? "nan" : fmt::format("\"bits:0x{:08x}\"", bits);
  if (value == 0.0F) return std::signbit(value) ? "-0.0" : "0";  // TOML's -0 is an integer without a sign
  std::string text = fmt::format("{}", value);
  // The reader goes through double; where two roundings miss the bits, the exact value has to be written.
  const auto read_back = static_cast<float>(std::strtod(text.c_str(), nullptr));
  return std::bit_cast<uint32_t>(read_back) == bits ? text : fmt::format("\"{:a}\"", double{value});
}

std::string_view trim(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

}  // namespace fillrule::format
