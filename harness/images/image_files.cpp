#include "harness/images/image_files.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>

#include "cases/model/case.h"

namespace fillrule::images {
namespace {

tl::unexpected<Error> cannot_read(const std::string& path, const std::string& reason) {
  return tl::unexpected(Error{.file = path, .what = "cannot be read as an image: " + reason});
}

tl::unexpected<Error> cannot_write(const std::string& path, const std::string& reason) {
  return tl::unexpected(Error{.file = path, .what = "cannot be written as an image: " + reason});
}

Result<void> write_as(const std::string& path, const Layout& layout, const OIIO::TypeDesc& in_file,
                      const OIIO::TypeDesc& in_memory, const void* values) {
  const auto output = OIIO::ImageOutput::create(path);
  if (!output) return cannot_write(path, OIIO::geterror());
  OIIO::ImageSpec spec(static_cast<int>(layout.width), static_cast<int>(layout.height),
                       static_cast<int>(layout.channels.size()), in_file);
  spec.channelnames = layout.channels;
  if (!output->open(path, spec) || !output->write_image(in_memory, values) || !output->close()) {
    return cannot_write(path, output->geterror());
  }
  return {};
}

class OpenImageIo final : public ImageFiles {
 public:
  [[nodiscard]] Result<Image> read(const std::string& path, uint32_t max_channels) const override {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) return cannot_read(path, OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    const auto is_size = [](int size) { return size > 0 && size <= static_cast<int>(kMaxTargetSize); };
    if (!is_size(spec.width) || !is_size(spec.height) || spec.nchannels < 1) {
      return cannot_read(path, fmt::format("{} x {} pixels of {} channels; at most {} x {}", spec.width, spec.height,
                                           spec.nchannels, kMaxTargetSize, kMaxTargetSize));
    }
    const uint32_t channels = std::min(static_cast<uint32_t>(spec.nchannels), max_channels);
    Image image{.layout = {.width = static_cast<uint32_t>(spec.width), .height = static_cast<uint32_t>(spec.height)}};
    image.layout.channels = spec.channelnames;
    image.layout.channels.resize(channels);
    image.values.resize(size_t{image.layout.width} * image.layout.height * channels);
    if (!input->read_image(0, 0, 0, static_cast<int>(channels), OIIO::TypeDesc::FLOAT, image.values.data())) {
      return cannot_read(path, input->geterror());
    }
    return image;
  }

  [[nodiscard]] Result<void> write(const std::string& path, const Layout& layout,
                                   std::span<const float> values) const override {
    const OIIO::TypeDesc type = path.ends_with(".exr") ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    return write_as(path, layout, type, OIIO::TypeDesc::FLOAT, values.data());
  }

  [[nodiscard]] Result<void> write(const std::string& path, const Layout& layout,
                                   std::span<const uint8_t> values) const override {
    return write_as(path, layout, OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT8, values.data());
  }
};

}  // namespace
}  // namespace fillrule::images

const fillrule::images::ImageFiles* fillrule_image_files() {
  static const fillrule::images::OpenImageIo files;
  return &files;
}
