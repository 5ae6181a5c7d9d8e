#include "harness/faults/rasterizer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/faults/bresenham.h"
#include "harness/faults/fragment.h"

namespace fillrule::faults {
namespace {

// Pixels, `right` and `bottom` beyond the last ones.
struct Box {
  int64_t left = 0;
  int64_t top = 0;
  int64_t right = 0;
  int64_t bottom = 0;
};

Box intersection(const Box& a, const Box& b) {
  return {.left = std::max(a.left, b.left),
          .top = std::max(a.top, b.top),
          .right = std::min(a.right, b.right),
          .bottom = std::min(a.bottom, b.bottom)};
}

class DrawRasterizer {
 public:
  DrawRasterizer(const Context& context, uint32_t first_primitive, Planes& planes)
      : context_(context), fragments_(context, first_primitive, planes) {}

  void draw(const Primitive& primitive) {
    if (culled_by_distances(context_, primitive)) return;
    if (primitive.size == 3) {
      polygon(primitive);
    } else if (!(context_.has(Fault::kLinesCulled) && primitive.size == 2 && is_culled(context_, false))) {
      line_or_point(primitive, {.facing = true, .bias = 0});
    }
  }

 private:
  struct PolygonTraits {
    bool facing = true;
    double bias = 0;
  };

  void polygon(const Primitive& primitive) {
    const std::vector<Corner> clipped = clip(context_, primitive);
    if (clipped.empty()) return;
    const std::vector<WindowCorner> corners = in_window(primitive, clipped);
    if (out_of_range(context_, corners)) return;
    const Interpolant values(context_, corners);
    const PolygonTraits traits{.facing = is_front_facing(context_, clipped, corners),
                               .bias = depth_bias(context_, values)};
    const VkPolygonMode mode = context_.state().polygon_mode;
    const bool never_culled = mode != VK_POLYGON_MODE_FILL && context_.has(Fault::kPolygonModeBeforeCulling);
    if (is_culled(context_, traits.facing) && !never_culled) return;
    if (context_.has(Fault::kSmallAreaRejected) && std::abs(area(corners)) < 0.25) return;
    if (mode == VK_POLYGON_MODE_FILL) {
      const Surface surface{
          .primitive = primitive, .values = values, .depth_bias = traits.bias, .front_facing = traits.facing};
      fill(surface, outline_of(corners));
    } else {
      outline(primitive, corners, traits);
    }
  }

  // The edges or the corners of the polygon as it was, each clipped on its own.
  void outline(const Primitive& polygon, const std::vector<WindowCorner>& corners, const PolygonTraits& traits) {
    if (context_.state().polygon_mode == VK_POLYGON_MODE_LINE && context_.has(Fault::kOutlineOfPieces)) {
      for (size_t i = 1; i + 1 < corners.size(); ++i) {
        line(polygon, corners[0], corners[i], traits);
        line(polygon, corners[i], corners[i + 1], traits);
        line(polygon, corners[i + 1], corners[0], traits);
      }
      return;
    }
    for (size_t i = 0; i < 3; ++i) {
      Primitive part = polygon;
      part.vertices = {polygon.vertices[i], polygon.vertices[(i + 1) % 3]};
      part.size = context_.state().polygon_mode == VK_POLYGON_MODE_LINE ? 2 : 1;
      line_or_point(part, traits);
    }
  }

  void line_or_point(const Primitive& primitive, const PolygonTraits& traits) {
    const std::vector<Corner> clipped = clip(context_, primitive);
    if (clipped.empty()) return;
    const std::vector<WindowCorner> corners = in_window(primitive, clipped);
    if (primitive.size == 1) {
      point(primitive, corners.front(), traits);
    } else {
      line(primitive, corners[0], corners[1], traits);
    }
  }

  void line(const Primitive& primitive, const WindowCorner& a, const WindowCorner& b, const PolygonTraits& traits) {
    const Interpolant values(context_, {a, b});
    const Surface surface{
        .primitive = primitive, .values = values, .depth_bias = traits.bias, .front_facing = traits.facing};
    if (context_.state().line_mode == VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT) {
      diamonds(surface, a.snapped, b.snapped);
    } else {
      rectangle(surface, a, b);
    }
  }

