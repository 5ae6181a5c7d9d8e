#include "reference/exact/segment.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/exact/clip_position.h"

namespace fillrule::exact {
namespace {

// Every number below is a float32, or a sum or product of two: a few roundings of 2^-53 each.
constexpr double kRelative = 0x1p-49;
constexpr double kClipperRounding = kClipperRoundings * 0x1p-24;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

// The parameters where planes cut, each as the weights of both ends: exact to a relative error of 2^-51.
struct Segment::Cut {
  double begin_a = 1, begin_b = 0;
  double end_a = 0, end_b = 1;
  bool whole = true;

  // f >= 0 is inside. False if nothing is left.
  bool by(double fa, double fb) {
    if (fa >= 0 && fb >= 0) return true;
    if (fa < 0 && fb < 0) return false;
    whole = false;
    const double a = fb / (fb - fa);
    const double b = -fa / (fb - fa);
    if (fa < 0 && b > begin_b) begin_a = a, begin_b = b;
    if (fb < 0 && b < end_b) end_a = a, end_b = b;
    return true;
  }
  [[nodiscard]] bool empty() const { return begin_b > end_b * (1 + kRelative); }
};

Segment::Segment(const std::array<ClipPosition, 2>& vertices, const std::array<std::span<const float>, 2>& distances,
                 const RasterState& state)
    : vertices_(vertices), viewport_(state.viewport), negative_one_to_one_(state.negative_one_to_one) {
  undefined_ = std::any_of(vertices.begin(), vertices.end(),
                           [&](const ClipPosition& p) { return coordinates_leave_float32(p, viewport_); }) ||
               near_plane_by_flushing(vertices);
  for (const std::span<const float> of_vertex : distances) {
    undefined_ = undefined_ || std::any_of(of_vertex.begin(), of_vertex.end(), [](float d) { return std::isnan(d); });
  }
  if (undefined_) return;
  for (size_t i = 0; i < 2; ++i) {
    // Products of two float32 numbers: exact in double.
    u_[i] = double{viewport_.width} / 2 * double{vertices[i][0]};
    v_[i] = double{viewport_.height} / 2 * double{vertices[i][1]};
  }
  edge_.a = difference_of_products(v_[0], w(1), w(0), v_[1]);
  edge_.b = difference_of_products(w(0), u_[1], u_[0], w(1));
  edge_.c = difference_of_products(u_[0], v_[1], v_[0], u_[1]);
  edge_.error_a = std::abs(edge_.a) * 0x1p-51;
  edge_.error_b = std::abs(edge_.b) * 0x1p-51;
  edge_.error_c = std::abs(edge_.c) * 0x1p-51;
  scale_ = std::hypot(edge_.a, edge_.b);
  if (scale_ > 0) {
    direction_x_ = edge_.b / scale_;
    direction_y_ = -edge_.a / scale_;
  }
  clip(distances, state);
}

void Segment::clip(const std::array<std::span<const float>, 2>& distances, const RasterState& state) {
  const auto inside = [this](size_t axis, double sign, size_t vertex) {
    return w(vertex) + sign * double{vertices_[vertex][axis]};
  };
  Cut cut;
  bool visible = cut.by(w(0), w(1));
  if (state.depth_clip) {
    const double near_w = state.negative_one_to_one ? 1 : 0;
    visible = visible && cut.by(double{vertices_[0][2]} + near_w * w(0), double{vertices_[1][2]} + near_w * w(1)) &&
              cut.by(inside(2, -1, 0), inside(2, -1, 1));
  }
  for (size_t i = 0; i < distances[0].size(); ++i) {
    visible = visible && cut.by(double{distances[0][i]}, double{distances[1][i]});
  }
  if (!visible || cut.empty()) return;
  unbounded_ = part(cut);
  for (const size_t axis : {size_t{0}, size_t{1}}) {
    for (const double sign : {-1.0, 1.0}) visible = visible && cut.by(inside(axis, sign, 0), inside(axis, sign, 1));
  }
  if (visible && !cut.empty()) clipped_ = part(cut);
}

SegmentPart Segment::part(const Cut& cut) const {
  return {.begin = end_at(cut.begin_a, cut.begin_b, true),
          .end = end_at(cut.end_a, cut.end_b, false),
          .whole = cut.whole};
}

SegmentEnd Segment::end_at(double weight_a, double weight_b, bool is_begin) const {
  const double there_w = weight_a * w(0) + weight_b * w(1);
  const double error_w = kRelative * (weight_a * std::abs(w(0)) + weight_b * std::abs(w(1)));
  const double away = is_begin ? -kInfinity : kInfinity;
  if (there_w <= 2 * error_w) return {.along = away, .x = away * direction_x_, .y = away * direction_y_};
  SegmentEnd end{.w = there_w};
  end.x = (weight_a * u_[0] + weight_b * u_[1]) / there_w;
  end.y = (weight_a * v_[0] + weight_b * v_[1]) / there_w;
  end.along = along(end.x, end.y);
  // Twice the first-order error of the quotient.
  const double magnitude =
      weight_a * (std::abs(u_[0]) + std::abs(v_[0])) + weight_b * (std::abs(u_[1]) + std::abs(v_[1]));
  end.error = 2 * (kRelative * magnitude + (std::abs(end.x) + std::abs(end.y)) * error_w) / there_w;
  if (weight_a != 0 && weight_b != 0) {
    const double largest =
        std::max(std::max(std::abs(u_[0]), std::abs(u_[1])), std::max(std::abs(v_[0]), std::abs(v_[1])));
    const double largest_w = std::max(std::abs(w(0)), std::abs(w(1)));
    end.slop = kClipperRounding * (largest + std::max(std::abs(end.x), std::abs(end.y)) * largest_w) / there_w;
  }
  return end;
}

SegmentMoves Segment::moves(const Latitude& latitude) const {
  const SegmentPart& part = clipped_ ? *clipped_ : *unbounded_;
  const double x = std::abs(direction_x_);
  const double y = std::abs(direction_y_);
  SegmentMoves moves{.along = latitude.x * x + latitude.y * y, .across = latitude.x * y + latitude.y * x};
  moves.slop = std::max(part.begin.slop, part.end.slop);
  const double least_length = part.length() - 2 * (moves.along + moves.slop);
  moves.turn = 2 * (moves.across + moves.slop) / least_length;
  // Beyond half a radian its angle is no longer told from its tangent.
  moves.any_direction = scale_ == 0 || !(least_length > 0) || moves.turn > 0.5;
  return moves;
}

// The second terms: dx and dy round where the viewport's centre is no short number, and the quotient rounds.
double Segment::distance_error(double dx, double dy) const {
  return edge_.error_at(dx, dy) / scale_ * (1 + kRelative) + along_error(dx, dy);
}

double Segment::along_error(double dx, double dy) const {
  return kRelative * (std::abs(dx) + std::abs(dy) + std::abs(centre_x()) + std::abs(centre_y()));
}

}  // namespace fillrule::exact
