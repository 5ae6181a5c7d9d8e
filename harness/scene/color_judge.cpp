#include "harness/scene/color_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "harness/scene/color_bounds.h"
#include "reference/exact/expectation.h"

namespace fillrule::scene {
namespace {

constexpr auto kAllComponents = [] {
  std::array<uint32_t, programs::kSceneComponents> all{};
  std::iota(all.begin(), all.end(), 0U);
  return all;
}();
constexpr std::array<uint32_t, 2> kUvComponents{programs::kUvComponent, programs::kUvComponent + 1};

// Which colours parties of equal subpixel bits may have, sample by sample.
class AllowedColors {
 public:
  AllowedColors(const Case& built, const programs::CaseShading& shading, const exact::Expectation& expectation,
                const TransformError& error)
      : case_(built),
        shading_(shading),
        error_(error),
        expectation_(expectation),
        values_(expectation.pieces().size()) {
    for (const programs::DrawShading& draw : shading) read_components_.push_back(components_read(draw.uniforms));
  }

  struct Answer {
    bool judged = false;
    const ColorBounds* beyond = nullptr;  // the first bounds of a colour that is in none of them
  };
  // Of a colour that this owner has there; valid until the next one is asked for.
  Answer of(size_t sample, double x, double y, uint32_t owner, const std::array<float, 3>& color) {
    if (!asked_ || sample != sample_ || owner != owner_) {
      asked_ = true;
      sample_ = sample;
      owner_ = owner;
      for (Bounds& bounds : bounds_) bounds.known = false;
      find_exact(x, y);
    }
    // Nearly all colours are so close to the exact one that they are within any bounds, or else within the narrow
    // ones and hence within the others.
    if (exact_ && is_close(color, *exact_)) return {.judged = true};
    for (const ColorBounds& bounds : bounds_at(Tolerances::kLeast, x, y).bounds) {
      if (is_inside(color, bounds)) return {.judged = true};
    }
    const Bounds& all = bounds_at(Tolerances::kAll, x, y);
    for (const ColorBounds& bounds : all.bounds) {
      if (is_inside(color, bounds)) return {.judged = true};
    }
    if (all.is_open || all.bounds.empty()) return {};
    return {.judged = true, .beyond = &all.bounds.front()};
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

  static bool is_close(const std::array<float, 3>& color, const std::array<double, 3>& exact) {
    bool close = true;
    for (size_t c = 0; c < 3; ++c) close = close && std::abs(double{color[c]} - exact[c]) <= kLeastRounding;
    return close;
  }

  // Of the owner's first piece at the sample.
  void find_exact(double x, double y) {
    exact_.reset();
    expectation_.collect(sample_, entries_);
    const auto entry = std::ranges::find_if(
        entries_, [this](const exact::Entry& one) { return expectation_.pieces()[one.piece].owner == owner_; });
    if (entry == entries_.end()) return;
    const exact::Piece& piece = expectation_.pieces()[entry->piece];
    const programs::DrawShading& shading = shading_[piece.draw];
    if (!is_defined(piece)) return;
    if (find_range(Tolerances::kLeast, entry->piece, piece, x, y)) exact_ = exact_color(shading, range_);
  }

  // The values of other pieces are undefined ground.
  static bool is_defined(const exact::Piece& piece) { return !piece.shape->undefined() && !piece.thin; }

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
      if (!is_defined(piece) || !find_range(tolerances, entry.piece, piece, x, y)) {
        result.is_open = true;
        return;
      }
      result.bounds.push_back(color_bounds(shading_[piece.draw], range_, {}));
    }
  }

  const exact::PieceValues& values(uint32_t number, const exact::Piece& piece) {
    std::unique_ptr<exact::PieceValues>& values = values_[number];
    if (!values) values = exact::values_of(case_, piece);
    return *values;
  }

  using Components = std::array<exact::Expected, programs::kSceneComponents>;

