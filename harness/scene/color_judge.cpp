#include "harness/scene/color_judge.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "harness/scene/color_bounds.h"
#include "reference/exact/expectation.h"

namespace fillrule::scene {
namespace {

// Which colours parties of equal subpixel bits may have, sample by sample.
class AllowedColors {
 public:
  AllowedColors(const Case& built, const programs::CaseShading& shading, const exact::Expectation& expectation,
                const TransformError& error)
      : case_(built),
        shading_(shading),
        error_(error),
        expectation_(expectation),
        values_(expectation.pieces().size()) {}

  // The bounds that a colour of this owner is in, or else the first ones that it is not in; none where nothing can be
  // said.
  struct Answer {
    bool judged = false;
    bool inside = false;
    ColorBounds bounds{};
  };
  Answer of(size_t sample, double x, double y, uint32_t owner, const std::array<float, 3>& color) {
    if (!asked_ || sample != sample_ || owner != owner_) {
      asked_ = true;
      sample_ = sample;
      owner_ = owner;
      for (Bounds& bounds : bounds_) bounds.known = false;
    }
    // Nearly all colours are within the narrow bounds, and hence within the others.
    for (const ColorBounds& bounds : bounds_at(Tolerances::kLeast, x, y).bounds) {
      if (is_inside(color, bounds)) return {.judged = true, .inside = true, .bounds = bounds};
    }
    const Bounds& all = bounds_at(Tolerances::kAll, x, y);
    for (const ColorBounds& bounds : all.bounds) {
      if (is_inside(color, bounds)) return {.judged = true, .inside = true, .bounds = bounds};
    }
    if (all.is_open || all.bounds.empty()) return {};
    return {.judged = true, .bounds = all.bounds.front()};
  }

 private:
  // Which tolerances of the varyings bounds are made with: lower bounds of them (PieceValues::least_varyings), which
  // are cheap and accuse nobody, or the real ones, the only ones that a colour can be outside of.
  enum class Tolerances : uint8_t { kLeast, kAll };
  // Of the sample and owner asked for last: those of all pieces, up to the first of which nothing can be said.
  struct Bounds {
    bool known = false;
    bool is_open = false;
    std::vector<ColorBounds> bounds;
  };

  static bool is_inside(const std::array<float, 3>& color, const ColorBounds& bounds) {
    bool inside = true;
    for (size_t c = 0; c < 3; ++c) {
      // So that NaN is outside.
      inside = inside && double{color[c]} >= bounds[c].low && double{color[c]} <= bounds[c].high;
    }
    return inside;
  }

  const Bounds& bounds_at(Tolerances tolerances, double x, double y) {
    Bounds& bounds = bounds_[static_cast<size_t>(tolerances)];
    if (!bounds.known) work_out(tolerances, x, y, bounds);
    return bounds;
  }

  void work_out(Tolerances tolerances, double x, double y, Bounds& result) {
    result.known = true;
    result.is_open = false;
    result.bounds.clear();
    expectation_.collect(sample_, entries_);
    for (const exact::Entry& entry : entries_) {
      const exact::Piece& piece = expectation_.pieces()[entry.piece];
      if (piece.owner != owner_) continue;
      // The values of such pieces are undefined ground.
      const bool is_defined = !piece.shape->undefined() && !piece.thin;
      const auto range = is_defined ? range_of(tolerances, entry.piece, piece, x, y) : std::nullopt;
      if (!range) {
        result.is_open = true;
        return;
      }
      result.bounds.push_back(color_bounds(shading_[piece.draw], *range, {}));
    }
  }

  const exact::PieceValues& values(uint32_t number, const exact::Piece& piece) {
    std::unique_ptr<exact::PieceValues>& values = values_[number];
    if (!values) values = exact::values_of(case_, piece);
    return *values;
  }

  using Components = std::array<exact::Expected, programs::kSceneComponents>;

  static Components components_at(Tolerances tolerances, const exact::PieceValues& values, double x, double y) {
    Components components;
    if (tolerances == Tolerances::kLeast) {
      values.least_varyings(x, y, components);
    } else {
      values.varyings(x, y, components);
    }
    return components;
  }

  std::optional<SurfaceRange> range_of(Tolerances tolerances, uint32_t number, const exact::Piece& piece, double x,
                                       double y) {
    const exact::PieceValues& exact_values = values(number, piece);
    const Components here = components_at(tolerances, exact_values, x, y);
    SurfaceRange range;
    double worst = 0;
    const auto read = [&](const Components& components, uint32_t component, double& value, double& error) {
      value = components[component].value;
      error = components[component].tolerance;
      worst = std::max(worst, error);
    };
    for (uint32_t c = 0; c < 3; ++c) {
      const auto i = static_cast<glm::length_t>(c);
      read(here, programs::kPositionComponent + c, range.position_world[i], range.position_error[i]);
      read(here, programs::kNormalComponent + c, range.normal_world[i], range.normal_error[i]);
      range.position_error[i] += error_.position_world;
      range.normal_error[i] += error_.normal_world;
    }
    for (uint32_t c = 0; c < 2; ++c) {
      const auto i = static_cast<glm::length_t>(c);
      read(here, programs::kUvComponent + c, range.uv[i], range.uv_error[i]);
    }
    if (shading_[piece.draw].uniforms.mipmapped != 0) {
      for (uint32_t axis = 0; axis < 2; ++axis) {
        read_step(
            axis, [&](double at_x, double at_y) { return components_at(tolerances, exact_values, at_x, at_y); }, read,
            x, y, range);
      }
    }
    if (!std::isfinite(worst)) return std::nullopt;
    return range;
  }

