#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>
#include <map>
#include <system_error>
#include <unordered_map>

#include "harness/mesh/mesh.h"
#include "harness/mesh/obj_check.h"

namespace fillrule::mesh {
namespace {

// Where a corner's normal comes from: with the position and the texture coordinates, what makes vertices equal.
enum class NormalSource : uint8_t { kFile, kFace, kGroup };

struct Corner {
  int position = 0;
  int uv = -1;  // -1: none
  NormalSource source = NormalSource::kFile;
  uint32_t normal = 0;  // of the file, or the number of the triangle, or the smoothing group
  bool operator==(const Corner&) const = default;
};

struct CornerHash {
  size_t operator()(const Corner& corner) const {
    auto hash = static_cast<size_t>(corner.position);
    for (const size_t part :
         {static_cast<size_t>(corner.uv), static_cast<size_t>(corner.source), size_t{corner.normal}}) {
      hash = hash * 0x9E3779B97F4A7C15U + part;
    }
    return hash;
  }
};

glm::vec3 normalized(const glm::dvec3& vector) {
  const double length = glm::length(vector);
  return length > 0 ? glm::vec3(vector / length) : glm::vec3(0);
}

// One triangle of the file.
struct Triangle {
  std::array<tinyobj::index_t, 3> corners;
  uint32_t group = 0;   // smoothing group; 0: none
  glm::dvec3 normal{};  // its length is twice the area
};

class MeshBuilder {
 public:
  MeshBuilder(const tinyobj::ObjReader& reader, Normals normals)
      : attributes_(reader.GetAttrib()), normals_(normals) {
    for (const tinyobj::shape_t& shape : reader.GetShapes()) add_shape(shape.mesh);
  }

  Mesh build() {
    average_normals();
    for (uint32_t i = 0; i < triangles_.size(); ++i) {
      for (const tinyobj::index_t& index : triangles_[i].corners) mesh_.indices.push_back(vertex_of(index, i));
    }
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] glm::vec3 position(int index) const {
    const size_t first = static_cast<size_t>(index) * 3;
    return {attributes_.vertices[first], attributes_.vertices[first + 1], attributes_.vertices[first + 2]};
  }

  void add_shape(const tinyobj::mesh_t& mesh) {
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      Triangle triangle{.corners = {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]}};
      triangle.group = normals_ == Normals::kSmooth ? 1 : mesh.smoothing_group_ids[i / 3];
      const glm::dvec3 first(position(triangle.corners[0].vertex_index));
      const glm::dvec3 edge1 = glm::dvec3(position(triangle.corners[1].vertex_index)) - first;
      const glm::dvec3 edge2 = glm::dvec3(position(triangle.corners[2].vertex_index)) - first;
      triangle.normal = glm::cross(edge1, edge2);
      triangles_.push_back(triangle);
    }
  }

  [[nodiscard]] NormalSource source_of(const Triangle& triangle, const tinyobj::index_t& corner) const {
    if (normals_ == Normals::kFlat) return NormalSource::kFace;
    if (normals_ == Normals::kFile && corner.normal_index >= 0) return NormalSource::kFile;
    return triangle.group == 0 ? NormalSource::kFace : NormalSource::kGroup;
  }

  void average_normals() {
    for (const Triangle& triangle : triangles_) {
      for (const tinyobj::index_t& corner : triangle.corners) {
        if (source_of(triangle, corner) != NormalSource::kGroup) continue;
        group_normals_[{corner.vertex_index, triangle.group}] += triangle.normal;
      }
    }
  }

  uint32_t vertex_of(const tinyobj::index_t& index, uint32_t number) {
    const Triangle& triangle = triangles_[number];
    Corner corner{.position = index.vertex_index, .uv = index.texcoord_index, .source = source_of(triangle, index)};
    Vertex vertex{.position = position(index.vertex_index)};
    switch (corner.source) {
      case NormalSource::kFile: {
        corner.normal = static_cast<uint32_t>(index.normal_index);
        const size_t first = size_t{corner.normal} * 3;
        vertex.normal =
            normalized({attributes_.normals[first], attributes_.normals[first + 1], attributes_.normals[first + 2]});
        break;
      }
      case NormalSource::kFace:
        corner.normal = number;
        vertex.normal = normalized(triangle.normal);
        break;
      case NormalSource::kGroup:
        corner.normal = triangle.group;
        vertex.normal = normalized(group_normals_[{index.vertex_index, triangle.group}]);
        break;
    }
    if (corner.uv >= 0) {
      const size_t first = static_cast<size_t>(corner.uv) * 2;
      vertex.uv = {attributes_.texcoords[first], 1 - attributes_.texcoords[first + 1]};
    }
    const auto [place, fresh] = numbers_.try_emplace(corner, static_cast<uint32_t>(mesh_.vertices.size()));
    if (fresh) mesh_.vertices.push_back(vertex);
    return place->second;
  }

  const tinyobj::attrib_t& attributes_;
  Normals normals_;
  std::vector<Triangle> triangles_;
  std::map<std::pair<int, uint32_t>, glm::dvec3> group_normals_;  // by position and smoothing group
  std::unordered_map<Corner, uint32_t, CornerHash> numbers_;
  Mesh mesh_;
};

}  // namespace

Result<Mesh> parse_obj(std::string_view text, const std::string& file_label, Normals normals) {
  const Result<std::string> geometry = checked_obj(text, file_label);
  if (!geometry) return tl::unexpected(geometry.error());
  tinyobj::ObjReaderConfig config;
  config.vertex_color = false;
  tinyobj::ObjReader reader;
  if (!reader.ParseFromString(*geometry, "", config)) {
    return tl::unexpected(Error{.file = file_label, .what = "cannot be read: " + reader.Error()});
  }
  Mesh mesh = MeshBuilder(reader, normals).build();
  if (mesh.indices.empty()) {
    return tl::unexpected(Error{.file = file_label, .what = "no face of this file has an area"});
  }
  return mesh;
}

Result<Mesh> read_obj(const std::string& path, Normals normals) {
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  // A folder opens, but does not read.
  if (stream) stream.peek();
  if (!stream && !stream.eof()) {
    const std::string reason = std::generic_category().message(errno == 0 ? EIO : errno);
    return tl::unexpected(Error{.file = path, .what = "cannot be read: " + reason});
  }
  stream.clear();
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return parse_obj(text, path, normals);
}

}  // namespace fillrule::mesh
