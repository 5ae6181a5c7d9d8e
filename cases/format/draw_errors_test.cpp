// Bad declarations of varyings and bad draws, with the exact text of their errors.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cases/format/test_files.h"

namespace fillrule::format {
namespace {

TEST(BadVaryings, Declaration) {
  EXPECT_EQ(errors_with_draw("varyings.c = 3\n"),
            "a.toml:4:14: varying \"c\" must be a table or an interpolation, not an integer\n"
            "  hint: for example \"smooth\" or { components = 3, interpolation = \"smooth\" }\n"
            "a.toml:5:1: draw lacks the varying \"c\"\n"
            "  hint: give one value for each position in [draw.varyings]\n");
  const std::string values = "[draw.varyings]\nc = [1]\n";
  EXPECT_EQ(errors_of("varyings.c = { components = 5 }\n" + kDraw + values),
            "a.toml:4:29: components must be 1 to 4, not 5\n");
  EXPECT_EQ(errors_of("varyings.c = { interpolation = 'flt', components = 1 }\n" + kDraw + values),
            "a.toml:4:32: unknown interpolation \"flt\"\n  hint: did you mean \"flat\"?\n");
  EXPECT_EQ(errors_of("varyings.c = { component = 1 }\n" + kDraw + values),
            "a.toml:4:16: unknown key \"component\" in varying \"c\"\n  hint: did you mean \"components\"?\n");
  EXPECT_EQ(errors_of("varyings.depth = 'smooth'\n" + kDraw + "varyings.depth = [1]\n"),
            "a.toml:4:10: a varying cannot be named \"depth\"\n"
            "  hint: the results have a plane of that name; choose another\n");
  EXPECT_EQ(errors_of("varyings.'a b' = 'smooth'\n" + kDraw + "varyings.'a b' = [1]\n"),
            "a.toml:4:10: \"a b\" is not a varying's name\n"
            "  hint: a name has letters, digits and _, and does not begin with a digit\n");
}

TEST(BadVaryings, Sampling) {
  const std::string values = "[draw.varyings]\nc = [1]\n";
  EXPECT_EQ(errors_of("varyings.c = { sampling = 'centre' }\n" + kDraw + values),
            "a.toml:4:27: unknown sampling \"centre\"\n  hint: did you mean \"center\"?\n");
  EXPECT_EQ(errors_of("varyings.c = { interpolation = 'flat', sampling = 'sample' }\n" + kDraw + values),
            "a.toml:4:51: varying \"c\" is flat and has no sampling\n  hint: leave the key out, or interpolate it\n");
}

TEST(BadVaryings, BuiltIns) {
  EXPECT_EQ(errors_with_draw("varyings.c = { source = 'fragcoord' }\n"),
            "a.toml:4:10: varying \"c\" has no vertex to take its number of components from\n"
            "  hint: give its values in [draw.varyings], or write { components = 1, interpolation = \"smooth\" }\n"
            "a.toml:4:25: unknown source \"fragcoord\"\n  hint: did you mean \"frag_coord\"?\n"
            "a.toml:5:1: draw lacks the varying \"c\"\n"
            "  hint: give one value for each position in [draw.varyings]\n");
  EXPECT_EQ(errors_with_draw("varyings.c = { source = 'frag_coord', components = 2, interpolation = 'flat' }\n"),
            "a.toml:4:52: varying \"c\" is a built-in and has no components\n  hint: leave the key out\n"
            "a.toml:4:71: varying \"c\" is a built-in and has no interpolation\n  hint: leave the key out\n");
  EXPECT_EQ(errors_with_draw("varyings.c = { source = 'frag_coord', sampling = 'sample' }\n"),
            "a.toml:4:50: varying \"c\" is a built-in and has no sampling\n  hint: leave the key out\n");
  EXPECT_EQ(errors_of("varyings.c = { source = 'frag_coord' }\n" + kDraw + "varyings.c = [[1, 2, 3, 4]]\n"),
            "a.toml:7:10: varying \"c\" is a built-in and has no values\n  hint: leave it out of [draw.varyings]\n");
  const std::string error =
      "varying \"c\" is point_coord, but this draw has no points\n"
      "  hint: topology = \"point_list\", or polygon_mode = \"point\"\n";
  EXPECT_EQ(errors_with_draw("varyings.c = { source = 'point_coord' }\n"), "a.toml:5:1: " + error);
  EXPECT_EQ(errors_of("varyings.c = { source = 'point_coord' }\nstate.polygon_mode = 'point'\n" + kDraw +
                      "topology = 'line_list'\n"),
            "a.toml:6:1: " + error);
}

TEST(BadVaryings, TooMany) {
  std::string declared = "[varyings]\n";
  std::string values = "[draw.varyings]\n";
  for (int i = 0; i < 9; ++i) {
    declared += fmt::format("v{} = 'flat'\n", i);
    values += fmt::format("v{} = [1]\n", i);
  }
  const std::string errors = errors_of(declared + kDraw + values);
  EXPECT_TRUE(errors.starts_with("a.toml:13:1: 9 varyings are too many\n  hint: a case has up to 8\n")) << errors;
}

TEST(BadDraw, None) {
  EXPECT_EQ(errors_of(""), "a.toml:1:1: the case draws nothing\n  hint: add a [[draw]] with positions\n");
  EXPECT_EQ(errors_of("draw = []\n"), "a.toml:1:1: the case draws nothing\n  hint: add a [[draw]] with positions\n");
  EXPECT_EQ(errors_of("[draw]\npositions = []\n"),
            "a.toml:4:1: draw must be an array of tables, not a table\n  hint: write [[draw]] with two brackets\n");
  EXPECT_EQ(errors_of("draw = [1]\n"), "a.toml:4:9: draw must be a table, not an integer\n");
}

TEST(BadDraw, Keys) {
  EXPECT_EQ(errors_of(kDraw + "indexes = [0]\n"),
            "a.toml:6:1: unknown key \"indexes\" in [[draw]]\n  hint: did you mean \"indices\"?\n");
  EXPECT_EQ(errors_of(kDraw + "state.cul_mode = 'back'\n"),
            "a.toml:6:7: unknown key \"cul_mode\" in [draw.state]\n  hint: did you mean \"cull_mode\"?\n");
}

TEST(BadDraw, Topology) {
  EXPECT_EQ(errors_of(kDraw + "topology = 'patch_list'\n"),
            "a.toml:6:12: topology \"patch_list\" is not supported\n"
            "  hint: supported: point_list, line_list, line_strip, triangle_list, triangle_strip, triangle_fan\n");
  EXPECT_EQ(errors_of(kDraw + "topology = 'triangles'\n"),
            "a.toml:6:12: unknown topology \"triangles\"\n"
            "  hint: known: point_list, line_list, line_strip, triangle_list, triangle_strip, triangle_fan\n");
}

TEST(BadDraw, Positions) {
  EXPECT_EQ(errors_of("[[draw]]\n"), "a.toml:4:1: draw has no positions\n  hint: positions = [[x, y, z, w], ...]\n");
  EXPECT_EQ(errors_of("[[draw]]\npositions = []\n"),
            "a.toml:5:13: positions is empty\n  hint: a draw has at least one vertex\n");
  EXPECT_EQ(errors_of("[[draw]]\npositions = [[0, 0]]\n"),
            "a.toml:5:14: position in clip space must be [x, y, z, w], not 2 numbers\n"
            "  hint: other spaces: space = \"ndc\" or \"framebuffer\"\n");
  EXPECT_EQ(errors_of("[[draw]]\nspace = 'ndc'\npositions = [[0], 1]\n"),
            "a.toml:6:14: position in ndc space must be [x, y], [x, y, z] or [x, y, z, w], not 1 numbers\n"
            "a.toml:6:19: position must be [x, y], [x, y, z] or [x, y, z, w], not an integer\n");
  EXPECT_EQ(errors_of("[[draw]]\nspace = 'screen'\npositions = [[0, 0, 0, 1]]\n"),
            "a.toml:5:9: unknown space \"screen\"\n  hint: known: clip, ndc, framebuffer\n");
  EXPECT_EQ(errors_of("[[draw]]\npositions = [[0, 0, true, 1]]\n"),
            "a.toml:5:21: coordinate must be a number, not a boolean\n");
}

TEST(BadDraw, Indices) {
  EXPECT_EQ(errors_of(kDraw + "indices = [0, 1]\n"), "a.toml:6:15: index must be 0 to 0, not 1\n");
  EXPECT_EQ(errors_of(kDraw + "indices = [-1]\n"), "a.toml:6:12: index must be 0 to 4294967295, not -1\n");
  EXPECT_EQ(errors_of(kDraw + "indices = []\n"),
            "a.toml:6:11: indices is empty\n  hint: leave the key out to draw the vertices in their order\n");
  EXPECT_EQ(errors_of(kDraw + "indices = 'all'\n"),
            "a.toml:6:11: indices must be an array of integers, not a string\n");
}

TEST(BadDraw, IndexState) {
  EXPECT_EQ(errors_of(kDraw + "index_type = 'uint16'\nvertex_offset = 1\nprimitive_restart = false\n"),
            "a.toml:6:14: index_type without indices\n  hint: give indices, or leave the key out\n"
            "a.toml:7:17: vertex_offset without indices\n  hint: give indices, or leave the key out\n"
            "a.toml:8:21: primitive_restart without indices\n  hint: give indices, or leave the key out\n");
  const std::string one = kDraw + "indices = [0]\n";
  EXPECT_EQ(errors_of(one + "index_type = 'int32'\n"),
            "a.toml:7:14: unknown index_type \"int32\"\n  hint: did you mean \"uint32\"?\n");
  EXPECT_EQ(errors_of(one + "vertex_offset = 0.5\n"), "a.toml:7:17: vertex_offset must be a whole number, not 0.5\n");
  EXPECT_EQ(errors_of(one + "vertex_offset = 2147483648\n"),
            "a.toml:7:17: vertex_offset must be -2147483648 to 2147483647, not 2147483648\n");
  EXPECT_EQ(errors_of(one + "primitive_restart = true\n"),
            "a.toml:7:21: primitive_restart is for strips and fans, not for lists\n"
            "  hint: Vulkan allows it for lists only with an extension\n");
  EXPECT_EQ(errors_of(kDraw + "indices = ['restart']\n"),
            "a.toml:6:12: an index restarts, but primitive_restart is not true\n"
            "  hint: strips and fans can restart, lists cannot\n");
  EXPECT_EQ(errors_of(kDraw + "topology = 'triangle_strip'\nindices = ['restart']\n"),
            "a.toml:7:12: an index restarts, but primitive_restart is not true\n"
            "  hint: write primitive_restart = true in the draw\n");
  // One mistake, one error.
  EXPECT_EQ(errors_of(kDraw + "indices = ['restart']\nprimitive_restart = true\n"),
            "a.toml:7:21: primitive_restart is for strips and fans, not for lists\n"
            "  hint: Vulkan allows it for lists only with an extension\n");
}

TEST(BadDraw, IndicesBeyondTheVerticesOrTheType) {
  const std::string hint = "  hint: vertices count from 0, in each copy of repeat anew\n";
  EXPECT_EQ(errors_of(kDraw + "indices = [7, 8]\nvertex_offset = -7\n"),
            "a.toml:6:15: index 8 with vertex_offset -7 is vertex 1 of 1\n" + hint);
  EXPECT_EQ(errors_of(kDraw + "indices = [0]\nvertex_offset = -1\n"),
            "a.toml:6:12: index 0 with vertex_offset -1 is vertex -1 of 1\n" + hint);
  EXPECT_EQ(errors_of(kDraw + "indices = [256]\nindex_type = 'uint8'\n"),
            "a.toml:6:12: index must be 0 to 255, not 256\n");
  EXPECT_EQ(errors_of(kDraw + "indices = [65536]\nindex_type = 'uint16'\n"),
            "a.toml:6:12: index must be 0 to 65535, not 65536\n");
  // Without restart 255 is an index as any other.
  EXPECT_EQ(errors_of(kDraw + "indices = [255]\nindex_type = 'uint8'\n"),
            "a.toml:6:12: index must be 0 to 0, not 255\n");
  const std::string copies = kDraw + "indices = [0]\nindex_type = 'uint8'\ntopology = 'line_strip'\n";
  EXPECT_EQ(errors_of(copies + "repeat = { i = 257 }\n"),
            "a.toml:6:12: repeat moves an index to 256, beyond 255, the index_type's largest\n"
            "  hint: choose a larger index_type\n");
  EXPECT_EQ(errors_of(copies + "repeat = { i = 256 }\nprimitive_restart = true\n"),
            "a.toml:6:12: repeat moves an index to 255, beyond 254, the index_type's largest\n"
            "  hint: choose a larger index_type\n");
}

TEST(BadDraw, PointSizes) {
  const std::string two = "[[draw]]\npositions = [[0, 0, 0, 1], [1, 0, 0, 1]]\n";
  EXPECT_EQ(errors_of(two + "point_sizes = [1]\n"), "a.toml:6:15: point_sizes has 1 values for 2 positions\n");
  EXPECT_EQ(errors_of(two + "point_sizes = [1, 0]\n"), "a.toml:6:19: point_sizes must be above 0, not 0\n");
  EXPECT_EQ(errors_of(two + "point_sizes = -1\n"), "a.toml:6:15: point_sizes must be above 0, not -1\n");
  EXPECT_EQ(errors_of(two + "point_sizes = nan\n"), "a.toml:6:15: point_sizes must be finite, not nan\n");
  EXPECT_EQ(errors_of(two + "point_sizes = true\n"), "a.toml:6:15: point_sizes must be a number, not a boolean\n");
}

TEST(BadDraw, Distances) {
  const std::string two = "[[draw]]\npositions = [[0, 0, 0, 1], [1, 0, 0, 1]]\n";
  EXPECT_EQ(errors_of(two + "clip_distances = 1\n"),
            "a.toml:6:18: clip_distances must be an array with one distance, or an array of them, for each position, "
            "not an integer\n");
  EXPECT_EQ(errors_of(two + "cull_distances = [1]\n"), "a.toml:6:18: cull_distances has 1 values for 2 positions\n");
  EXPECT_EQ(errors_of(two + "clip_distances = [[1, 2], [3]]\n"),
            "a.toml:6:27: clip_distances has 1 distances here and 2 at the first position\n");
  EXPECT_EQ(errors_of(two + "clip_distances = [[1, 2], 3]\n"),
            "a.toml:6:27: clip_distances has 1 distances here and 2 at the first position\n");
  EXPECT_EQ(errors_of(two + "clip_distances = [[], []]\n"),
            "a.toml:6:19: clip_distances must have 1 to 8 distances a position, not 0\n"
            "  hint: leave the key out if there are none\n");
  EXPECT_EQ(errors_of(kDraw + "cull_distances = [[1, 2, 3, 4, 5, 6, 7, 8, 9]]\n"),
            "a.toml:6:19: cull_distances must have 1 to 8 distances a position, not 9\n");
  EXPECT_EQ(errors_of(kDraw + "clip_distances = [[1, 2, 3, 4, 5]]\ncull_distances = [[1, 2, 3, 4]]\n"),
            "a.toml:7:18: 5 clip_distances and 4 cull_distances a position are too many\n"
            "  hint: up to 8 together\n");
  EXPECT_EQ(errors_of(two + "clip_distances = [1, true]\n"),
            "a.toml:6:22: clip_distances must be a number, not a boolean\n");
}

TEST(BadDraw, Varyings) {
  const std::string declared = "varyings.c = { components = 2 }\n";
  EXPECT_EQ(errors_of(declared + kDraw),
            "a.toml:5:1: draw lacks the varying \"c\"\n"
            "  hint: give one value for each position in [draw.varyings]\n");
  EXPECT_EQ(errors_of(declared + kDraw + "varyings.c = [[1, 2], [3, 4]]\n"),
            "a.toml:7:14: varying \"c\" has 2 values for 1 positions\n");
  EXPECT_EQ(errors_of(declared + kDraw + "varyings.c = [[1, 2, 3]]\n"),
            "a.toml:7:15: varying \"c\" has 2 components, not 3\n");
  EXPECT_EQ(errors_of(declared + kDraw + "varyings.c = [1]\n"),
            "a.toml:7:15: varying \"c\" has 2 components, not 1\n");
  EXPECT_EQ(errors_of(declared + kDraw + "varyings = { c = [[1, 2]], colour = [1] }\n"),
            "a.toml:7:28: unknown varying \"colour\"\n  hint: declared: c\n");
  EXPECT_EQ(errors_of(kDraw + "varyings.c = [1]\n"),
            "a.toml:6:10: unknown varying \"c\"\n  hint: declare it in [varyings]\n");
  EXPECT_EQ(errors_of("varyings.c = 'flat'\n" + kDraw + "varyings.c = [[1, 2, 3, 4, 5]]\n"),
            "a.toml:7:15: varying \"c\" must have 1 to 4 components, not 5\n");
  EXPECT_EQ(errors_of("varyings.c = 'flat'\n" + kDraw),
            "a.toml:4:10: varying \"c\" has no vertex to take its number of components from\n"
            "  hint: give its values in [draw.varyings], or write { components = 1, interpolation = \"smooth\" }\n"
            "a.toml:5:1: draw lacks the varying \"c\"\n"
            "  hint: give one value for each position in [draw.varyings]\n");
}

}  // namespace
}  // namespace fillrule::format
