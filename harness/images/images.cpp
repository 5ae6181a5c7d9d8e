#include "harness/images/images.h"

#include <dlfcn.h>

#include "harness/images/image_files.h"

namespace fillrule::images {
namespace {

Result<const ImageFiles*> load() {
  const auto cannot_load = [] {
    return failure(std::string("images cannot be read or written: ") + dlerror(),
                   "it is built with fillrule and stays beside it");
  };
  // Never closed: images are read and written until the end.
  void* const library = dlopen(FILLRULE_IMAGE_FILES, RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) return cannot_load();
  void* const symbol = dlsym(library, "fillrule_image_files");
  if (symbol == nullptr) return cannot_load();
  return reinterpret_cast<decltype(&fillrule_image_files)>(symbol)();
}

const Result<const ImageFiles*>& image_files() {
  static const Result<const ImageFiles*> loaded = load();
  return loaded;
}

}  // namespace

std::jthread load_ahead() {
  return std::jthread([] { image_files(); });
}

Layout rgb_layout(uint32_t width, uint32_t height) {
  return {.width = width, .height = height, .channels = {"R", "G", "B"}};
}

Result<Image> read(const std::string& path, uint32_t max_channels) {
  return image_files().and_then([&](const ImageFiles* files) { return files->read(path, max_channels); });
}

Result<void> write(const std::string& path, const Layout& layout, std::span<const float> values) {
  return image_files().and_then([&](const ImageFiles* files) { return files->write(path, layout, values); });
}

Result<void> write(const std::string& path, const Layout& layout, std::span<const uint8_t> values) {
  return image_files().and_then([&](const ImageFiles* files) { return files->write(path, layout, values); });
}

}  // namespace fillrule::images