  // The difference along one axis in the quad of pixels that begins at even coordinates.
  template <typename ComponentsAt, typename Read>
  static void read_step(uint32_t axis, const ComponentsAt& components_at, const Read& read, double x, double y,
                        SurfaceRange& range) {
    const bool is_first = std::fmod(std::floor(axis == 0 ? x : y), 2) == 0;
    const double to_other = is_first ? 1 : -1;
    const Components there = components_at(axis == 0 ? x + to_other : x, axis == 0 ? y : y + to_other);
    for (uint32_t c = 0; c < 2; ++c) {
      const auto i = static_cast<glm::length_t>(c);
      double value = 0;
      double error = 0;
      read(there, programs::kUvComponent + c, value, error);
      range.uv_step[axis][i] = (value - range.uv[i]) * to_other;
      range.uv_step_error[axis][i] = error + range.uv_error[i];
    }
  }

  const Case& case_;
  const programs::CaseShading& shading_;
  TransformError error_;
  const exact::Expectation& expectation_;
  std::vector<exact::Entry> entries_;
  std::vector<std::unique_ptr<exact::PieceValues>> values_;  // of each piece that was asked for
  // What was asked for last.
  bool asked_ = false;
  size_t sample_ = 0;
  uint32_t owner_ = 0;
  std::array<Bounds, 2> bounds_;  // by Tolerances
};

std::array<float, 3> color_at(const Planes& planes, size_t index) {
  return {planes.varyings[0][index], planes.varyings[1][index], planes.varyings[2][index]};
}

std::string in_words(const Planes& planes, size_t index, const std::array<float, 3>& color,
                     const ColorBounds& bounds) {
  const size_t pixel = index / planes.samples;
  return fmt::format(
      "({}, {}): colour {:.6f} {:.6f} {:.6f}, allowed {:.6f} to {:.6f}, {:.6f} to {:.6f}, {:.6f} to {:.6f}",
      pixel % planes.width, pixel / planes.width, color[0], color[1], color[2], bounds[0].low, bounds[0].high,
      bounds[1].low, bounds[1].high, bounds[2].low, bounds[2].high);
}

void judge_sample(AllowedColors& allowed, const Planes& planes, size_t index, PartyColors& result) {
  if (planes.hits[index] == 0) return;
  const size_t pixel = index / planes.samples;
  const size_t row = pixel / planes.width;
  const auto color = color_at(planes, index);
  const auto answer = allowed.of(index, static_cast<double>(pixel % planes.width) + 0.5,
                                 static_cast<double>(row) + 0.5, planes.owner[index], color);
  if (!answer.judged) return;
  ++result.judged;
  if (answer.inside) return;
  if (result.outside++ == 0) result.first = in_words(planes, index, color, answer.bounds);
}

}  // namespace

ColorVerdict judge_colors(const Case& built, const programs::CaseShading& shading, const judge::Oracle& oracle,
                          const ColorParty& candidate, const ColorParty* reference, const TransformError& error) {
  ColorVerdict verdict;
  AllowedColors allowed(built, shading, oracle.for_candidate(), error);
  std::optional<AllowedColors> of_reference;
  if (reference != nullptr && &oracle.for_reference() != &oracle.for_candidate()) {
    of_reference.emplace(built, shading, oracle.for_reference(), error);
  }
  const Planes& a = *candidate.planes;
  for (size_t index = 0; index < a.hits.size(); ++index) {
    judge_sample(allowed, a, index, verdict.candidate);
    if (reference == nullptr) continue;
    judge_sample(of_reference ? *of_reference : allowed, *reference->planes, index, verdict.reference);
  }
  if (reference == nullptr || of_reference) return verdict;
  const Planes& b = *reference->planes;
  for (size_t index = 0; index < a.hits.size(); ++index) {
    if (a.hits[index] == 0 || b.hits[index] == 0 || a.owner[index] != b.owner[index]) continue;
    ++verdict.compared;
    constexpr float kInvisible = 2.0F / 255;
    const auto color_a = color_at(a, index);
    const auto color_b = color_at(b, index);
    bool alike = true;
    for (size_t c = 0; c < 3; ++c) alike = alike && std::abs(color_a[c] - color_b[c]) <= kInvisible;
    if (!alike) ++verdict.apart;
  }
  return verdict;
}

}  // namespace fillrule::scene
