#include "harness/scene/picture.h"

namespace fillrule::scene {

ColorPicture picture_of(const Planes& planes, const Color& background) {
  ColorPicture picture{.width = planes.width, .height = planes.height};
  const size_t pixels = size_t{planes.width} * planes.height;
  picture.rgb.reserve(pixels * 3);
  for (size_t pixel = 0; pixel < pixels; ++pixel) {
    for (size_t channel = 0; channel < 3; ++channel) {
      float sum = 0;
      for (size_t sample = 0; sample < planes.samples; ++sample) {
        const size_t index = pixel * planes.samples + sample;
        sum += planes.hits[index] != 0 ? planes.varyings[channel][index] : static_cast<float>(background[channel]);
      }
      picture.rgb.push_back(sum / static_cast<float>(planes.samples));
    }
  }
  return picture;
}

}  // namespace fillrule::scene
