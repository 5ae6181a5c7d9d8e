#include "harness/scene/texel_bounds.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace fillrule::scene {
namespace {

// More of them, and a whole level is looked at.
constexpr size_t kManyStops = 4096;

constexpr ColorBounds kNothing{Interval{1e30, -1e30}, Interval{1e30, -1e30}, Interval{1e30, -1e30}};

void include_color(ColorBounds& bounds, const std::array<double, 3>& color) {
  for (size_t c = 0; c < 3; ++c) {
    bounds[c].low = std::min(bounds[c].low, color[c]);
    bounds[c].high = std::max(bounds[c].high, color[c]);
  }
}

void include(ColorBounds& bounds, const ColorBounds& other) {
  for (size_t c = 0; c < 3; ++c) {
    bounds[c].low = std::min(bounds[c].low, other[c].low);
    bounds[c].high = std::max(bounds[c].high, other[c].high);
  }
}

// "Wrapping Operation". -1 is the border.
double wrapped(double i, double size, VkSamplerAddressMode mode) {
  const auto rest = [](double value, double divisor) { return value - divisor * std::floor(value / divisor); };
  switch (mode) {
    case VK_SAMPLER_ADDRESS_MODE_REPEAT:
      return rest(i, size);
    case VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT:
      return std::floor(std::abs(rest(i + 0.5 + size, 2 * size) - size));
    case VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER:
      return i < 0 || i >= size ? -1 : i;
    default:
      return std::clamp(i, 0.0, size - 1);
  }
}

// A column or row of texels, wrapped, or the two that a place is between, with the weight of the second. -1 is the
// border.
struct Stop {
  int first = 0;
  int second = 0;
  double weight = 0;
};

// `place` is in texels, as everywhere below.
Stop at_texel(double place, double size, VkSamplerAddressMode mode) {
  return {.first = static_cast<int>(wrapped(std::floor(place), size, mode))};
}

Stop between_texels(double place, double size, VkSamplerAddressMode mode) {
  const double before = std::floor(place - 0.5);
  return {.first = static_cast<int>(wrapped(before, size, mode)),
          .second = static_cast<int>(wrapped(before + 1, size, mode)),
          .weight = place - 0.5 - before};
}

double border_of(const Sampling2D& sampling) {
  return sampling.border == VK_BORDER_COLOR_FLOAT_OPAQUE_WHITE ? 1 : 0;
}

// What a sampler gives at one place of a level.
class LevelTexels {
 public:
  LevelTexels(const TextureLevel& level, const Sampling2D& sampling) : level_(level), sampling_(sampling) {}

  [[nodiscard]] std::array<double, 3> at(const Stop& column, const Stop& row) const {
    return sampling_.filter == VK_FILTER_NEAREST ? texel(column.first, row.first) : bilinear(column, row);
  }

 private:
  [[nodiscard]] std::array<double, 3> texel(int column, int row) const {
    if (column < 0 || row < 0) {
      const double border = border_of(sampling_);
      return {border, border, border};
    }
    const Texel& found = level_.texels[static_cast<size_t>(row) * level_.width + static_cast<size_t>(column)];
    return {found[0], found[1], found[2]};
  }

  [[nodiscard]] std::array<double, 3> bilinear(const Stop& x, const Stop& y) const {
    std::array<double, 3> sum{};
    for (int corner = 0; corner < 4; ++corner) {
      const bool is_right = corner % 2 != 0;
      const bool is_lower = corner >= 2;
      const double weight = (is_right ? x.weight : 1 - x.weight) * (is_lower ? y.weight : 1 - y.weight);
      const auto color = texel(is_right ? x.second : x.first, is_lower ? y.second : y.first);
      for (size_t c = 0; c < 3; ++c) sum[c] += weight * color[c];
    }
    return sum;
  }

  const TextureLevel& level_;
  const Sampling2D& sampling_;
};

// One level, with coordinates in texels.
class LevelBounds {
 public:
  LevelBounds(const TextureLevel& level, const Sampling2D& sampling, const SurfaceRange& range,
              const SamplerPrecision& precision)
      : level_(level), sampling_(sampling) {
    const glm::dvec2 size(level.width, level.height);
    const glm::dvec2 centre = range.uv * size;
    const double weights =
        sampling.filter == VK_FILTER_LINEAR ? std::ldexp(1.0, -static_cast<int>(precision.sub_texel_bits)) : 0;
    const glm::dvec2 error = range.uv_error * size + 0x1p-23 * (glm::abs(centre) + size) + weights;
    low_ = centre - error;
    high_ = centre + error;
  }

  [[nodiscard]] ColorBounds bounds() const {
    static thread_local std::vector<Stop> columns;  // their memory is used again for each fragment
    static thread_local std::vector<Stop> rows;
    find_stops(low_.x, high_.x, level_.width, sampling_.wrap_u, columns);
    find_stops(low_.y, high_.y, level_.height, sampling_.wrap_v, rows);
    if (columns.size() * rows.size() > kManyStops) return whole_level();
    const LevelTexels texels(level_, sampling_);
    ColorBounds bounds = kNothing;
    for (const Stop& row : rows) {
      for (const Stop& column : columns) include_color(bounds, texels.at(column, row));
    }
    return bounds;
  }

