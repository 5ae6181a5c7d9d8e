// The exact values of one piece of a primitive: what the judge asks of a triangle, a line or a point alike.
//
// Positions (x, y) are framebuffer coordinates. Components are those that the vertices carry (Draw::varyings), in
// their order.
#pragma once

#include <cstdint>
#include <span>

namespace fillrule::exact {

// Beyond the bound, but within this multiple of it, a value is imprecise; beyond, at fault.
inline constexpr double kImpreciseFactor = 64;

struct Expected {
  double value = 0;
  double tolerance = 0;  // infinity where the value is not judged
  // All values so far from `value` are exact answers too: what the specification leaves open, such as the constant of
  // a depth bias. Never scaled by kImpreciseFactor.
  double spread = 0;
};

// What a tolerance is made of: interpolating between rounded vertices, and rounding on the way.
struct Tolerance {
  double snapping = 0;
  double rounding = 0;
  // Infinite where either is unknown.
  [[nodiscard]] double total() const;
};

class PieceValues {
 public:
  virtual ~PieceValues() = default;

  // The depth in window space: biased, neither clamped nor rounded to a format. The tolerance may be returned smaller
  // than it is where `value` is within it anyway, which is cheaper to tell.
  [[nodiscard]] virtual Expected depth_for(float value, double x, double y) const = 0;
  // ... with all of the tolerance.
  [[nodiscard]] virtual Expected depth(double x, double y) const = 0;
  // ... of a sample that the piece must cover, with a tolerance that is no less, and cheaper to tell.
  [[nodiscard]] virtual Expected depth_inside(double x, double y) const { return depth(x, y); }
  [[nodiscard]] virtual Tolerance depth_tolerance(double x, double y) const = 0;
  // A certain bound of how far the value that depth() gives, a double, is from the exact one; and that one, rounded
  // to double once.
  [[nodiscard]] virtual double depth_error(double x, double y) const = 0;
  [[nodiscard]] virtual double exact_depth(double x, double y) const = 0;

  // 1/w, what gl_FragCoord.w shows, in the same way.
  [[nodiscard]] virtual Expected reciprocal_w(double x, double y) const = 0;
  [[nodiscard]] virtual double reciprocal_w_error(double x, double y) const = 0;
  [[nodiscard]] virtual double exact_reciprocal_w(double x, double y) const = 0;

  // The provoking vertex's value: that of a flat component.
  [[nodiscard]] virtual float provoking(uint32_t component) const = 0;
  // False where a vertex's value is not finite, or leaves float32 on the way.
  [[nodiscard]] virtual bool judged(uint32_t component) const = 0;
  // The same as of depth, for components that are not flat.
  [[nodiscard]] virtual Expected varying_for(uint32_t component, float value, double x, double y) const = 0;
  // ... of the components `wanted`, each put in its place among all, with all of the tolerances.
  void varyings(double x, double y, std::span<const uint32_t> wanted, std::span<Expected> components) const;
  // ... with tolerances that are no more than those: cheap, for the many values that are well within them.
  virtual void least_varyings(double x, double y, std::span<const uint32_t> wanted,
                              std::span<Expected> components) const;
  [[nodiscard]] virtual Tolerance varying_tolerance(uint32_t component, double x, double y) const = 0;
  [[nodiscard]] virtual double varying_error(uint32_t component, double x, double y) const = 0;
  [[nodiscard]] virtual double exact_varying(uint32_t component, double x, double y) const = 0;

 protected:
  PieceValues() = default;
  PieceValues(const PieceValues&) = default;
  PieceValues& operator=(const PieceValues&) = default;
  PieceValues(PieceValues&&) = default;
  PieceValues& operator=(PieceValues&&) = default;
};

}  // namespace fillrule::exact
