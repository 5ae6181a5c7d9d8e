#include "harness/scene/painters.h"

#include <memory>
#include <mutex>
#include <span>
#include <utility>

#include "harness/programs/glsl.h"
#include "harness/programs/shaded.h"
#include "reference/vulkan/reference.h"

namespace fillrule::scene {
namespace {

// A device is for one thread at a time.
struct Device {
  std::mutex mutex;
  vulkan::Reference reference;

  explicit Device(vulkan::Reference the_reference) : reference(std::move(the_reference)) {}

  Result<Planes> draw(const Case& built, const programs::CaseShading& shading) {
    std::vector<vulkan::DrawResources> resources;
    for (const programs::DrawShading& one : shading) {
      resources.push_back({.uniforms = std::as_bytes(std::span(&one.uniforms, 1)),
                           .texture = one.texture,
                           .variant = programs::shaded_variant(one.uniforms)});
    }
    const std::lock_guard lock(mutex);
    Result<Planes> planes = reference.draw(built, resources);
    const std::vector<std::string> messages = reference.validation_messages();
    if (planes && !messages.empty()) return failure("the validation layers say: " + messages.front());
    return planes;
  }
};

}  // namespace

Painter renderer_painter(const renderer::Options& options) {
  return [options](const Case& built, const programs::CaseShading& shading) {
    return programs::draw_shaded(built, shading, options);
  };
}

Result<Painter> driver_painter(const DriverOptions& options) {
  Result<vulkan::Reference> reference =
      vulkan::Reference::create({.driver = options.driver,
                                 .driver_files = options.driver_files,
                                 .program = {.vertex_glsl = programs::shaded_vertex_glsl(),
                                             .fragment_glsl = programs::shaded_fragment_glsl(),
                                             .draws_color = true,
                                             .uniform_bytes = sizeof(programs::ShadingUniforms)},
                                 .validation = options.validation});
  if (!reference) return tl::unexpected(reference.error());
  const auto device = std::make_shared<Device>(std::move(*reference));
  return [device](const Case& built, const programs::CaseShading& shading) { return device->draw(built, shading); };
}

Painter driver_painter_on_demand(const DriverOptions& options) {
  struct OnDemand {
    DriverOptions options;
    std::once_flag once;
    Result<Painter> painter;
  };
  const auto shared = std::make_shared<OnDemand>();
  shared->options = options;
  return [shared](const Case& built, const programs::CaseShading& shading) -> Result<Planes> {
    std::call_once(shared->once, [&] { shared->painter = driver_painter(shared->options); });
    if (!shared->painter) return tl::unexpected(shared->painter.error());
    return (*shared->painter)(built, shading);
  };
}

Painter painted_before(Result<Planes> planes) {
  const auto shared = std::make_shared<const Result<Planes>>(std::move(planes));
  return [shared](const Case&, const programs::CaseShading&) { return *shared; };
}

}  // namespace fillrule::scene
