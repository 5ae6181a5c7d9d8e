// A scene's colours as a picture.
#pragma once

#include <cstdint>
#include <vector>

#include "cases/model/planes.h"
#include "cases/model/scene.h"

namespace fillrule::scene {

struct ColorPicture {
  uint32_t width = 0;  // pixels
  uint32_t height = 0;
  std::vector<float> rgb;  // row by row from the top left; 0 to 1, as shaded
};

// What a Painter drew; a pixel is the mean of its samples, the background where nothing landed.
ColorPicture picture_of(const Planes& planes, const Color& background);

}  // namespace fillrule::scene
