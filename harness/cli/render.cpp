#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "harness/cli/command.h"
#include "harness/cli/options.h"
#include "harness/cli/subject.h"
#include "harness/images/images.h"
#include "harness/scene/build.h"
#include "harness/scene/painters.h"
#include "harness/scene/picture.h"
#include "harness/scene/view.h"

namespace fillrule::cli {
namespace {

struct RenderOptions {
  SuiteOptions suite;
  std::string output;
  std::string by = "renderer";
  uint32_t turntable = 0;  // pictures; 0: one of the scene as it is
  std::string size;
  uint32_t threads = 1;
};

Result<Case> find_scene(const SuiteOptions& options, scene::Assets& assets) {
  Result<Case> found = find_subject(options, assets, "render");
  if (!found || found->scene) return found;
  return failure(fmt::format("{} is no scene", found->name),
                 fmt::format("'fillrule show {}' draws any case", found->name));
}

Result<scene::Painter> find_painter(const RenderOptions& options) {
  const renderer::Options renderer_options{.threads = options.threads};
  if (options.by == "renderer") return scene::renderer_painter(renderer_options);
  if (options.by == "renderer:scanline") {
    renderer::Options scanline = renderer_options;
    scanline.fill = renderer::Fill::kScanline;
    return scene::renderer_painter(scanline);
  }
  return scene::driver_painter({.driver = options.by, .driver_files = driver_files()});
}

// "out.png" becomes "out_007.png" of a turntable.
std::string frame_path(const RenderOptions& options, uint32_t frame) {
  if (options.turntable == 0) return options.output;
  const std::filesystem::path path(options.output);
  const std::string name = fmt::format("{}_{:03}{}", path.stem().string(), frame, path.extension().string());
  return (path.parent_path() / name).string();
}

Result<void> render_frame(const Case& view, const scene::Painter& paint, scene::Assets& assets,
                          const std::string& path) {
  const Result<Case> built = scene::build(view, assets);
  if (!built) return tl::unexpected(built.error());
  const auto shading = scene::shading_of(*built, assets);
  if (!shading) return tl::unexpected(shading.error());
  const Result<Planes> planes = paint(*built, *shading);
  if (!planes) return tl::unexpected(planes.error());
  const scene::ColorPicture picture = scene::picture_of(*planes, view.scene->background);
  return images::write(path, images::rgb_layout(picture.width, picture.height), picture.rgb);
}

Result<void> check_output(const RenderOptions& options) {
  const std::string ending = std::filesystem::path(options.output).extension().string();
  if (ending != ".png" && ending != ".exr") {
    return failure(fmt::format("the output \"{}\" is neither .png nor .exr", options.output));
  }
  return check_writable(frame_path(options, 0));
}

Result<void> render(const RenderOptions& options, const scene::Painter& paint) {
  if (auto writable = check_output(options); !writable) return writable;
  scene::Assets assets;
  Result<Case> found = find_scene(options.suite, assets);
  if (!found) return tl::unexpected(found.error());
  if (!options.size.empty()) {
    const auto size = parse_size(options.size);
    if (!size) return tl::unexpected(size.error());
    found = scene::resized(*found, size->first, size->second);
  }
  const uint32_t frames = std::max(options.turntable, 1U);
  for (uint32_t frame = 0; frame < frames; ++frame) {
    const std::string path = frame_path(options, frame);
    const Case view = options.turntable == 0 ? *found : scene::turned(*found, 360.0 * frame / frames);
    if (auto done = render_frame(view, paint, assets, path); !done) return done;
    fmt::print("{}\n", path);
  }
  return {};
}

}  // namespace

void add_render(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand("render", "draw a scene in colour, by the renderer or a driver");
  const auto options = std::make_shared<RenderOptions>();
  add_suite_options(*command, options->suite);
  command->get_option("cases")->required()->expected(1)->description("a scene's case, or an OBJ file");
  command->add_option("-o,--output", options->output, "a .png or .exr file")->required()->type_name("FILE");
  command
      ->add_option("--by", options->by,
                   "who draws: renderer, renderer:scanline, or a driver as 'fillrule devices' "
                   "names it")
      ->capture_default_str();
  command->add_option("--turntable", options->turntable, "so many pictures of the models turning once: FILE_000, ...")
      ->check(CLI::Range(1, 1000));
  command->add_option("--size", options->size, "of the picture instead of the case's")->type_name("WxH");
  command->add_option("--threads", options->threads, "that the renderer draws with")->check(CLI::Range(1, 256));
  command->callback([options, &exit_code] {
    const Result<scene::Painter> painter = find_painter(*options);
    if (!painter) {
      print_error(painter.error());
      exit_code = kNoReference;
      return;
    }
    const Result<void> rendered = render(*options, *painter);
    if (!rendered) print_error(rendered.error());
    exit_code = rendered ? kConforms : kBadInput;
  });
}

}  // namespace fillrule::cli
