#include "reference/exact/expectation.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "reference/exact/assembly.h"
#include "reference/exact/clip_edges.h"
#include "reference/exact/outline.h"
#include "reference/exact/triangle_rows.h"
#include "reference/exact/value_bound.h"

namespace fillrule::exact {
namespace {

// Samples are classified in blocks of this many pixels squared, and these in quarters down to blocks so small, so
// that only those near a boundary are asked one by one, and about the boundaries that are near alone.
constexpr int32_t kBlockSize = 64;
constexpr uint32_t kLeastBlockSize = 2;  // of one sample a pixel; of several, 1
// Triangles of more pixels than this, in either direction, are classified in rows instead (triangle_rows.h): for
// smaller ones blocks are done sooner than rows are set up.
constexpr uint32_t kMostPixelsForBlocks = 4;

bool culled(const RasterState& state, bool front_facing) {
  return (state.cull_mode & (front_facing ? VK_CULL_MODE_FRONT_BIT : VK_CULL_MODE_BACK_BIT)) != 0;
}

// Vulkan's area is negative for a triangle whose determinant is positive, y pointing down. Without area: back-facing.
bool is_front_facing(const RasterState& state, int orientation) {
  return orientation == (state.front_face == VK_FRONT_FACE_CLOCKWISE ? 1 : -1);
}

int32_t to_pixel(double position, int32_t low, int32_t high) {
  if (!(position > low)) return low;
  return position < high ? static_cast<int32_t>(position) : high;
}

// The pixels that a piece can touch: its bounds, the scissor and the target.
VkRect2D pixels_of(const Piece& piece, const RasterState& state, const Target& target) {
  const auto bounds = piece.shape->bounds(piece.latitude);
  const int64_t scissor_right = int64_t{state.scissor.offset.x} + int64_t{state.scissor.extent.width};
  const int64_t scissor_bottom = int64_t{state.scissor.offset.y} + int64_t{state.scissor.extent.height};
  const auto left = static_cast<int32_t>(std::max<int64_t>(state.scissor.offset.x, 0));
  const auto top = static_cast<int32_t>(std::max<int64_t>(state.scissor.offset.y, 0));
  const auto right = static_cast<int32_t>(std::min<int64_t>(scissor_right, target.width));
  const auto bottom = static_cast<int32_t>(std::min<int64_t>(scissor_bottom, target.height));
  const int32_t x0 = to_pixel(std::floor(bounds[0]), left, right);
  const int32_t y0 = to_pixel(std::floor(bounds[1]), top, bottom);
  const int32_t x1 = to_pixel(std::ceil(bounds[2]), left, right);
  const int32_t y1 = to_pixel(std::ceil(bounds[3]), top, bottom);
  return {.offset = {.x = x0, .y = y0},
          .extent = {.width = static_cast<uint32_t>(std::max(x1 - x0, 0)),
                     .height = static_cast<uint32_t>(std::max(y1 - y0, 0))}};
}

// What holds all samples of these pixels: their centres, or with several samples all of the pixels.
// Of which some may have no pixels: those are left out.
template <typename Visit>
void for_each_quarter(const VkRect2D& block, const Visit& visit) {
  const uint32_t width = (block.extent.width + 1) / 2;
  const uint32_t height = (block.extent.height + 1) / 2;
  for (uint32_t y = 0; y < block.extent.height; y += height) {
    for (uint32_t x = 0; x < block.extent.width; x += width) {
      visit({.offset = {block.offset.x + static_cast<int32_t>(x), block.offset.y + static_cast<int32_t>(y)},
             .extent = {std::min(width, block.extent.width - x), std::min(height, block.extent.height - y)}});
    }
  }
}

Block block_of(const VkRect2D& pixels, bool centres) {
  const double margin = centres ? 0.5 : 0;
  return {.x = pixels.offset.x + pixels.extent.width / 2.0,
          .y = pixels.offset.y + pixels.extent.height / 2.0,
          .half_width = pixels.extent.width / 2.0 - margin,
          .half_height = pixels.extent.height / 2.0 - margin};
}

}  // namespace

Expectation::Expectation(const Case& test_case, uint32_t subpixel_bits) {
  add_all(test_case, subpixel_bits);
}

Expectation::Expectation(const Case& test_case, uint32_t subpixel_bits, std::span<const size_t> samples) {
  for (const size_t sample : samples) {
    const SamplePlace place = sample_place(test_case.target, sample);
    const VkOffset2D pixel{.x = static_cast<int32_t>(place.x), .y = static_cast<int32_t>(place.y)};
    const bool is_known =
        !some_pixels_.empty() && some_pixels_.back().x == pixel.x && some_pixels_.back().y == pixel.y;
    if (!is_known) some_pixels_.push_back(pixel);
  }
  if (!samples.empty()) add_all(test_case, subpixel_bits);
}

void Expectation::add_all(const Case& test_case, uint32_t subpixel_bits) {
  const size_t samples = sample_locations(test_case.target.samples).size();
  classes_.assign(size_t{test_case.target.width} * test_case.target.height * samples, kNothing);
  made_of_.assign(1, {});
  uint32_t first_primitive = 0;
  for (uint32_t draw = 0; draw < test_case.draws.size(); ++draw) {
    add_draw(test_case, draw, first_primitive, subpixel_bits);
    first_primitive += primitive_count(test_case.draws[draw]);
  }
}

void Expectation::add_draw(const Case& test_case, uint32_t draw_number, uint32_t first_primitive,
                           uint32_t subpixel_bits) {
  const Draw& draw = test_case.draws[draw_number];
  const Latitude latitude = latitude_of(draw.state.viewport, subpixel_bits);
  const double snap = std::ldexp(1.0, -static_cast<int>(subpixel_bits));
  uint32_t owner = first_primitive;
  if (draw.topology < VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST) {
    for (Piece& piece : line_and_point_pieces(draw, draw_number, first_primitive, latitude)) {
      add_piece(test_case, std::move(piece));
    }
    return;
  }
  for (const AssembledTriangle& assembled : assemble(draw)) {
    const uint32_t number = owner++;
    const CullDistances distances = cull_distances_of(draw, assembled.vertices);
    if (distances == CullDistances::kDrop) continue;
    auto triangle = std::make_unique<Triangle>(triangle_of(draw, assembled.vertices));
    Piece piece;
    piece.owner = number;
    piece.open = distances == CullDistances::kEither;
    piece.draw = draw_number;
    piece.vertices = assembled.vertices;
    piece.provoking = assembled.vertices[assembled.provoking];
    piece.latitude = latitude;
    piece.front_facing = is_front_facing(draw.state, triangle->orientation());
    piece.culled = culled(draw.state, piece.front_facing);
    piece.facing_in_doubt = triangle->orientation_in_doubt(latitude);
    piece.thin = triangle->thinner_than(snap);
    piece.shape = std::move(triangle);
    if (draw.state.polygon_mode == VK_POLYGON_MODE_FILL) {
      add_piece(test_case, std::move(piece));
      continue;
    }
    for (Piece& part : outline_of(draw, piece)) add_piece(test_case, std::move(part));
  }
}

void Expectation::add_piece(const Case& test_case, Piece added) {
  const auto number = static_cast<uint32_t>(pieces_.size());
  pieces_.push_back(std::move(added));
  const Piece& piece = pieces_.back();
  const RasterState& state = test_case.draws[piece.draw].state;
  const bool is_culled = piece.culled;
  // Culled whichever way it faces, or certainly facing the culled way.
  if (is_culled && (!piece.facing_in_doubt || culled(state, !piece.front_facing))) return;
  const VkRect2D pixels = pixels_of(piece, state, test_case.target);
  // A sample further inside than the latitude proves that rounding cannot turn a triangle over.
  const bool is_triangle = piece.triangle() != nullptr;
  bool certain = false;
  if (!is_culled) {
    classify_pixels(test_case, piece, pixels, [&](const Classified& classified) {
      certain = certain || (is_triangle && classified.classification.coverage == Coverage::kMust);
      append(classified, number);
    });
  } else {
    std::vector<Classified> open;
    classify_pixels(test_case, piece, pixels, [&](const Classified& classified) {
      certain = certain || (is_triangle && classified.classification.coverage == Coverage::kMust);
      open.push_back(classified);
    });
    if (!certain) {
      for (const Classified& classified : open) append(classified, number);
    }
  }
  if (certain) pieces_[number].facing_in_doubt = false;
}

template <typename Visit>
void Expectation::classify_pixels(const Case& test_case, const Piece& piece, const VkRect2D& pixels,
                                  const Visit& visit) const {
  const auto right = pixels.offset.x + static_cast<int32_t>(pixels.extent.width);
  const auto bottom = pixels.offset.y + static_cast<int32_t>(pixels.extent.height);
  // Whether a triangle may be turned over, any of its samples may tell.
  if (!some_pixels_.empty() && !piece.facing_in_doubt) {
    for (const VkOffset2D& pixel : some_pixels_) {
      if (pixel.x < pixels.offset.x || pixel.x >= right || pixel.y < pixels.offset.y || pixel.y >= bottom) continue;
      classify_block(test_case, piece, {.offset = pixel, .extent = {1, 1}}, kEveryBoundary, visit);
    }
    return;
  }
  if (piece.triangle() != nullptr && std::max(pixels.extent.width, pixels.extent.height) > kMostPixelsForBlocks) {
    const bool centres = test_case.target.samples == VK_SAMPLE_COUNT_1_BIT;
    const BlockClassification whole =
        piece.shape->classify_block(block_of(pixels, centres), piece.latitude, kEveryBoundary);
    if (whole.coverage == Coverage::kMustNot) return;
    const DoubtBits undecided = whole.coverage == Coverage::kMust ? 0 : whole.undecided;
    if ((undecided & ~TriangleRows::kBoundaries) == 0) {
      classify_rows(test_case, piece, pixels, undecided, visit);
      return;
    }
  }
  for (int32_t y = pixels.offset.y; y < bottom; y += kBlockSize) {
    for (int32_t x = pixels.offset.x; x < right; x += kBlockSize) {
      const VkRect2D block{.offset = {.x = x, .y = y},
                           .extent = {.width = static_cast<uint32_t>(std::min(kBlockSize, right - x)),
                                      .height = static_cast<uint32_t>(std::min(kBlockSize, bottom - y))}};
      classify_block(test_case, piece, block, kEveryBoundary, visit);
    }
  }
}

// Of a triangle all samples of these pixels: row by row those of pixels that are covered as a whole, and those beside
// them that may be.
template <typename Visit>
void Expectation::classify_rows(const Case& test_case, const Piece& piece, const VkRect2D& pixels,
                                DoubtBits undecided, const Visit& visit) const {
  const std::span<const Position> locations = sample_locations(test_case.target.samples);
  const TriangleRows rows(*piece.triangle(), piece.latitude, block_of(pixels, locations.size() == 1), undecided);
  const uint32_t width = pixels.extent.width;
  for (uint32_t row = 0; row < pixels.extent.height; ++row) {
    const int32_t y = pixels.offset.y + static_cast<int32_t>(row);
    RowCoverage whole{.may_begin = width, .must_end = width};
    for (const Position& location : locations) {
      const RowCoverage of_samples = rows.at(pixels.offset.x + location.x, y + location.y, width);
      if (of_samples.may_begin < of_samples.may_end) {
        whole.may_begin = std::min(whole.may_begin, of_samples.may_begin);
        whole.may_end = std::max(whole.may_end, of_samples.may_end);
      }
      whole.must_begin = std::max(whole.must_begin, of_samples.must_begin);
      whole.must_end = std::min(whole.must_end, of_samples.must_end);
    }
    const auto classify = [&](uint32_t begin, uint32_t end, DoubtBits to_ask) {
      if (begin >= end) return;
      const VkRect2D block{.offset = {.x = pixels.offset.x + static_cast<int32_t>(begin), .y = y},
                           .extent = {.width = end - begin, .height = 1}};
      classify_samples(test_case, piece, block, to_ask, visit);
    };
    if (whole.must_begin >= whole.must_end) {
      classify(whole.may_begin, whole.may_end, undecided);
      continue;
    }
    classify(whole.may_begin, whole.must_begin, undecided);
    classify(whole.must_begin, whole.must_end, 0);
    classify(whole.must_end, whole.may_end, undecided);
  }
}

template <typename Visit>
void Expectation::classify_block(const Case& test_case, const Piece& piece, const VkRect2D& block,
                                 DoubtBits undecided, const Visit& visit) const {
  const size_t samples = sample_locations(test_case.target.samples).size();
  const BlockClassification whole =
      piece.shape->classify_block(block_of(block, samples == 1), piece.latitude, undecided);
  if (whole.coverage == Coverage::kMustNot) return;
  if (whole.coverage == Coverage::kMust) {
    classify_samples(test_case, piece, block, 0, visit);
    return;
  }
  const uint32_t least_size = samples == 1 ? kLeastBlockSize : 1;
  if (std::max(block.extent.width, block.extent.height) > least_size) {
    for_each_quarter(
        block, [&](const VkRect2D& quarter) { classify_block(test_case, piece, quarter, whole.undecided, visit); });
    return;
  }
  classify_samples(test_case, piece, block, whole.undecided, visit);
}

// Each sample of the block, of which the boundaries `undecided` have to be asked: none where all are covered.
template <typename Visit>
void Expectation::classify_samples(const Case& test_case, const Piece& piece, const VkRect2D& block,
                                   DoubtBits undecided, const Visit& visit) const {
  const uint32_t width = test_case.target.width;
  const std::span<const Position> locations = sample_locations(test_case.target.samples);
  const uint32_t sample_mask = test_case.draws[piece.draw].state.sample_mask;
  const uint32_t all_samples = (1U << locations.size()) - 1;
  const auto opened = [&piece](const Classification& classification) {
    return piece.open ? Classification{.coverage = Coverage::kMay, .doubt = kDoubtShape} : classification;
  };
  for (uint32_t row = 0; row < block.extent.height; ++row) {
    const uint32_t y = static_cast<uint32_t>(block.offset.y) + row;
    const size_t first = (size_t{y} * width + static_cast<uint32_t>(block.offset.x)) * locations.size();
    if (undecided == 0 && (sample_mask & all_samples) == all_samples) {
      visit({.begin = first,
             .end = first + size_t{block.extent.width} * locations.size(),
             .classification = opened({.coverage = Coverage::kMust})});
      continue;
    }
    for (uint32_t column = 0; column < block.extent.width; ++column) {
      const uint32_t x = static_cast<uint32_t>(block.offset.x) + column;
      for (size_t sample = 0; sample < locations.size(); ++sample) {
        if ((sample_mask >> sample & 1U) == 0) continue;
        Classification classification{.coverage = Coverage::kMust};
        if (undecided != 0) {
          const Position& location = locations[sample];
          classification = piece.shape->classify(x + location.x, y + location.y, piece.latitude, undecided);
          if (classification.coverage == Coverage::kMustNot) continue;
        }
        const size_t index = first + column * locations.size() + sample;
        visit({.begin = index, .end = index + 1, .classification = opened(classification)});
      }
    }
  }
}

void Expectation::append(const Classified& classified, uint32_t number) {
  const auto& [coverage, doubt] = classified.classification;
  const Entry entry{.piece = number, .coverage = coverage, .doubt = doubt};
  for (size_t begin = classified.begin, end = begin; begin < classified.end; begin = end) {
    const uint32_t before = classes_[begin];
    while (end < classified.end && classes_[end] == before) ++end;
    std::fill(classes_.begin() + static_cast<ptrdiff_t>(begin), classes_.begin() + static_cast<ptrdiff_t>(end),
              class_after(before, entry));
  }
}

// Other samples may have come from the same class to the same one. Those nearby have been there just before.
uint32_t Expectation::class_after(uint32_t before, const Entry& entry) {
  constexpr size_t kFew = 8;
  const auto size = static_cast<uint32_t>(made_of_.size());
  for (uint32_t i = size; i-- > 1 && size - i <= kFew && made_of_[i].last.piece == entry.piece;) {
    if (made_of_[i].before == before && made_of_[i].last == entry) return i;
  }
  made_of_.push_back({.before = before, .last = entry});
  return size;
}

std::optional<uint32_t> Expectation::sole(uint32_t number) const {
  const Class& made_of = made_of_[number];
  const bool is_sole = number != kNothing && made_of.before == kNothing && made_of.last.coverage == Coverage::kMust;
  return is_sole ? std::optional(made_of.last.piece) : std::nullopt;
}

void Expectation::collect(size_t sample, std::vector<Entry>& entries) const {
  entries.clear();
  for (uint32_t number = classes_[sample]; number != kNothing; number = made_of_[number].before) {
    entries.push_back(made_of_[number].last);
  }
  std::ranges::reverse(entries);
}

Triangle triangle_of(const Draw& draw, const std::array<uint32_t, 3>& vertices) {
  ClipVolume volume{.depth_clip = draw.state.depth_clip, .negative_one_to_one = draw.state.negative_one_to_one};
  for (uint32_t plane = 0; plane < draw.clip_distance_count; ++plane) {
    std::array<float, 3>& distances = volume.distances.emplace_back();
    for (size_t i = 0; i < 3; ++i) {
      distances[i] = draw.clip_distances[size_t{vertices[i]} * draw.clip_distance_count + plane];
    }
  }
  return {{draw.positions[vertices[0]], draw.positions[vertices[1]], draw.positions[vertices[2]]},
          draw.state.viewport,
          std::move(volume)};
}

std::unique_ptr<PieceValues> values_of(const Case& test_case, const Piece& piece) {
  const Draw& draw = test_case.draws[piece.draw];
  const uint32_t stride = vertex_component_count(test_case.varyings);
  const auto value = [&](uint32_t vertex, uint32_t component) {
    return draw.varyings[size_t{vertex} * stride + component];
  };
  const bool is_outline = piece.kind != Piece::Kind::kTriangle && piece.kind != Piece::Kind::kClipEdges;
  if (is_outline) return outline_values(test_case, piece);
  const Triangle& triangle = piece.kind == Piece::Kind::kTriangle
                                 ? *piece.triangle()
                                 : static_cast<const ClipEdges&>(*piece.shape).polygon();
  auto values = std::make_unique<TriangleValues>(triangle, piece.latitude);
  if (draw.state.depth_bias) values->set_depth_bias(*draw.state.depth_bias, test_case.target.depth_format);
  values->reserve(stride);
  uint32_t component = 0;
  for (const Varying& varying : test_case.varyings) {
    if (varying.source != VaryingSource::kVertices) continue;
    for (uint32_t c = 0; c < varying.components; ++c, ++component) {
      const std::array<float, 3> q{value(piece.vertices[0], component), value(piece.vertices[1], component),
                                   value(piece.vertices[2], component)};
      values->add_component(values->component(varying.interpolation, q, value(piece.provoking, component)));
    }
  }
  return values;
}

}  // namespace fillrule::exact