  void rectangle(const Surface& surface, const WindowCorner& a, const WindowCorner& b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length = std::hypot(dx, dy);
    if (length == 0) return;
    const double half_width = context_.has(Fault::kLineWidthIgnored) ? 0.5 : double{context_.state().line_width} / 2;
    double aside_x = -dy / length * half_width;
    double aside_y = dx / length * half_width;
    if (context_.has(Fault::kLineAsParallelogram)) {
      aside_x = std::abs(dx) >= std::abs(dy) ? 0 : half_width;
      aside_y = std::abs(dx) >= std::abs(dy) ? half_width : 0;
    }
    fill(surface, {snapped(a.x - aside_x, a.y - aside_y), snapped(b.x - aside_x, b.y - aside_y),
                   snapped(b.x + aside_x, b.y + aside_y), snapped(a.x + aside_x, a.y + aside_y)});
  }

  void diamonds(const Surface& surface, const Snapped& a, const Snapped& b) {
    const DiamondExitLine line(context_, a, b);
    const auto reach = static_cast<int64_t>(context_.state().line_width / 2 + 2) << context_.subpixel_bits;
    const Box box = pixels_of({{a.x - reach, a.y - reach},
                               {b.x - reach, b.y - reach},
                               {a.x + reach, a.y + reach},
                               {b.x + reach, b.y + reach}});
    const uint32_t all = (1U << fragments_.locations().size()) - 1;
    for_each_pixel(intersection(box, allowed()), [&](int32_t x, int32_t y) {
      if (line.produces(x, y)) fragments_.fragment(surface, x, y, all);
    });
  }

  void point(const Primitive& primitive, const WindowCorner& centre, const PolygonTraits& traits) {
    const std::vector<float>& sizes = context_.draw.point_sizes;
    double size = sizes.empty() ? 1 : double{sizes[primitive.vertices[0]]};
    if (context_.has(Fault::kPointSizeRounded)) size = std::max(std::nearbyint(size), 1.0);
    const std::vector<Snapped> square{
        snapped(centre.x - size / 2, centre.y - size / 2), snapped(centre.x + size / 2, centre.y - size / 2),
        snapped(centre.x + size / 2, centre.y + size / 2), snapped(centre.x - size / 2, centre.y + size / 2)};
    const bool reaches_out = std::ranges::any_of(square, [&](const Snapped& corner) { return !in_viewport(corner); });
    if (context_.has(Fault::kPointsDroppedAtBorder) && reaches_out) return;
    const Interpolant values(context_, {centre});
    fill({.primitive = primitive,
          .values = values,
          .depth_bias = traits.bias,
          .front_facing = traits.facing,
          .point_x = centre.x,
          .point_y = centre.y,
          .point_size = size},
         square);
  }

  void fill(const Surface& surface, const std::vector<Snapped>& outline) {
    Box box = pixels_of(outline);
    if (context_.has(Fault::kLastColumnMissing)) box.right -= 1;
    for_each_pixel(intersection(box, allowed()), [&](int32_t x, int32_t y) {
      if (context_.has(Fault::kMissesBetweenCentres) && !covers(context_, outline, position(x, y, {}))) return;
      uint32_t covered = 0;
      for (size_t i = 0; i < fragments_.locations().size(); ++i) {
        const Snapped sample = position(x, y, fragments_.locations()[i]);
        if (in_viewport(sample) && covers(context_, outline, sample)) covered |= 1U << i;
      }
      if (covered != 0) fragments_.fragment(surface, x, y, covered);
    });
  }

  template <typename Visit>
  void for_each_pixel(const Box& box, const Visit& visit) const {
    for (int64_t y = box.top; y < box.bottom; ++y) {
      for (int64_t x = box.left; x < box.right; ++x) visit(static_cast<int32_t>(x), static_cast<int32_t>(y));
    }
  }

