// Arrays of numbers as text that a browser unpacks by itself: bytes of equal weight side by side, zlib, base64.
// Nothing is lost: the payload of a NaN survives.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fillrule::report {

// Bytes to be packed as one.
class Packer {
 public:
  // Appended as they are.
  void add_bytes(std::span<const uint8_t> values);
  // Appended as all lowest bytes, then all second ones, and so on. With `base`, which is as long, the values are
  // XORed with it first, so that equal ones leave zeros.
  void add_words(std::span<const uint32_t> values, std::span<const uint32_t> base = {});
  void add_floats(std::span<const float> values, std::span<const float> base = {});

  [[nodiscard]] size_t size() const { return bytes_.size(); }
  // Compressed, in base64.
  [[nodiscard]] std::string packed() const;

 private:
  std::vector<uint8_t> bytes_;
};

std::string base64(std::span<const uint8_t> bytes);

// Text, compressed, in base64.
std::string packed_text(std::string_view text);

}  // namespace fillrule::report
