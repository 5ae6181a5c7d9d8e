#include "harness/view/bake.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "cases/format/writer.h"
#include "harness/report/pictures.h"

namespace fillrule::view {
namespace {

constexpr uint32_t kMostViews = 9999;

// The last part of the name, as a file can be called.
std::string stem_of(const Case& built) {
  return report::file_stem(std::filesystem::path(built.name.substr(0, built.name.find('['))).filename().string());
}

Result<void> write_to(std::FILE* file, const std::string& path, const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const bool closed = std::fclose(file) == 0;
  if (!written || !closed) return tl::unexpected(Error{.file = path, .what = "cannot be written"});
  return {};
}

}  // namespace

Result<std::string> bake(const Case& built, const std::string& folder) {
  Case baked = built;
  baked.title = fmt::format("A view of {}", built.name);
  baked.origin = fmt::format("fillrule view {}", built.name);
  baked.control.clear();
  baked.effect = Effect::kDifferent;
  baked.scene.reset();
  const std::string text = format::write(baked);
  for (uint32_t number = 1; number <= kMostViews; ++number) {
    const std::string name = fmt::format("{}_view_{}.toml", stem_of(built), number);
    std::string path = (std::filesystem::path(folder) / name).string();
    // "x": fails if it is there, whoever has made it meanwhile.
    std::FILE* const file = std::fopen(path.c_str(), "wx");
    if (file != nullptr) return write_to(file, path, text).map([&] { return std::move(path); });
    if (errno != EEXIST) {
      return tl::unexpected(
          Error{.file = path, .what = "cannot be written: " + std::generic_category().message(errno)});
    }
  }
  return tl::unexpected(Error{.file = folder, .what = fmt::format("has {} views of it already", kMostViews)});
}

}  // namespace fillrule::view
