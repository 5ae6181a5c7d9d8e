// What a pane shows: R8G8B8A8, red in the lowest byte, row by row from the top left.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/report/picture.h"
#include "harness/scene/picture.h"

namespace fillrule::view {

struct Image {
  uint32_t width = 0;  // pixels
  uint32_t height = 0;
  std::vector<uint32_t> rgba;
};

// Colours are rounded as a colour attachment of the renderer is: to nearest, ties to even.
Image image_of(const scene::ColorPicture& picture);
Image image_of(const report::Picture& picture);

}  // namespace fillrule::view
