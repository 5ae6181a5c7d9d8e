#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>
#include <glm/geometric.hpp>
#include <random>

#include "cases/model/temporary_folder.h"
#include "harness/mesh/mesh.h"

namespace fillrule::mesh {
namespace {

using namespace std::string_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Mesh mesh_of(const std::string& text, Normals normals = Normals::kFile) {
  Result<Mesh> mesh = parse_obj(text, "a.obj", normals);
  if (!mesh) ADD_FAILURE() << to_string(mesh.error());
  return mesh ? *mesh : Mesh{};
}

std::string error_of(const std::string& text) {
  const Result<Mesh> mesh = parse_obj(text, "a.obj", Normals::kFile);
  return mesh ? "no error" : to_string(mesh.error());
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, ReadsPositionsTextureCoordinatesAndNormals) {
  const Mesh mesh = mesh_of(kSquare + "vt 0.25 0.75\nvt 1 0\nvn 0 0 2\nf 1/1/1 2/2/1 3/1/1\n");
  ASSERT_EQ(mesh.vertices.size(), 3U);
  EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2));
  EXPECT_EQ(mesh.vertices[1].position, glm::vec3(1, 0, 0));
  EXPECT_EQ(mesh.vertices[0].uv, glm::vec2(0.25F, 0.25F)) << "v grows downwards";
  EXPECT_EQ(mesh.vertices[1].uv, glm::vec2(1, 1));
  EXPECT_EQ(mesh.vertices[2].normal, glm::vec3(0, 0, 1));
}

TEST(Obj, CutsPolygonsIntoTriangles) {
  const Mesh mesh = mesh_of(kSquare + "v 0.5 1.5 0\nf 1 2 3 5 4\n", Normals::kSmooth);
  EXPECT_EQ(mesh.indices.size(), 9U);
  EXPECT_EQ(mesh.vertices.size(), 5U);
  double area = 0;
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto at = [&](size_t corner) { return mesh.vertices[mesh.indices[i + corner]].position; };
    area += glm::cross(at(1) - at(0), at(2) - at(0)).z / 2;
  }
  EXPECT_NEAR(area, 1.25, 1e-6) << "each piece has the polygon's winding";
}

TEST(Obj, CountsNegativeIndicesFromTheLast) {
  const Mesh mesh = mesh_of(kSquare + "f -4 -3 -2\nv 9 9 9\nf -5 -3 -2\n");
  ASSERT_EQ(mesh.indices.size(), 6U);
  EXPECT_EQ(mesh.vertices[mesh.indices[0]].position, glm::vec3(0, 0, 0));
  EXPECT_EQ(mesh.vertices[mesh.indices[3]].position, glm::vec3(0, 0, 0));
  EXPECT_EQ(mesh.vertices[mesh.indices[4]].position, glm::vec3(1, 1, 0));
}

TEST(Obj, TakesAllGroupsAndObjectsTogether) {
  EXPECT_EQ(mesh_of(kSquare + "o one\ng a\nf 1 2 3\ng b c\nf 1 3 4\no two\nusemtl x\nf 2 3 4\n").indices.size(), 9U);
}

TEST(Obj, MakesNormalsFromTheWinding) {
  EXPECT_EQ(mesh_of(kSquare + "f 1 2 3\n").vertices[0].normal, glm::vec3(0, 0, 1));
  EXPECT_EQ(mesh_of(kSquare + "f 3 2 1\n").vertices[0].normal, glm::vec3(0, 0, -1));
}

TEST(Obj, AveragesNormalsWithinASmoothingGroup) {
  // Two faces that meet at a right angle along the edge from (0, 0, 0) to (0, 1, 0); the second has twice the area.
  const std::string corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\n";
  const std::string faces = "f 1 2 3\nf 1 3 4\n";
  const auto normals_at_origin = [](const Mesh& mesh) {
    std::vector<glm::vec3> normals;
    for (const Vertex& vertex : mesh.vertices) {
      if (vertex.position == glm::vec3(0, 0, 0)) normals.push_back(vertex.normal);
    }
    return normals;
  };
  EXPECT_THAT(normals_at_origin(mesh_of(corner + faces)), ElementsAre(glm::vec3(0, 0, 1), glm::vec3(1, 0, 0)));
  const auto smooth = normals_at_origin(mesh_of(corner + "s 1\n" + faces));
  ASSERT_EQ(smooth.size(), 1U);
  EXPECT_LT(glm::distance(smooth[0], glm::normalize(glm::vec3(2, 0, 1))), 1e-6F);
  EXPECT_EQ(normals_at_origin(mesh_of(corner + faces, Normals::kSmooth)), smooth);
  EXPECT_EQ(normals_at_origin(mesh_of(corner + "s 1\nf 1 2 3\ns off\nf 1 3 4\n")).size(), 2U);
  EXPECT_EQ(normals_at_origin(mesh_of(corner + "s 1\n" + faces, Normals::kFlat)).size(), 2U);
}

TEST(Obj, JoinsContinuedLinesAndIgnoresComments) {
  EXPECT_EQ(mesh_of("# a comment\nv 0 0 \\\n0\r\nv 1 0 0 # here\n\nv 0 1 0\nf 1 2 \\\n 3\n").indices.size(), 3U);
}

