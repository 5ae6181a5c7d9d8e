// For tests: what Packer packed, as the page unpacks it.
#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fillrule::report {

inline std::vector<uint8_t> bytes_of_base64(std::string_view text) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<uint8_t> bytes;
  uint32_t group = 0;
  uint32_t bits = 0;
  for (const char c : text.substr(0, text.find('='))) {
    group = group << 6U | static_cast<uint32_t>(kDigits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<uint8_t>(group >> bits));
  }
  return bytes;
}

inline std::vector<uint8_t> unpacked(std::string_view text) {
  constexpr size_t kMost = 1'000'000;
  const std::vector<uint8_t> compressed = bytes_of_base64(text);
  std::vector<uint8_t> bytes(kMost);
  uLongf length = kMost;
  EXPECT_EQ(uncompress(bytes.data(), &length, compressed.data(), compressed.size()), Z_OK);
  bytes.resize(length);
  return bytes;
}

}  // namespace fillrule::report
