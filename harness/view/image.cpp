#include "harness/view/image.h"

#include "renderer/color.h"

namespace fillrule::view {

Image image_of(const scene::ColorPicture& picture) {
  Image image{.width = picture.width, .height = picture.height};
  image.rgba.reserve(picture.rgb.size() / 3);
  for (size_t i = 0; i + 2 < picture.rgb.size(); i += 3) {
    const renderer::Color<renderer::ScalarLanes> color{picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2], 1};
    image.rgba.push_back(static_cast<uint32_t>(renderer::packed_unorm8<renderer::ScalarLanes>(color)));
  }
  return image;
}

Image image_of(const report::Picture& picture) {
  Image image{.width = picture.width, .height = picture.height};
  image.rgba.reserve(picture.pixels.size());
  for (const report::Rgb& pixel : picture.pixels) {
    image.rgba.push_back(uint32_t{pixel[0]} | uint32_t{pixel[1]} << 8U | uint32_t{pixel[2]} << 16U | 0xFF000000U);
  }
  return image;
}

}  // namespace fillrule::view
