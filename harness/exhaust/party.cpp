#include "harness/exhaust/party.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>

#include "reference/vulkan/hit_draw.h"
#include "renderer/pipeline.h"

namespace fillrule::exhaust {
namespace {

// The program for the renderer: adds hits up, like the reference's blending.
class HitProgram {
 public:
  HitProgram(const HitDraw& draw, std::span<uint8_t> hits)
      : positions_clip_(draw.positions_clip.data()), size_(draw.target_size), hits_(hits.data()) {}

  struct PrimitiveData {
    uint8_t hit = 0;
  };

  [[nodiscard]] ClipPosition position(uint32_t vertex) const {
    const auto& [x, y] = positions_clip_[vertex];
    return {x, y, 0.5F, 1.0F};
  }
  [[nodiscard]] static PrimitiveData primitive_data(const renderer::ShadedPrimitive& primitive) {
    return {.hit = primitive.front_facing ? vulkan::kFrontHit : vulkan::kHit};
  }
  void fragment(const PrimitiveData& data, const renderer::Fragment& fragment) const {
    uint8_t& hits = hits_[static_cast<size_t>(fragment.y) * size_ + static_cast<size_t>(fragment.x)];
    hits = static_cast<uint8_t>(hits + data.hit);
  }

 private:
  const PlanePosition* positions_clip_;
  size_t size_;
  uint8_t* hits_;
};

Result<void> draw_with_renderer(const HitDraw& draw, uint32_t subpixel_bits, std::span<uint8_t> hits) {
  std::fill(hits.begin(), hits.end(), uint8_t{0});
  const auto size = static_cast<float>(draw.target_size);
  const renderer::DrawInput input{
      .target_width = draw.target_size,
      .target_height = draw.target_size,
      .vertices = {.vertex_count = static_cast<uint32_t>(draw.positions_clip.size())},
      .state = {.viewport = {.width = size, .height = size, .maxDepth = 1.0F},
                .scissor = {.extent = {draw.target_size, draw.target_size}},
                .cull_mode = draw.cull_mode,
                .front_face = VK_FRONT_FACE_COUNTER_CLOCKWISE},
  };
  return renderer::draw(input, HitProgram(draw, hits), {.subpixel_bits = subpixel_bits, .threads = 1});
}

}  // namespace

Party make_renderer(uint32_t subpixel_bits) {
  return {.name = kRenderer, .subpixel_bits = subpixel_bits, .draw = [subpixel_bits](const HitDraw& draw, auto hits) {
            return draw_with_renderer(draw, subpixel_bits, hits);
          }};
}

Result<Party> make_device(const std::string& driver, const std::vector<std::string>& driver_files,
                          const CellLayout& layout) {
  Result<vulkan::HitDrawer> created = vulkan::HitDrawer::create({.driver = driver,
                                                                 .driver_files = driver_files,
                                                                 .target_size = layout.target_size(),
                                                                 .max_vertices = layout.capacity() * 3});
  if (!created) return tl::unexpected(created.error());
  const auto drawer = std::make_shared<vulkan::HitDrawer>(std::move(*created));
  const auto one_at_a_time = std::make_shared<std::mutex>();
  return Party{.name = driver,
               .version = drawer->device().name + ", " + drawer->device().driver_version,
               .subpixel_bits = drawer->device().subpixel_bits,
               .draw = [drawer, one_at_a_time](const HitDraw& draw, std::span<uint8_t> hits) {
                 const std::scoped_lock lock(*one_at_a_time);
                 return drawer->draw(draw.positions_clip, draw.cull_mode, hits);
               }};
}

}  // namespace fillrule::exhaust