 private:
  // The texels, or the ends and the texel centres, between two coordinates.
  void find_stops(double low, double high, double size, VkSamplerAddressMode mode, std::vector<Stop>& stops) const {
    const double first = std::floor(low);
    const double texels = std::floor(high) - first + 1;
    // NaN too.
    if (!(texels <= kManyStops)) {
      stops.assign(kManyStops + 1, {});
      return;
    }
    stops.clear();
    if (sampling_.filter == VK_FILTER_LINEAR) {
      stops.push_back(between_texels(low, size, mode));
      stops.push_back(between_texels(high, size, mode));
    }
    for (int i = 0; i < static_cast<int>(texels); ++i) {
      const double texel = first + i;
      if (sampling_.filter == VK_FILTER_NEAREST) {
        stops.push_back(at_texel(texel, size, mode));
      } else if (texel + 0.5 > low && texel + 0.5 < high) {
        stops.push_back(between_texels(texel + 0.5, size, mode));
      }
    }
  }

  [[nodiscard]] ColorBounds whole_level() const {
    ColorBounds bounds = kNothing;
    for (const Texel& one : level_.texels) include_color(bounds, {one[0], one[1], one[2]});
    const double border = border_of(sampling_);
    include_color(bounds, {border, border, border});
    return bounds;
  }

  const TextureLevel& level_;
  const Sampling2D& sampling_;
  glm::dvec2 low_{};
  glm::dvec2 high_{};
};

// The level of detail, within those that there are.
Interval level_of_detail(const Texture& texture, const SurfaceRange& range) {
  const glm::dvec2 size(texture.levels[0].width, texture.levels[0].height);
  Interval step;
  for (size_t axis = 0; axis < 2; ++axis) {
    const double length = glm::length(range.uv_step[axis] * size);
    const double error = glm::length(range.uv_step_error[axis] * size) + 0x1p-20 * length;
    step.low = std::max(step.low, length - error);
    step.high = std::max(step.high, length + error);
  }
  const auto last = static_cast<double>(texture.levels.size() - 1);
  const auto level = [&](double texels, double error) {
    return texels > 0 ? std::clamp(std::log2(texels) + error, 0.0, last) : 0.0;
  };
  return {level(step.low, -0x1p-21), level(step.high, 0x1p-21)};
}

// The same where nothing is off.
double exact_level_of_detail(const Texture& texture, const SurfaceRange& range) {
  const glm::dvec2 size(texture.levels[0].width, texture.levels[0].height);
  const double texels = std::max(glm::length(range.uv_step[0] * size), glm::length(range.uv_step[1] * size));
  const auto last = static_cast<double>(texture.levels.size() - 1);
  return texels > 0 ? std::clamp(std::log2(texels), 0.0, last) : 0.0;
}

}  // namespace

std::array<double, 3> exact_texel(const Texture& texture, const SurfaceRange& range) {
  const Sampling2D& sampling = texture.sampling;
  const auto stop = sampling.filter == VK_FILTER_NEAREST ? at_texel : between_texels;
  const auto of_level = [&](double number) {
    const TextureLevel& level = texture.levels[static_cast<size_t>(number)];
    const glm::dvec2 place = range.uv * glm::dvec2(level.width, level.height);
    return LevelTexels(level, sampling)
        .at(stop(place.x, level.width, sampling.wrap_u), stop(place.y, level.height, sampling.wrap_v));
  };
  if (sampling.mipmaps == Mipmaps::kNone) return of_level(0);
  const double lod = exact_level_of_detail(texture, range);
  // "Image Level(s) Selection"; of two as near as each other either is right.
  if (sampling.mipmaps == Mipmaps::kNearest) return of_level(std::max(std::ceil(lod + 0.5) - 1, 0.0));
  const double fine = std::floor(lod);
  const double weight = lod - fine;
  std::array<double, 3> color = of_level(fine);
  if (weight == 0) return color;
  const std::array<double, 3> coarse = of_level(fine + 1);
  for (size_t c = 0; c < color.size(); ++c) color[c] = color[c] * (1 - weight) + coarse[c] * weight;
  return color;
}

ColorBounds texel_bounds(const Texture& texture, const SurfaceRange& range, const SamplerPrecision& precision) {
  const Sampling2D& sampling = texture.sampling;
  const auto of_level = [&](double level) {
    return LevelBounds(texture.levels[static_cast<size_t>(level)], sampling, range, precision).bounds();
  };
  if (sampling.mipmaps == Mipmaps::kNone) return of_level(0);
  const auto last = static_cast<double>(texture.levels.size() - 1);
  Interval lod = level_of_detail(texture, range);
  const double error = std::ldexp(1.0, -static_cast<int>(precision.mipmap_bits));
  ColorBounds bounds = kNothing;
  if (sampling.mipmaps == Mipmaps::kNearest) {
    const auto first = static_cast<int>(std::max(std::ceil(lod.low + 0.5) - 1, 0.0));
    const auto end = static_cast<int>(std::min(std::floor(lod.high + 0.5), last));
    for (int level = first; level <= end; ++level) include(bounds, of_level(level));
    return bounds;
  }
  lod = {std::max(lod.low - error, 0.0), std::min(lod.high + error, last)};
  std::vector<double> stops{lod.low, lod.high};
  for (auto level = static_cast<int>(std::ceil(lod.low)); level < lod.high; ++level) stops.push_back(level);
  for (const double stop : stops) {
    const double fine = std::floor(stop);
    const ColorBounds a = of_level(fine);
    const ColorBounds b = of_level(std::min(fine + 1, last));
    const double weight = stop - fine;
    for (size_t c = 0; c < 3; ++c) {
      bounds[c].low = std::min(bounds[c].low, a[c].low * (1 - weight) + b[c].low * weight);
      bounds[c].high = std::max(bounds[c].high, a[c].high * (1 - weight) + b[c].high * weight);
    }
  }
  return bounds;
}

}  // namespace fillrule::scene
