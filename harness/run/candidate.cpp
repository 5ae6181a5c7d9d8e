#include "harness/run/candidate.h"

#include <fmt/format.h>

#include <memory>
#include <mutex>
#include <string_view>

#include "harness/faults/cheats.h"
#include "harness/faults/rasterizer.h"
#include "harness/programs/varyings.h"
#include "harness/run/reference.h"

namespace fillrule::run {
namespace {

constexpr std::string_view kRenderer = "renderer";
constexpr std::string_view kScanlineRenderer = "renderer:scanline";
constexpr std::string_view kFaults = "faults:";
constexpr std::string_view kCheats = "cheats:";

Candidate make_renderer(std::string_view name, renderer::Fill fill, const CandidateOptions& options) {
  const renderer::Options renderer_options{
      .subpixel_bits = options.subpixel_bits, .threads = options.threads, .fill = fill, .isa = options.isa};
  const auto draw = [renderer_options](const Case& test_case, uint32_t threads) {
    renderer::Options chosen = renderer_options;
    if (threads != 0) chosen.threads = threads;
    return programs::draw_case(test_case, chosen);
  };
  const auto check = [](const Case& test_case) -> Result<void> {
    const FeatureSet missing = features_of(test_case).without(programs::renderer_features());
    if (!missing.empty()) return failure("the renderer lacks " + to_string(missing));
    return {};
  };
  return {.name = std::string(name),
          .subpixel_bits = options.subpixel_bits,
          .features = programs::renderer_features(),
          .check = check,
          .draw = draw,
          .paint = scene::renderer_painter(renderer_options)};
}

// The naive rasterizer, with a fault or a cheat: `draw(case, subpixel bits)`.
template <typename Draw>
Candidate make_naive(const std::string& name, const CandidateOptions& options, const Draw& draw) {
  const uint32_t bits = options.subpixel_bits;
  return {.name = name,
          .subpixel_bits = bits,
          .features = FeatureSet::all(),
          .check = [](const Case&) -> Result<void> { return {}; },
          .draw = [draw, bits](const Case& test_case, uint32_t) -> Result<Planes> { return draw(test_case, bits); }};
}

Result<Candidate> make_faulty(const std::string& name, const CandidateOptions& options) {
  const std::string_view fault_name = name;
  return faults::fault_named(fault_name.substr(kFaults.size())).map([&](faults::Fault fault) {
    return make_naive(name, options, [fault](const Case& test_case, uint32_t bits) {
      return faults::draw_case(test_case, fault, bits);
    });
  });
}

Result<Candidate> make_cheat(const std::string& name, const CandidateOptions& options) {
  const std::string_view cheat_name = name;
  return faults::cheat_named(cheat_name.substr(kCheats.size())).map([&](faults::Cheat cheat) {
    return make_naive(name, options, [cheat](const Case& test_case, uint32_t bits) {
      return faults::draw_cheat(test_case, cheat, bits);
    });
  });
}

// A device is for one thread at a time.
struct SharedDevice {
  std::mutex mutex;
  vulkan::Reference device;

  explicit SharedDevice(vulkan::Reference the_device) : device(std::move(the_device)) {}

  [[nodiscard]] Result<void> check(const Case& test_case) const {
    return vulkan::check_case(device.device(), test_case);
  }

  Result<Planes> draw(const Case& test_case) {
    if (const Result<void> can = check(test_case); !can) return tl::unexpected(can.error());
    const std::lock_guard lock(mutex);
    const Case* const one = &test_case;
    std::vector<Result<Planes>> drawn = device.draw({&one, 1});
    Result<Planes> planes = std::move(drawn.front());
    return planes;
  }
};

Result<Candidate> make_driver(const std::string& name, const CandidateOptions& options) {
  Result<vulkan::Reference> device = open_device(name, options.driver_files, false);
  if (!device) {
    Error error = device.error();
    error.what = fmt::format("there is no candidate '{}': {}", name, error.what);
    error.hint =
        "the candidates are renderer, renderer:scanline, faults:NAME, cheats:NAME and the drivers that 'fillrule "
        "devices' "
        "lists; " +
        error.hint;
    return tl::unexpected(error);
  }
  const auto shared = std::make_shared<SharedDevice>(std::move(*device));
  return Candidate{.name = name,
                   .subpixel_bits = shared->device.device().subpixel_bits,
                   .features = shared->device.device().features,
                   .check = [shared](const Case& test_case) { return shared->check(test_case); },
                   .draw = [shared](const Case& test_case, uint32_t) { return shared->draw(test_case); },
                   .paint = scene::driver_painter_on_demand({.driver = name, .driver_files = options.driver_files})};
}

}  // namespace

Result<Candidate> make_candidate(const std::string& name, const CandidateOptions& options) {
  if (name == kRenderer) return make_renderer(name, renderer::Fill::kEdgeFunction, options);
  if (name == kScanlineRenderer) return make_renderer(name, renderer::Fill::kScanline, options);
  if (name.starts_with(kFaults)) return make_faulty(name, options);
  if (name.starts_with(kCheats)) return make_cheat(name, options);
  return make_driver(name, options);
}

}  // namespace fillrule::run
