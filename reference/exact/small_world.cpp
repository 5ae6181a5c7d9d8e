#include "reference/exact/small_world.h"

namespace fillrule::exact {
namespace {

// In half grid steps, so that sample locations are whole numbers on any grid.
struct HalfSteps {
  int32_t x = 0;
  int32_t y = 0;
};

bool is_inside(const HalfSteps& a, const HalfSteps& b, const HalfSteps& sample) {
  // E's gradient, which points inside. |E| <= 4 (2 * grid * size)^2: far below 2^31 for any grid worth a table.
  const int32_t gradient_x = a.y - b.y;
  const int32_t gradient_y = b.x - a.x;
  const int32_t value = gradient_x * (sample.x - a.x) + gradient_y * (sample.y - a.y);
  const bool is_left = gradient_x > 0;
  const bool is_top = gradient_x == 0 && gradient_y > 0;
  return value > 0 || (value == 0 && (is_left || is_top));
}

CellMask edge_mask(const HalfSteps& a, const HalfSteps& b, uint32_t grid, uint32_t size) {
  uint32_t mask = 0;
  for (uint32_t y = 0; y < size; ++y) {
    for (uint32_t x = 0; x < size; ++x) {
      const HalfSteps centre{static_cast<int32_t>((2 * x + 1) * grid), static_cast<int32_t>((2 * y + 1) * grid)};
      mask |= (is_inside(a, b, centre) ? 1U : 0U) << (y * size + x);
    }
  }
  return static_cast<CellMask>(mask);
}

}  // namespace

SmallWorld::SmallWorld(uint32_t grid, uint32_t size) : side_(grid * size + 1) {
  const uint32_t count = positions();
  const auto half_steps = [this](uint32_t number) {
    const GridPosition at = position(number);
    return HalfSteps{static_cast<int32_t>(2 * at.x), static_cast<int32_t>(2 * at.y)};
  };
  edges_.resize(size_t{count} * count);
  transposed_edges_.resize(edges_.size());
  for (uint32_t a = 0; a < count; ++a) {
    for (uint32_t b = 0; b < count; ++b) {
      const CellMask mask = edge_mask(half_steps(a), half_steps(b), grid, size);
      edges_[size_t{a} * count + b] = mask;
      transposed_edges_[size_t{b} * count + a] = mask;
    }
  }
}

}  // namespace fillrule::exact
