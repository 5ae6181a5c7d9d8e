// Image files: PNG, EXR, BMP, JPEG and whatever else OpenImageIO knows. Safe to call from several threads.
//
// OpenImageIO brings some 280 shared libraries, which take half a second to load. So it stands behind a library of
// its own beside the executable, which is loaded when the first image is read or written.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "cases/model/result.h"

namespace fillrule::images {

// Values lie row by row from the top left, the channels of a pixel side by side.
struct Layout {
  uint32_t width = 0;                 // pixels
  uint32_t height = 0;                // pixels
  std::vector<std::string> channels;  // their names
};

// Red, green and blue.
Layout rgb_layout(uint32_t width, uint32_t height);

struct Image {
  Layout layout;
  std::vector<float> values;  // integers are scaled to 0 to 1
};

// Loads that library on a thread of its own, for those who will need it soon. Nobody may change the environment
// before the thread has ended: libraries read theirs as they are loaded, and getenv() beside setenv() reads freed
// memory.
[[nodiscard]] std::jthread load_ahead();

// The image's first channels, at most `max_channels`. Fails, naming the file, for what is no image or has more than
// kMaxTargetSize pixels in a row or column.
Result<Image> read(const std::string& path, uint32_t max_channels = UINT32_MAX);

// The format is told by the path's ending. EXR keeps floats as they are; other formats get 8 bits, 0 to 1 scaled and
// rounded.
Result<void> write(const std::string& path, const Layout& layout, std::span<const float> values);
Result<void> write(const std::string& path, const Layout& layout, std::span<const uint8_t> values);

}  // namespace fillrule::images
