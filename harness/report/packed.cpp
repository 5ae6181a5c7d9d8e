#include "harness/report/packed.h"

#include <zlib.h>

#include <bit>

namespace fillrule::report {
namespace {

// Planes that are equal in both parties are zeros, which any level packs well, and a report is written at the end of
// every run: little effort is enough.
constexpr int kLevel = 4;

std::vector<uint8_t> compressed(std::span<const uint8_t> bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::vector<uint8_t> result(size);
  // The only error of a buffer that large is lack of memory, which is thrown above.
  compress2(result.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), kLevel);
  result.resize(size);
  return result;
}

}  // namespace

void Packer::add_bytes(std::span<const uint8_t> values) {
  bytes_.insert(bytes_.end(), values.begin(), values.end());
}

void Packer::add_words(std::span<const uint32_t> values, std::span<const uint32_t> base) {
  for (uint32_t shift = 0; shift < 32; shift += 8) {
    for (size_t i = 0; i < values.size(); ++i) {
      const uint32_t word = base.empty() ? values[i] : values[i] ^ base[i];
      bytes_.push_back(static_cast<uint8_t>(word >> shift));
    }
  }
}

void Packer::add_floats(std::span<const float> values, std::span<const float> base) {
  const auto bits = [](std::span<const float> floats) {
    std::vector<uint32_t> words;
    words.reserve(floats.size());
    for (const float value : floats) words.push_back(std::bit_cast<uint32_t>(value));
    return words;
  };
  add_words(bits(values), bits(base));
}

std::string Packer::packed() const {
  return base64(compressed(bytes_));
}

std::string base64(std::span<const uint8_t> bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t count = bytes.size() - i;
    uint32_t group = uint32_t{bytes[i]} << 16U;
    if (count > 1) group |= uint32_t{bytes[i + 1]} << 8U;
    if (count > 2) group |= bytes[i + 2];
    text += kDigits[group >> 18U];
    text += kDigits[(group >> 12U) & 63U];
    text += count > 1 ? kDigits[(group >> 6U) & 63U] : '=';
    text += count > 2 ? kDigits[group & 63U] : '=';
  }
  return text;
}

std::string packed_text(std::string_view text) {
  Packer packer;
  packer.add_bytes({reinterpret_cast<const uint8_t*>(text.data()), text.size()});
  return packer.packed();
}

}  // namespace fillrule::report
