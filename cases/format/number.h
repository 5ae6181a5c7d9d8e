// Numbers of a case file and their one rounding to float32.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cases/model/result.h"

namespace fillrule::format {

// A number as the file gives it. Everything is computed in double; `bits_float32` is set for "bits:0x7fc00001", which
// names a float32 that no conversion may touch (a signaling NaN would become a quiet one).
struct Number {
  double value = 0.0;
  std::optional<uint32_t> bits_float32;
};

// Whether the text is one of the literals that are not expressions: a hexadecimal float ("-0x1.8p-3"), float32 bits
// ("bits:0x7fc00001"), "nan", "inf", "-inf".
bool is_literal(std::string_view text);

// The value of a text for which is_literal holds.
Result<Number> parse_literal(std::string_view text);

// Rounds to nearest even. Nothing if a finite number becomes infinite.
std::optional<float> to_float32(const Number& number);

// The shortest text that the reader turns back into the same bits: a TOML number, or a string where TOML has none.
std::string format_float32(float value);

// `text` without the blanks around it.
std::string_view trim(std::string_view text);

}  // namespace fillrule::format
