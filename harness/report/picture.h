// An 8-bit RGB picture in memory, and how planes and verdicts are turned into one.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "harness/judge/verdict.h"

namespace fillrule::report {

using Rgb = std::array<uint8_t, 3>;

struct Picture {
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<Rgb> pixels;  // row by row from the top left

  Picture(uint32_t the_width, uint32_t the_height, Rgb fill)
      : width(the_width), height(the_height), pixels(size_t{the_width} * the_height, fill) {}
  Rgb& at(uint32_t x, uint32_t y) { return pixels[size_t{y} * width + x]; }
  [[nodiscard]] const Rgb& at(uint32_t x, uint32_t y) const { return pixels[size_t{y} * width + x]; }
};

// What a party drew: the first varying as colour where there is one, scaled to the range of both parties, else a
// colour for each primitive; dark where nothing landed. The colour of a pixel is the mean of its samples.
struct ValueRange {
  float low = 0;
  float high = 1;
};
ValueRange range_of(const Planes& candidate, const Planes* reference);
Picture picture_of(const Case& test_case, const Planes& planes, const ValueRange& range);

// The gravest verdict over all planes, one colour each: dark identical, blue permitted, yellow imprecise, violet
// reference fault, orange candidate fault, white both at fault.
Picture difference_picture(const Case& test_case, const judge::CaseVerdict& verdict);

// Side by side with a border, every pixel enlarged `scale` times.
Picture side_by_side(const std::vector<Picture>& pictures, uint32_t scale);

}  // namespace fillrule::report
