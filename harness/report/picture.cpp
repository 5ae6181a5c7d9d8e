#include "harness/report/picture.h"

#include <algorithm>
#include <cmath>

namespace fillrule::report {
namespace {

constexpr Rgb kBackground{24, 26, 31};
constexpr Rgb kBorder{96, 100, 110};
constexpr Rgb kNotFinite{255, 0, 255};
constexpr uint32_t kBorderWidth = 4;

// Distinguishable with any kind of colour vision (Okabe and Ito's palette, darkened or lightened for a dark ground).
constexpr std::array<Rgb, judge::kVerdictCount> kVerdictColours{
    Rgb{24, 26, 31}, Rgb{0, 90, 150}, Rgb{240, 228, 66}, Rgb{204, 121, 167}, Rgb{230, 97, 0}, Rgb{255, 255, 255}};

uint8_t to_byte(float value, const ValueRange& range) {
  const float span = range.high - range.low;
  const float unit = span > 0 ? (value - range.low) / span : 0.5F;
  // From 48: a fragment of the smallest value can still be told from the background.
  return static_cast<uint8_t>(std::lround(48 + 207 * std::clamp(unit, 0.0F, 1.0F)));
}

// Colours far apart for neighbouring numbers: the hue turns by the golden angle.
Rgb colour_of_primitive(uint32_t number) {
  const double hue = std::fmod(number * 0.618033988749895, 1.0) * 6;
  const auto channel = [hue](double shift) {
    const double position = std::fmod(hue + shift, 6.0);
    const double value = std::clamp(std::abs(position - 3) - 1, 0.0, 1.0);
    return static_cast<uint8_t>(std::lround(80 + 150 * value));
  };
  return {channel(0), channel(4), channel(2)};
}

Rgb colour_of_values(const Planes& planes, uint32_t components, size_t index, const ValueRange& range) {
  Rgb colour{};
  for (uint32_t c = 0; c < 3; ++c) {
    const float value = planes.varyings[components == 1 ? 0 : std::min(c, components - 1)][index];
    if (!std::isfinite(value)) return kNotFinite;
    colour[c] = components == 2 && c == 2 ? 48 : to_byte(value, range);
  }
  return colour;
}

void widen(ValueRange& range, const Planes& planes) {
  for (const auto& plane : planes.varyings) {
    for (size_t i = 0; i < plane.size(); ++i) {
      if (planes.hits[i] == 0 || !std::isfinite(plane[i])) continue;
      range.low = std::min(range.low, plane[i]);
      range.high = std::max(range.high, plane[i]);
    }
  }
}

}  // namespace

ValueRange range_of(const Planes& candidate, const Planes* reference) {
  ValueRange range;
  widen(range, candidate);
  if (reference != nullptr) widen(range, *reference);
  return range;
}

Picture picture_of(const Case& test_case, const Planes& planes, const ValueRange& range) {
  Picture picture(planes.width, planes.height, kBackground);
  const uint32_t components = test_case.varyings.empty() ? 0 : test_case.varyings.front().components;
  const auto colour_of_sample = [&](size_t index) {
    if (planes.hits[index] == 0) return kBackground;
    return components > 0 ? colour_of_values(planes, components, index, range)
                          : colour_of_primitive(planes.owner[index]);
  };
  for (size_t pixel = 0; pixel < picture.pixels.size(); ++pixel) {
    std::array<uint32_t, 3> sum{};
    for (size_t sample = 0; sample < planes.samples; ++sample) {
      const Rgb colour = colour_of_sample(pixel * planes.samples + sample);
      for (size_t c = 0; c < 3; ++c) sum[c] += colour[c];
    }
    for (size_t c = 0; c < 3; ++c) {
      picture.pixels[pixel][c] = static_cast<uint8_t>(sum[c] / std::max(planes.samples, 1U));
    }
  }
  return picture;
}

Picture difference_picture(const Case& test_case, const judge::CaseVerdict& verdict) {
  Picture picture(test_case.target.width, test_case.target.height, kBackground);
  const size_t samples = verdict.samples / picture.pixels.size();
  for (size_t pixel = 0; pixel < picture.pixels.size(); ++pixel) {
    judge::Verdict gravest = judge::Verdict::kIdentical;
    for (const judge::PlaneVerdict& plane : verdict.planes) {
      for (size_t sample = 0; sample < samples; ++sample) {
        gravest = std::max(gravest, plane.map[pixel * samples + sample]);
      }
    }
    picture.pixels[pixel] = kVerdictColours[static_cast<size_t>(gravest)];
  }
  return picture;
}

Picture side_by_side(const std::vector<Picture>& pictures, uint32_t scale) {
  uint32_t width = kBorderWidth;
  uint32_t height = 0;
  for (const Picture& picture : pictures) {
    width += picture.width * scale + kBorderWidth;
    height = std::max(height, picture.height * scale + 2 * kBorderWidth);
  }
  Picture sheet(width, height, kBorder);
  uint32_t left = kBorderWidth;
  for (const Picture& picture : pictures) {
    for (uint32_t y = 0; y < picture.height * scale; ++y) {
      for (uint32_t x = 0; x < picture.width * scale; ++x) {
        sheet.at(left + x, kBorderWidth + y) = picture.at(x / scale, y / scale);
      }
    }
    left += picture.width * scale + kBorderWidth;
  }
  return sheet;
}

}  // namespace fillrule::report