  // The pixels that an outline can touch.
  [[nodiscard]] Box pixels_of(const std::vector<Snapped>& outline) const {
    const auto [left, right] = std::ranges::minmax(outline, {}, &Snapped::x);
    const auto [top, bottom] = std::ranges::minmax(outline, {}, &Snapped::y);
    const uint32_t bits = context_.subpixel_bits;
    return {.left = left.x >> bits,
            .top = top.y >> bits,
            .right = (right.x >> bits) + 1,
            .bottom = (bottom.y >> bits) + 1};
  }

  // Scissor and target.
  [[nodiscard]] Box allowed() const {
    const Target& target = context_.drawn.target;
    const VkRect2D& scissor = context_.state().scissor;
    Box box{.left = scissor.offset.x, .top = scissor.offset.y};
    if (context_.has(Fault::kScissorMirrored)) {
      box.top = int64_t{target.height} - scissor.offset.y - int64_t{scissor.extent.height};
    }
    box.right = box.left + int64_t{scissor.extent.width} + (context_.has(Fault::kScissorOffByOne) ? 1 : 0);
    box.bottom = box.top + int64_t{scissor.extent.height} + (context_.has(Fault::kScissorOffByOne) ? 1 : 0);
    const int64_t columns = int64_t{target.width} + (context_.has(Fault::kColumnBeyondTarget) ? 1 : 0);
    return intersection(box, {.right = columns, .bottom = target.height});
  }

  [[nodiscard]] bool in_viewport(const Snapped& at) const {
    if (context_.has(Fault::kSpillsOverViewport) || context_.has(Fault::kColumnBeyondTarget)) return true;
    const VkViewport& viewport = context_.state().viewport;
    const double x = std::ldexp(static_cast<double>(at.x), -static_cast<int>(context_.subpixel_bits));
    const double y = std::ldexp(static_cast<double>(at.y), -static_cast<int>(context_.subpixel_bits));
    const auto [top, bottom] = std::minmax({double{viewport.y}, double{viewport.y} + double{viewport.height}});
    return x >= double{viewport.x} && x <= double{viewport.x} + double{viewport.width} && y >= top && y <= bottom;
  }

  [[nodiscard]] Snapped snapped(double x, double y) const { return {.x = snap(context_, x), .y = snap(context_, y)}; }

  [[nodiscard]] Snapped position(int32_t x, int32_t y, const Location& location) const {
    return sample_position(context_, x, y, location);
  }

  [[nodiscard]] std::vector<WindowCorner> in_window(const Primitive& primitive,
                                                    const std::vector<Corner>& clipped) const {
    std::vector<WindowCorner> corners;
    corners.reserve(clipped.size());
    for (const Corner& corner : clipped) corners.push_back(to_window(context_, primitive, corner));
    return corners;
  }

  static std::vector<Snapped> outline_of(const std::vector<WindowCorner>& corners) {
    std::vector<Snapped> outline;
    outline.reserve(corners.size());
    for (const WindowCorner& corner : corners) outline.push_back(corner.snapped);
    return outline;
  }

  // Signed, in pixels squared.
  static double area(const std::vector<WindowCorner>& corners) {
    double twice = 0;
    for (size_t i = 0; i < corners.size(); ++i) {
      const WindowCorner& a = corners[i];
      const WindowCorner& b = corners[(i + 1) % corners.size()];
      twice += a.x * b.y - b.x * a.y;
    }
    return twice / 2;
  }

  const Context& context_;
  FragmentStage fragments_;
};

}  // namespace

Planes draw_case(const Case& drawn, Fault fault, uint32_t subpixel_bits) {
  const Target& target = drawn.target;
  Planes planes =
      Planes::cleared(target.width, target.height, static_cast<uint32_t>(target.samples),
                      component_count(drawn.varyings), rounded_to_format(target.depth_format, target.clear_depth));
  if (target.depth_format == VK_FORMAT_UNDEFINED) planes.depth.clear();
  uint32_t first_primitive = 0;
  for (const Draw& draw : drawn.draws) {
    const Context context{.drawn = drawn, .draw = draw, .subpixel_bits = subpixel_bits, .fault = fault};
    DrawRasterizer rasterizer(context, first_primitive, planes);
    for (const Primitive& primitive : assemble(context)) rasterizer.draw(primitive);
    first_primitive += primitive_count(draw);
  }
  return planes;
}

}  // namespace fillrule::faults
