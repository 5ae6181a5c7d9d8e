#include "harness/faults/coverage.h"

#include <algorithm>
#include <cmath>

namespace fillrule::faults {
namespace {

// On which side of the edge from a to b the position is: 0 on the edge.
template <typename Number>
Number side_of(const Snapped& a, const Snapped& b, const Snapped& p) {
  return static_cast<Number>(b.x - a.x) * static_cast<Number>(p.y - a.y) -
         static_cast<Number>(p.x - a.x) * static_cast<Number>(b.y - a.y);
}

// The same as a linear function from the framebuffer's corner, its constant taken from the edge's first vertex.
float side_in_float(const Snapped& a, const Snapped& b, const Snapped& p) {
  const auto dx = static_cast<float>(b.x - a.x);
  const auto dy = static_cast<float>(b.y - a.y);
  const float constant = dy * static_cast<float>(a.x) - dx * static_cast<float>(a.y);
  return dx * static_cast<float>(p.y) - dy * static_cast<float>(p.x) + constant;
}

int sign(auto value) {
  return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0);
}

// Negative where the position is to the right of the edge, whichever way that runs.
int side_sign(const Context& context, const Snapped& a, const Snapped& b, const Snapped& p) {
  const int down = a.y < b.y ? 1 : -1;
  if (context.has(Fault::kFloatEdges)) return down * sign(side_in_float(a, b, p));
  if (context.has(Fault::kEdgesIn32Bits)) return down * sign(static_cast<int32_t>(side_of<uint32_t>(a, b, p)));
  return down * sign(side_of<__int128>(a, b, p));
}

bool is_on(const Snapped& a, const Snapped& b, const Snapped& p) {
  const auto [left, right] = std::minmax(a.x, b.x);
  const auto [top, bottom] = std::minmax(a.y, b.y);
  return p.x >= left && p.x <= right && p.y >= top && p.y <= bottom && side_of<__int128>(a, b, p) == 0;
}

// Whether the ray from the position to the left crosses the edge.
bool crosses(const Context& context, const Snapped& a, const Snapped& b, const Snapped& p) {
  const bool lower_end_counts = context.has(Fault::kBottomRightRule) || context.has(Fault::kHorizontalTies);
  const auto above = [&](const Snapped& end) { return lower_end_counts ? end.y < p.y : end.y <= p.y; };
  if (above(a) == above(b)) return false;
  const int side = side_sign(context, a, b, p);
  return context.has(Fault::kBottomRightRule) ? side < 0 : side <= 0;
}

int64_t pixel_of(int64_t subpixels, uint32_t subpixel_bits) {
  return subpixels >> subpixel_bits;
}

// Spans of pixels between the crossings of a row's centre line, ends truncated and included.
bool in_truncated_span(const Context& context, const std::vector<Snapped>& outline, const Snapped& p) {
  std::vector<int64_t> crossings;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Snapped& a = outline[i];
    const Snapped& b = outline[(i + 1) % outline.size()];
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    const double x = static_cast<double>(a.x) +
                     static_cast<double>(b.x - a.x) * static_cast<double>(p.y - a.y) / static_cast<double>(b.y - a.y);
    crossings.push_back(pixel_of(static_cast<int64_t>(std::floor(x)), context.subpixel_bits));
  }
  std::ranges::sort(crossings);
  const int64_t pixel = pixel_of(p.x, context.subpixel_bits);
  for (size_t i = 0; i + 1 < crossings.size(); i += 2) {
    if (crossings[i] <= pixel && pixel <= crossings[i + 1]) return true;
  }
  return false;
}

std::vector<Location> standard_locations(VkSampleCountFlagBits samples) {
  switch (samples) {
    case VK_SAMPLE_COUNT_2_BIT:
      return {{12, 12}, {4, 4}};
    case VK_SAMPLE_COUNT_4_BIT:
      return {{6, 2}, {14, 6}, {2, 10}, {10, 14}};
    case VK_SAMPLE_COUNT_8_BIT:
      return {{9, 5}, {7, 11}, {13, 9}, {5, 3}, {3, 13}, {1, 7}, {11, 15}, {15, 1}};
    case VK_SAMPLE_COUNT_16_BIT:
      return {{9, 9},  {7, 5}, {5, 10}, {12, 7}, {3, 6}, {10, 13}, {13, 11}, {11, 3},
              {6, 14}, {8, 1}, {4, 2},  {2, 12}, {0, 8}, {15, 4},  {14, 15}, {1, 0}};
    default:
      return {{8, 8}};
  }
}

// As square as the number allows.
std::vector<Location> regular_grid(int32_t samples) {
  const int32_t columns = samples >= 8 ? 4 : 2;
  const int32_t rows = std::max(samples / columns, 1);
  std::vector<Location> grid;
  grid.reserve(static_cast<size_t>(samples));
  for (int32_t i = 0; i < samples; ++i) {
    grid.push_back({.x = (2 * (i % columns) + 1) * 8 / columns, .y = (2 * (i / columns) + 1) * 8 / rows});
  }
  return grid;
}

}  // namespace

std::vector<Location> sample_locations(const Context& context) {
  std::vector<Location> locations = standard_locations(context.drawn.target.samples);
  const bool several = locations.size() > 1;
  if (context.has(Fault::kSamplesOnRegularGrid) && several) {
    return regular_grid(static_cast<int32_t>(locations.size()));
  }
  for (Location& location : locations) {
    if (context.has(Fault::kSamplesMirrored) && several) location.x = 16 - location.x;
    if (context.has(Fault::kPixelCorners)) location = {.x = location.x - 8, .y = location.y - 8};
  }
  return locations;
}

Snapped sample_position(const Context& context, int32_t x, int32_t y, const Location& location) {
  const int64_t pixel = int64_t{1} << context.subpixel_bits;
  return {.x = x * pixel + location.x * pixel / 16, .y = y * pixel + location.y * pixel / 16};
}

bool covers(const Context& context, const std::vector<Snapped>& outline, const Snapped& position) {
  if (context.has(Fault::kSpansTruncated)) return in_truncated_span(context, outline, position);
  const int64_t half_pixel = (int64_t{1} << context.subpixel_bits) / 2;
  Snapped p = position;
  if (context.has(Fault::kRowsFromTheirTop)) p.y -= half_pixel;
  bool inside = false;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Snapped& a = outline[i];
    const Snapped& b = outline[(i + 1) % outline.size()];
    if (context.has(Fault::kEdgesInclusive) && is_on(a, b, p)) return true;
    if (context.has(Fault::kEdgesExclusive) && is_on(a, b, p)) return false;
    if (crosses(context, a, b, p)) inside = !inside;
  }
  return inside;
}

}  // namespace fillrule::faults
