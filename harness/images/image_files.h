// What images.h asks of the library that holds OpenImageIO.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "harness/images/images.h"

namespace fillrule::images {

class ImageFiles {
 public:
  ImageFiles() = default;
  ImageFiles(const ImageFiles&) = delete;
  ImageFiles(ImageFiles&&) = delete;
  ImageFiles& operator=(const ImageFiles&) = delete;
  ImageFiles& operator=(ImageFiles&&) = delete;
  virtual ~ImageFiles() = default;

  [[nodiscard]] virtual Result<Image> read(const std::string& path, uint32_t max_channels) const = 0;
  [[nodiscard]] virtual Result<void> write(const std::string& path, const Layout& layout,
                                           std::span<const float> values) const = 0;
  [[nodiscard]] virtual Result<void> write(const std::string& path, const Layout& layout,
                                           std::span<const uint8_t> values) const = 0;
};

}  // namespace fillrule::images

// The library's only symbol; never null.
extern "C" const fillrule::images::ImageFiles* fillrule_image_files();
