// A block of pixels of four samples as rows of bits, in the order in which the attachments hold the samples.
#pragma once

#include <array>
#include <cstdint>

#include "renderer/coverage.h"

namespace fillrule::renderer::internal {

// Of row y of a block bit 4 * x + s: sample s of the pixel x.
using SampleRows = std::array<uint32_t, kBlockSize>;

// All samples of all pixels.
[[gnu::always_inline]] inline bool is_full(const SampleRows& rows) {
  uint32_t all = ~0U;
  for (const uint32_t row : rows) {
    all &= row;
  }
  return all == ~0U;
}

// Bit i of a byte as bit 4 * i.
constexpr std::array<uint32_t, 256> spread_bytes() {
  std::array<uint32_t, 256> spread{};
  for (uint32_t byte = 0; byte < spread.size(); ++byte) {
    for (uint32_t bit = 0; bit < 8; ++bit) {
      spread[byte] |= (byte >> bit & 1U) << (4 * bit);
    }
  }
  return spread;
}
inline constexpr std::array<uint32_t, 256> kSpreadByte = spread_bytes();

// The block's samples that are in the mask.
[[gnu::always_inline]] inline SampleRows sample_rows(const SampledBlock& block, uint32_t sample_mask) {
  SampleRows rows{};
  if ((sample_mask & 0xFU) == 0xFU &&
      (block.masks[0] & block.masks[1] & block.masks[2] & block.masks[3]) == ~uint64_t{0}) {
    rows.fill(~0U);
    return rows;
  }
  for (uint32_t sample = 0; sample < 4; ++sample) {
    const uint64_t mask = (sample_mask >> sample & 1U) != 0 ? block.masks[sample] : 0;
    for (uint32_t row = 0; row < kBlockSize; ++row) {
      rows[row] |= kSpreadByte[mask >> (row * kBlockSize) & 0xFFU] << sample;
    }
  }
  return rows;
}

}  // namespace fillrule::renderer::internal