  // Those that the shading depends on.
  static std::vector<uint32_t> components_read(const programs::ShadingUniforms& uniforms) {
    std::vector<uint32_t> components;
    const auto add = [&](uint32_t first, uint32_t count) {
      for (uint32_t c = first; c < first + count; ++c) components.push_back(c);
    };
    if (uniforms.lights >= 0 && has_highlights(uniforms)) add(programs::kPositionComponent, 3);
    if (uniforms.lights >= 0) add(programs::kNormalComponent, 3);
    if (uniforms.textured != 0) add(programs::kUvComponent, 2);
    return components;
  }

  // Those that are wanted; returns whether their tolerances are finite.
  static bool read_components(Tolerances tolerances, std::span<const uint32_t> wanted,
                              const exact::PieceValues& values, double x, double y, Components& components) {
    if (tolerances == Tolerances::kLeast) {
      values.least_varyings(x, y, wanted, components);
    } else {
      values.varyings(x, y, wanted, components);
    }
    bool finite = true;
    for (const uint32_t c : wanted) finite = finite && std::isfinite(components[c].tolerance);
    return finite;
  }

  // The range of the surface at (x, y) in range_, as far as the shading depends on it; false where nothing can be
  // said.
  bool find_range(Tolerances tolerances, uint32_t number, const exact::Piece& piece, double x, double y) {
    const exact::PieceValues& exact_values = values(number, piece);
    // With the real tolerances all components: nobody is accused where any of them is open.
    std::span<const uint32_t> wanted = kAllComponents;
    if (tolerances == Tolerances::kLeast) wanted = read_components_[piece.draw];
    if (!read_components(tolerances, wanted, exact_values, x, y, here_)) return false;
    for (uint32_t c = 0; c < 3; ++c) {
      const auto i = static_cast<glm::length_t>(c);
      const exact::Expected& position = here_[programs::kPositionComponent + c];
      const exact::Expected& normal = here_[programs::kNormalComponent + c];
      range_.position_world[i] = position.value;
      range_.position_error[i] = position.tolerance + error_.position_world;
      range_.normal_world[i] = normal.value;
      range_.normal_error[i] = normal.tolerance + error_.normal_world;
    }
    for (uint32_t c = 0; c < 2; ++c) {
      const auto i = static_cast<glm::length_t>(c);
      range_.uv[i] = here_[programs::kUvComponent + c].value;
      range_.uv_error[i] = here_[programs::kUvComponent + c].tolerance;
    }
    return shading_[piece.draw].uniforms.mipmapped == 0 ||
           (find_step(tolerances, exact_values, 0, x, y) && find_step(tolerances, exact_values, 1, x, y));
  }

  // The difference along one axis in the quad of pixels that begins at even coordinates.
  bool find_step(Tolerances tolerances, const exact::PieceValues& exact_values, uint32_t axis, double x, double y) {
    const bool is_first = std::fmod(std::floor(axis == 0 ? x : y), 2) == 0;
    const double to_other = is_first ? 1 : -1;
    const double there_x = axis == 0 ? x + to_other : x;
    const double there_y = axis == 0 ? y : y + to_other;
    if (!read_components(tolerances, kUvComponents, exact_values, there_x, there_y, there_)) return false;
    for (uint32_t c = 0; c < 2; ++c) {
      const auto i = static_cast<glm::length_t>(c);
      const exact::Expected& uv = there_[programs::kUvComponent + c];
      range_.uv_step[axis][i] = (uv.value - range_.uv[i]) * to_other;
      range_.uv_step_error[axis][i] = uv.tolerance + range_.uv_error[i];
    }
    return true;
  }

  const Case& case_;
  const programs::CaseShading& shading_;
  TransformError error_;
  const exact::Expectation& expectation_;
  std::vector<exact::Entry> entries_;
  Components here_;   // at the sample
  Components there_;  // at its neighbour of the quad
  SurfaceRange range_;
  std::vector<std::unique_ptr<exact::PieceValues>> values_;  // of each piece that was asked for
  std::vector<std::vector<uint32_t>> read_components_;       // of each draw
  // What was asked for last.
  bool asked_ = false;
  size_t sample_ = 0;
  uint32_t owner_ = 0;
  std::optional<std::array<double, 3>> exact_;
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
  if (answer.beyond == nullptr) return;
  if (result.outside++ == 0) result.first = in_words(planes, index, color, *answer.beyond);
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
