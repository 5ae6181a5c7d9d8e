#include "harness/bench/party.h"

#include <algorithm>
#include <memory>
#include <type_traits>

#include "reference/vulkan/color_draw.h"
#include "renderer/pipeline.h"

namespace fillrule::bench {
namespace {

// kCount: vec4 of a vertex.
template <uint32_t kCount, bool kFlat>
class MeanColor {
 public:
  explicit MeanColor(const Scene& scene)
      : positions_clip_(scene.positions_clip.data()), attributes_(scene.attributes.data()) {}

  [[nodiscard]] ClipPosition position(uint32_t vertex) const { return positions_clip_[vertex]; }

  [[gnu::always_inline]] void prefetch(uint32_t vertex) const {
    __builtin_prefetch(attributes_ + size_t{vertex} * kCount);
  }

  // Of one primitive, or of several lane by lane.
  template <typename Primitives>
  [[nodiscard, gnu::always_inline]] auto primitive_data(const Primitives& primitives) const {
    const auto varying = [&](size_t i) __attribute__((always_inline)) {
      const auto of = [&](uint32_t vertex) __attribute__((always_inline))->const Attribute& {
        return attributes_[size_t{vertex} * kCount + i];
      };
      if constexpr (kFlat) {
        return primitives.flat(of);
      } else {
        return primitives.smooth(of);
      }
    };
    std::array<decltype(varying(0)), kCount> data;
    for (size_t i = 0; i < kCount; ++i) {
      data[i] = varying(i);
    }
    return data;
  }

  template <typename L, typename Data>
  [[nodiscard, gnu::always_inline]] renderer::Color<L> color(const Data& data,
                                                             const renderer::FragmentLanes<L>& fragments) const {
    renderer::Color<L> sum = value(data[0], fragments);
    for (size_t i = 1; i < kCount; ++i) {
      const renderer::Color<L> next = value(data[i], fragments);
      for (size_t channel = 0; channel < 4; ++channel) {
        sum[channel] = sum[channel] + next[channel];
      }
    }
    if constexpr (kCount > 1) {
      for (size_t channel = 0; channel < 4; ++channel) {
        sum[channel] = sum[channel] * L::all(1.0F / kCount);
      }
    }
    return sum;
  }

 private:
  template <typename Values, typename L>
  [[nodiscard, gnu::always_inline]] static renderer::Color<L> value(const Values& values,
                                                                    const renderer::FragmentLanes<L>& fragments) {
    if constexpr (kFlat) {
      return fragments.flat(values);
    } else {
      return fragments.smooth(values);
    }
  }

  const ClipPosition* positions_clip_;
  const Attribute* attributes_;
};

// The renderer's attachments.
struct Attachments {
  std::vector<uint32_t> color;
  std::vector<float> depth;
};

renderer::DrawInput input_of(const Scene& scene, Attachments& attachments) {
  const auto size = static_cast<float>(scene.target_size);
  return {.target_width = scene.target_size,
          .target_height = scene.target_size,
          .samples = scene.samples,
          .vertices = {.topology = scene.topology,
                       .vertex_count = static_cast<uint32_t>(scene.positions_clip.size()),
                       .indices = scene.indices},
          .state = {.viewport = {.width = size, .height = size, .maxDepth = 1},
                    .scissor = {.extent = {scene.target_size, scene.target_size}},
                    .cull_mode = scene.cull_mode,
                    .depth_test = true},
          .depth = {.values = attachments.depth, .clear = 1.0F},
          .color = {.values = attachments.color, .clear = 0}};
}

Result<void> draw_scene(const Scene& scene, Attachments& attachments, const renderer::Options& options) {
  const renderer::DrawInput input = input_of(scene, attachments);
  if (scene.is_flat) {
    return renderer::draw(input, MeanColor<1, true>(scene), options);
  }
  if (scene.attribute_count == vulkan::kMaxColorAttributes) {
    return renderer::draw(input, MeanColor<vulkan::kMaxColorAttributes, false>(scene), options);
  }
  return renderer::draw(input, MeanColor<1, false>(scene), options);
}

std::vector<uint32_t> resolved(const std::vector<uint32_t>& color, uint32_t samples) {
  std::vector<uint32_t> pixels(color.size() / samples);
  for (size_t pixel = 0; pixel < pixels.size(); ++pixel) {
    for (uint32_t shift = 0; shift < 32; shift += 8) {
      uint32_t sum = 0;
      for (uint32_t i = 0; i < samples; ++i) sum += color[pixel * samples + i] >> shift & 0xFFU;
      pixels[pixel] |= (sum + samples / 2) / samples << shift;
    }
  }
  return pixels;
}

}  // namespace

Party make_renderer(const Scene& scene, uint32_t threads, renderer::Isa isa) {
  const size_t values = size_t{scene.target_size} * scene.target_size * scene.samples;
  const auto attachments = std::make_shared<Attachments>();
  attachments->color.resize(values);
  attachments->depth.resize(values);
  const auto draw = [&scene, attachments, threads, isa] {
    return draw_scene(scene, *attachments, {.threads = threads, .isa = isa});
  };
  return {.name = "renderer", .draw = draw, .picture = [&scene, attachments] {
            return Result<std::vector<uint32_t>>(resolved(attachments->color, scene.samples));
          }};
}

Result<Party> make_driver(const Scene& scene, const DriverOptions& driver, uint32_t threads) {
  Result<vulkan::ColorDrawer> created =
      vulkan::ColorDrawer::create({.driver = driver.name, .driver_files = driver.files, .threads = threads},
                                  {.target_size = scene.target_size,
                                   .samples = scene.samples,
                                   .topology = scene.topology,
                                   .cull_mode = scene.cull_mode,
                                   .positions_clip = scene.positions_clip,
                                   .attribute_count = scene.attribute_count,
                                   .attributes = scene.attributes,
                                   .is_flat = scene.is_flat,
                                   .indices = scene.indices});
  if (!created) return tl::unexpected(created.error());
  const auto drawer = std::make_shared<vulkan::ColorDrawer>(std::move(*created));
  return Party{.name = driver.name,
               .version = drawer->device().name + ", " + drawer->device().driver_version,
               .draw = [drawer] { return drawer->draw(); },
               .picture = [drawer] { return drawer->picture(); }};
}

}  // namespace fillrule::bench
