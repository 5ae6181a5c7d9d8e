#include "harness/faults/fragment.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace fillrule::faults {
namespace {

bool has_nan_varying(const Context& context, const Primitive& primitive) {
  const uint32_t components = vertex_component_count(context.drawn.varyings);
  const auto is_nan = [&](uint32_t vertex) {
    const auto begin = context.draw.varyings.begin() + static_cast<std::ptrdiff_t>(size_t{vertex} * components);
    return std::any_of(begin, begin + components, [](float value) { return std::isnan(value); });
  };
  return std::any_of(primitive.vertices.begin(), primitive.vertices.begin() + primitive.size, is_nan);
}

}  // namespace

FragmentStage::FragmentStage(const Context& context, uint32_t first_primitive, Planes& planes)
    : context_(context),
      first_primitive_(first_primitive),
      planes_(planes),
      locations_(sample_locations(context)),
      shades_samples_(std::ranges::any_of(context.drawn.varyings,
                                          [](const Varying& one) { return one.sampling == Sampling::kSample; })) {}

void FragmentStage::fragment(const Surface& surface, int32_t x, int32_t y, uint32_t covered) {
  if (!context_.has(Fault::kSampleMaskIgnored)) covered &= context_.state().sample_mask;
  if (context_.has(Fault::kNanVaryingDiscards) && has_nan_varying(context_, surface.primitive)) return;
  for (size_t sample = 0; sample < locations_.size(); ++sample) {
    if ((covered >> sample & 1U) == 0) continue;
    const size_t index = index_of(x, y, sample);
    if (index >= planes_.hits.size()) continue;  // a fault must not lead out of the planes
    const double sample_x = x + locations_[sample].x / 16.0;
    const double sample_y = y + locations_[sample].y / 16.0;
    const double depth = surface.values.at(sample_x, sample_y).depth + surface.depth_bias;
    const bool has_depth = !planes_.depth.empty();
    if (!has_depth || passes_depth(context_, depth, planes_.depth[index])) write(surface, x, y, covered, sample);
  }
}

size_t FragmentStage::index_of(int32_t x, int32_t y, size_t sample) const {
  return (static_cast<size_t>(y) * planes_.width + static_cast<size_t>(x)) * planes_.samples + sample;
}

// Where in the pixel the varying is evaluated.
FragmentStage::Place FragmentStage::place_of(const Varying& varying, int32_t x, int32_t y, uint32_t covered,
                                             size_t sample) const {
  const Place centre{.x = x + 0.5, .y = y + 0.5};
  const auto at_sample = [&](size_t i) {
    return Place{.x = x + locations_[i].x / 16.0, .y = y + locations_[i].y / 16.0};
  };
  if (locations_.size() == 1) return centre;
  if (varying.sampling == Sampling::kSample && !context_.has(Fault::kSampleAtCentre)) return at_sample(sample);
  if (varying.sampling == Sampling::kCentroid && !context_.has(Fault::kCentroidAtCentre)) {
    const bool whole = static_cast<size_t>(std::popcount(covered)) == locations_.size();
    return whole ? centre : at_sample(static_cast<size_t>(std::countr_zero(covered)));
  }
  return centre;
}

float FragmentStage::value(const Surface& surface, const Varying& varying, uint32_t component, uint32_t of_vertex,
                           const Place& place) const {
  if (varying.source == VaryingSource::kPointCoord) {
    const double along = component == 0 ? place.x - surface.point_x : place.y - surface.point_y;
    const bool flipped = component == 1 && context_.has(Fault::kPointCoordFlipped);
    return static_cast<float>(0.5 + (flipped ? -along : along) / surface.point_size);
  }
  const Interpolated at = surface.values.at(place.x, place.y);
  if (varying.source == VaryingSource::kFragCoord) {
    const bool at_corner = context_.has(Fault::kFragCoordAtCorner);
    const std::array<double, 4> frag_coord{at_corner ? std::floor(place.x) : place.x,
                                           at_corner ? std::floor(place.y) : place.y, at.depth + surface.depth_bias,
                                           context_.has(Fault::kFragCoordW) ? 1 / at.reciprocal_w : at.reciprocal_w};
    return static_cast<float>(frag_coord[component]);
  }
  const Primitive& primitive = surface.primitive;
  const uint32_t components = vertex_component_count(context_.drawn.varyings);
  const auto of = [&](uint32_t vertex) { return context_.draw.varyings[size_t{vertex} * components + of_vertex]; };
  if (varying.interpolation == Interpolation::kFlat && !context_.has(Fault::kFlatInterpolated)) {
    return of(primitive.provoking);
  }
  double sum = 0;
  for (size_t i = 0; i < primitive.size; ++i) {
    const auto& weights = varying.interpolation == Interpolation::kNoperspective ? at.noperspective : at.smooth;
    sum += weights[i] * double{of(primitive.vertices[i])};
  }
  return static_cast<float>(sum);
}

void FragmentStage::write(const Surface& surface, int32_t x, int32_t y, uint32_t covered, size_t sample) {
  const size_t index = index_of(x, y, sample);
  ++planes_.hits[index];
  planes_.owner[index] = first_primitive_ + surface.primitive.number;
  planes_.front_facing[index] = surface.front_facing ? 1 : 0;
  uint32_t plane = 0;
  uint32_t of_vertex = 0;
  for (const Varying& varying : context_.drawn.varyings) {
    Place place = place_of(varying, x, y, covered, sample);
    if (varying.source == VaryingSource::kVertices) {
      if (context_.has(Fault::kValuesAtPixelCorner)) place = {.x = place.x - 0.5, .y = place.y - 0.5};
      if (context_.has(Fault::kValuesOneStepLate)) place.x += 1;
    }
    for (uint32_t i = 0; i < varying.components; ++i, ++plane) {
      planes_.varyings[plane][index] = value(surface, varying, i, of_vertex, place);
      if (varying.source == VaryingSource::kVertices) ++of_vertex;
    }
  }
}

}  // namespace fillrule::faults
