// A model: triangles with normals and texture coordinates.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cases/model/result.h"
#include "cases/model/scene.h"

namespace fillrule::mesh {

// Object space. Equal positions have equal bits, so edges that triangles share stay shared when transformed.
struct Vertex {
  glm::vec3 position{};
  glm::vec3 normal{};  // length 1; 0 where a face has no area
  glm::vec2 uv{};      // v downwards, as Vulkan has it: 1 less that of the file
};

struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<uint32_t> indices;  // three for each triangle, counter-clockwise seen from outside
};

// Reads an OBJ file: v, vt, vn, f (polygons and negative indices too), g, o, s; everything else is passed over. The
// normals that a file lacks come from the winding: of the faces that share a vertex and a smoothing group averaged by
// area, else of each face. Errors name the line.
Result<Mesh> read_obj(const std::string& path, Normals normals);

// The same for text in memory; errors call it `file_label`.
Result<Mesh> parse_obj(std::string_view text, const std::string& file_label, Normals normals);

}  // namespace fillrule::mesh
