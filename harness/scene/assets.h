// Models and textures, each read once. May be used by several threads at once.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "cases/model/result.h"
#include "cases/model/scene.h"
#include "harness/mesh/mesh.h"

namespace fillrule::scene {

class Assets {
 public:
  // What a case file names. Anything that ends in .obj is a path from the case file's folder; "cube" is cube.obj in a
  // folder "meshes" there or beside that folder, or else in the project's own cases/meshes. Errors name the place in
  // the case file, or the line of the OBJ file.
  Result<std::shared_ptr<const mesh::Mesh>> mesh(const std::string& case_file, const SceneObject& object);

  // A path from the case file's folder, or the name of an image in one of those folders.
  Result<std::shared_ptr<const Texture>> texture(const std::string& case_file, const ScenePath& name,
                                                 const Sampling2D& sampling);

  // Whether there is such a file at all, without reading it.
  static Result<void> find_texture(const std::string& case_file, const ScenePath& name);

 private:
  template <typename T>
  using Cache = std::map<std::string, Result<std::shared_ptr<const T>>>;

  std::mutex mutex_;
  Cache<mesh::Mesh> meshes_;
  Cache<Texture> textures_;
};

}  // namespace fillrule::scene
