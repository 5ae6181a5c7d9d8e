#include "harness/scene/assets.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "cases/format/suggestion.h"
#include "harness/mesh/texture.h"

namespace fillrule::scene {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kObj = ".obj";

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

// The path as seen from the case file.
fs::path beside(const std::string& case_file, const std::string& path) {
  return fs::path(case_file).parent_path() / path;
}

tl::unexpected<Error> error_at(const std::string& case_file, const ScenePath& name, std::string what,
                               std::string hint = {}) {
  return tl::unexpected(Error{
      .file = case_file, .line = name.line, .column = name.column, .what = std::move(what), .hint = std::move(hint)});
}

// Where models and images without a path are.
std::vector<fs::path> meshes_folders(const std::string& case_file) {
  return {beside(case_file, "meshes"), beside(case_file, "../meshes"), FILLRULE_SOURCE_DIR "/cases/meshes"};
}

std::vector<std::string> names_in(const std::vector<fs::path>& folders, const std::vector<std::string>& endings,
                                  bool with_ending) {
  std::set<std::string> names;
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
      const std::string ending = entry.path().extension().string();
      if (std::find(endings.begin(), endings.end(), ending) == endings.end()) continue;
      names.insert(with_ending ? entry.path().filename().string() : entry.path().stem().string());
    }
  }
  return {names.begin(), names.end()};
}

Result<std::string> mesh_path(const std::string& case_file, const ScenePath& name) {
  if (name.text.ends_with(kObj)) {
    const fs::path path = beside(case_file, name.text);
    if (is_file(path)) return path.string();
    return error_at(case_file, name, fmt::format("there is no file {}", path.string()));
  }
  const std::vector<fs::path> folders = meshes_folders(case_file);
  for (const fs::path& folder : folders) {
    const fs::path path = folder / (name.text + std::string(kObj));
    if (is_file(path)) return path.string();
  }
  return error_at(case_file, name, fmt::format("there is no model \"{}\"", name.text),
                  format::suggestion(name.text, names_in(folders, {std::string(kObj)}, false), "the models are"));
}

Result<std::string> texture_path(const std::string& case_file, const ScenePath& name) {
  const std::vector<fs::path> folders = meshes_folders(case_file);
  std::vector<fs::path> paths{beside(case_file, name.text)};
  for (const fs::path& folder : folders) paths.push_back(folder / name.text);
  for (const fs::path& path : paths) {
    if (is_file(path)) return path.string();
  }
  return error_at(
      case_file, name, fmt::format("there is no image \"{}\"", name.text),
      format::suggestion(name.text, names_in(folders, {".png", ".bmp"}, true), "those that come along are"));
}

}  // namespace

Result<std::shared_ptr<const mesh::Mesh>> Assets::mesh(const std::string& case_file, const SceneObject& object) {
  const Result<std::string> path = mesh_path(case_file, object.mesh);
  if (!path) return tl::unexpected(path.error());
  const std::string key = fmt::format("{} {}", static_cast<int>(object.normals), *path);
  const std::lock_guard lock(mutex_);
  if (const auto found = meshes_.find(key); found != meshes_.end()) return found->second;
  const auto read = mesh::read_obj(*path, object.normals).map([](mesh::Mesh mesh) {
    return std::make_shared<const mesh::Mesh>(std::move(mesh));
  });
  return meshes_.emplace(key, read).first->second;
}

Result<std::shared_ptr<const Texture>> Assets::texture(const std::string& case_file, const ScenePath& name,
                                                       const Sampling2D& sampling) {
  const Result<std::string> path = texture_path(case_file, name);
  if (!path) return tl::unexpected(path.error());
  const std::string key = fmt::format("{} {} {} {} {} {}", static_cast<int>(sampling.filter),
                                      static_cast<int>(sampling.wrap_u), static_cast<int>(sampling.wrap_v),
                                      static_cast<int>(sampling.border), static_cast<int>(sampling.mipmaps), *path);
  const std::lock_guard lock(mutex_);
  if (const auto found = textures_.find(key); found != textures_.end()) return found->second;
  const auto read = mesh::read_texture(*path, sampling).map([](Texture texture) {
    return std::make_shared<const Texture>(std::move(texture));
  });
  return textures_.emplace(key, read).first->second;
}

Result<void> Assets::find_texture(const std::string& case_file, const ScenePath& name) {
  if (const Result<std::string> path = texture_path(case_file, name); !path) return tl::unexpected(path.error());
  return {};
}

}  // namespace fillrule::scene