TEST(Obj, TellsMistakesWithTheirLine) {
  EXPECT_THAT(error_of("v 0 0\n"), HasSubstr("a.obj:1:1: \"v\" with 2 numbers instead of 3"));
  EXPECT_THAT(error_of("v 0 0 0\nv 1 x 0\n"), HasSubstr("a.obj:2:5: \"x\" is no finite number"));
  EXPECT_THAT(error_of("v 0 0 nan\n"), HasSubstr("no finite number"));
  EXPECT_THAT(error_of("v 0 0 1e39\n"), HasSubstr("no finite number"));
  EXPECT_THAT(error_of(kSquare + "f 1 2\n"), HasSubstr("a.obj:5:1: a face of 2 vertices"));
  EXPECT_THAT(error_of(kSquare + "f 1 2 5\n"), HasSubstr("a.obj:5:7: 5 in \"5\" names no \"v\""));
  EXPECT_THAT(error_of(kSquare + "f 1 2 5\n"), HasSubstr("there are 4 so far"));
  EXPECT_THAT(error_of(kSquare + "f 0 1 2\n"), HasSubstr("0 in \"0\" names no"));
  EXPECT_THAT(error_of(kSquare + "f -5 1 2\n"), HasSubstr("-5 in \"-5\" names no"));
  EXPECT_THAT(error_of(kSquare + "f 1/1 2 3\n"), HasSubstr("names no \"vt\""));
  EXPECT_THAT(error_of(kSquare + "f 1//1 2 3\n"), HasSubstr("names no \"vn\""));
  EXPECT_THAT(error_of(kSquare + "f 1/ 2 3\n"), HasSubstr("\"1/\" is no vertex of a face"));
  EXPECT_THAT(error_of(kSquare + "vt 0 0\nvn 0 0 1\nf 1/1/1/1 2 3\n"), HasSubstr("is no vertex of a face"));
  EXPECT_THAT(error_of(kSquare), HasSubstr("no faces"));
  EXPECT_THAT(error_of(""), HasSubstr("no faces"));
  EXPECT_THAT(to_string(read_obj("/no/such.obj", Normals::kFile).error()), HasSubstr("/no/such.obj: cannot be read"));
  EXPECT_THAT(to_string(read_obj(testing::TempDir(), Normals::kFile).error()), HasSubstr("cannot be read"));
}

// Files with bytes changed, taken out and put in: an error with its line, or a mesh, and nothing else.
TEST(Obj, SurvivesBrokenFiles) {
  std::ifstream stream(FILLRULE_SOURCE_DIR "/cases/meshes/cube.obj");
  const std::string whole{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  ASSERT_FALSE(whole.empty());
  std::mt19937 random(7);
  const std::string alphabet = "0123456789.-+eE/ \n\\#vfgnts\t\r\0x"s;
  size_t meshes = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string text = whole;
    for (uint32_t i = 0; i < 1 + random() % 4; ++i) {
      const size_t place = random() % text.size();
      const char c = alphabet[random() % alphabet.size()];
      switch (random() % 3) {
        case 0:
          text[place] = c;
          break;
        case 1:
          text.insert(place, 1 + random() % 3, c);
          break;
        default:
          text.erase(place, 1 + random() % 20);
      }
    }
    const Result<Mesh> mesh = parse_obj(text, "a.obj", Normals::kFile);
    if (!mesh) {
      EXPECT_FALSE(mesh.error().what.empty());
      continue;
    }
    ++meshes;
    for (const uint32_t index : mesh->indices) ASSERT_LT(index, mesh->vertices.size());
  }
  EXPECT_GT(meshes, 0U);
}

TEST(Obj, ReadsLargeModels) {
  const TemporaryFolder folder;
  const std::string path = folder.path("large.obj");
  constexpr int kSide = 240;
  {
    std::ofstream file(path);
    for (int y = 0; y <= kSide; ++y) {
      for (int x = 0; x <= kSide; ++x) file << fmt::format("v {} {} {}\n", x, y, (x * y) % 7);
    }
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const int first = y * (kSide + 1) + x + 1;
        file << fmt::format("f {} {} {} {}\n", first, first + 1, first + kSide + 2, first + kSide + 1);
      }
    }
  }
  const Result<Mesh> mesh = read_obj(path, Normals::kSmooth);
  ASSERT_TRUE(mesh) << to_string(mesh.error());
  EXPECT_EQ(mesh->indices.size(), size_t{3} * 2 * kSide * kSide);
  EXPECT_EQ(mesh->vertices.size(), size_t{kSide + 1} * (kSide + 1));
}

TEST(Obj, ReadsTheModelsThatComeAlong) {
  const std::string folder = FILLRULE_SOURCE_DIR "/cases/meshes/";
  for (const auto& [name, triangles] : std::vector<std::pair<std::string, size_t>>{{"cube", 12},
                                                                                   {"torus", 576},
                                                                                   {"icosphere", 320},
                                                                                   {"plane", 2},
                                                                                   {"quad", 2},
                                                                                   {"triangle", 1},
                                                                                   {"beam", 2},
                                                                                   {"jug", 1440}}) {
    const Result<Mesh> mesh = read_obj(folder + name + ".obj", Normals::kFile);
    ASSERT_TRUE(mesh) << to_string(mesh.error());
    EXPECT_EQ(mesh->indices.size(), 3 * triangles) << name;
    // Seen from outside, triangles are counter-clockwise: their normals are the vertices'.
    for (size_t i = 0; i < mesh->indices.size(); i += 3) {
      const auto at = [&](size_t corner) -> const Vertex& { return mesh->vertices[mesh->indices[i + corner]]; };
      const glm::vec3 normal = glm::cross(at(1).position - at(0).position, at(2).position - at(0).position);
      const glm::vec3 mean = at(0).normal + at(1).normal + at(2).normal;
      EXPECT_GE(glm::dot(normal, mean), 0.0F) << name << " triangle " << i / 3;
    }
  }
}

}  // namespace
}  // namespace fillrule::mesh
