// One bad file a test, with the exact text of its error.
#include <gtest/gtest.h>

#include <filesystem>

#include "cases/format/test_files.h"

namespace fillrule::format {
namespace {

TEST(BadFile, Missing) {
  const CaseFile file = read_file("no/such/file.toml", "x");
  ASSERT_EQ(file.errors.size(), 1U);
  EXPECT_EQ(to_string(file.errors[0]), "no/such/file.toml: cannot be read: No such file or directory");
}

TEST(BadFile, Folder) {
  const std::string folder = std::filesystem::temp_directory_path().generic_string();
  const CaseFile file = read_file(folder, "x");
  ASSERT_EQ(file.errors.size(), 1U);
  EXPECT_EQ(to_string(file.errors[0]), folder + ": cannot be read: Is a directory");
}

TEST(BadFile, Empty) {
  std::string text;
  for (const Error& error : parse("", "a.toml", "a").errors) text += to_string(error) + '\n';
  EXPECT_EQ(text,
            "a.toml:1:1: missing key \"title\"\n  hint: say what is drawn: title = \"...\"\n"
            "a.toml:1:1: missing key \"why\"\n  hint: say what a failure would mean: why = \"...\"\n"
            "a.toml:1:1: missing key \"spec\"\n"
            "  hint: name the section of the Vulkan specification: spec = \"...\"\n"
            "a.toml:1:1: the case draws nothing\n  hint: add a [[draw]] with positions\n");
}

TEST(BadFile, TomlSyntax) {
  EXPECT_EQ(errors_of("tags = [1, 2\n"), "a.toml:4:14: Error while parsing array: encountered end-of-file\n");
  EXPECT_EQ(errors_of("title = 'again'\n"),
            "a.toml:4:9: Error while parsing key-value pair: cannot redefine existing string 'title'\n");
}

TEST(BadHead, UnknownKey) {
  EXPECT_EQ(errors_with_draw("titel = 'x'\n"),
            "a.toml:4:1: unknown key \"titel\" in the case file\n  hint: did you mean \"title\"?\n");
  EXPECT_EQ(errors_with_draw("blue = 'x'\n"),
            "a.toml:4:1: unknown key \"blue\" in the case file\n  hint: known keys: title, why, spec, origin, tags, "
            "control, expect, opt_out, target, state, varyings, let, sweep, draw, scene\n");
}

TEST(BadHead, OptOuts) {
  EXPECT_EQ(errors_with_draw("[opt_out]\nrotated = 'x'\nsecond_run = 3\nscissor_crop = ' '\n"),
            "a.toml:5:1: there is no check \"rotated\"\n  hint: the checks are: second_run, any_number_of_threads, "
            "rotated_vertices, flipped_winding, scaled_clip_space, scissor_crop, partition\n"
            "a.toml:6:14: second_run must be a string, the reason, not an integer\n"
            "a.toml:7:16: scissor_crop is empty\n  hint: give the reason why the check does not fit this case\n");
}

TEST(BadHead, WrongTypes) {
  EXPECT_EQ(errors_with_draw("origin = 3\ntags = 'x'\n"),
            "a.toml:4:10: origin must be a string, not an integer\n"
            "a.toml:5:8: tags must be an array of strings, not a string\n");
  EXPECT_EQ(errors_with_draw("tags = [1979-05-27]\n"), "a.toml:4:9: a tag must be a string, not a date or time\n");
}

TEST(BadHead, BlankTitle) {
  const CaseFile file = parse("title = ' '\nwhy = 'w'\nspec = 's'\n" + kDraw, "a.toml", "a");
  ASSERT_EQ(file.errors.size(), 1U);
  EXPECT_EQ(to_string(file.errors[0]), "a.toml:1:9: title is empty\n  hint: say what is drawn: title = \"...\"");
}

TEST(BadTarget, Size) {
  EXPECT_EQ(errors_with_draw("target.size = [0, 64]\n"), "a.toml:4:16: width must be 1 to 16384, not 0\n");
  EXPECT_EQ(errors_with_draw("target.size = [64, 16385]\n"), "a.toml:4:20: height must be 1 to 16384, not 16385\n");
  EXPECT_EQ(errors_with_draw("target.size = [nan, 6.5]\n"),
            "a.toml:4:16: width must be a whole number, not nan\n"
            "a.toml:4:21: height must be a whole number, not 6.5\n");
  EXPECT_EQ(errors_with_draw("target.size = [64]\n"), "a.toml:4:15: size must be [width, height], not 1 numbers\n");
  EXPECT_EQ(errors_with_draw("target.size = 64\n"), "a.toml:4:15: size must be [width, height], not an integer\n");
  EXPECT_EQ(errors_with_draw("target = 64\n"), "a.toml:4:10: target must be a table, not an integer\n");
}

TEST(BadTarget, UnknownKey) {
  EXPECT_EQ(errors_with_draw("target.sizes = 1\n"),
            "a.toml:4:8: unknown key \"sizes\" in [target]\n  hint: did you mean \"size\"?\n");
}

TEST(BadTarget, DepthFormat) {
  EXPECT_EQ(errors_with_draw("target.depth_format = 's8_uint'\n"),
            "a.toml:4:23: depth_format \"s8_uint\" is not supported\n"
            "  hint: supported: none, d16_unorm, x8_d24_unorm_pack32, d32_sfloat\n");
  EXPECT_EQ(errors_with_draw("target.depth_format = 'd32'\n"),
            "a.toml:4:23: unknown depth_format \"d32\"\n"
            "  hint: supported: none, d16_unorm, x8_d24_unorm_pack32, d32_sfloat\n");
  EXPECT_EQ(errors_with_draw("target.depth_format = true\n"),
            "a.toml:4:23: depth_format must be a string, not a boolean\n");
}

TEST(BadTarget, Samples) {
  EXPECT_EQ(errors_with_draw("target.samples = 3\n"),
            "a.toml:4:18: samples must be a power of two, not 3\n  hint: supported: 1, 2, 4, 8, 16\n");
  EXPECT_EQ(errors_with_draw("target.samples = 0\n"), "a.toml:4:18: samples must be 1 to 16, not 0\n");
}

TEST(BadTarget, ClearDepth) {
  EXPECT_EQ(errors_with_draw("target.clear_depth = 1.5\n"), "a.toml:4:22: clear_depth must be 0 to 1, not 1.5\n");
  EXPECT_EQ(errors_with_draw("target.clear_depth = nan\n"), "a.toml:4:22: clear_depth must be finite, not nan\n");
  EXPECT_EQ(errors_with_draw("target.clear_depth = []\n"),
            "a.toml:4:22: clear_depth must be a number, not an array\n");
}

TEST(BadState, UnknownKeyAndTypes) {
  EXPECT_EQ(errors_with_draw("state.cullmode = 'back'\n"),
            "a.toml:4:7: unknown key \"cullmode\" in [state]\n  hint: did you mean \"cull_mode\"?\n");
  EXPECT_EQ(errors_with_draw("state = 1\n"), "a.toml:4:9: state must be a table, not an integer\n");
  EXPECT_EQ(errors_with_draw("state.depth_test = 1\n"),
            "a.toml:4:20: depth_test must be true or false, not an integer\n");
  EXPECT_EQ(errors_with_draw("state.depth_write = 'yes'\n"),
            "a.toml:4:21: depth_write must be true or false, not \"yes\"\n");
}

TEST(BadState, Enumerators) {
  EXPECT_EQ(errors_with_draw("state.cull_mode = 'bck'\n"),
            "a.toml:4:19: unknown cull_mode \"bck\"\n  hint: did you mean \"back\"?\n");
  EXPECT_EQ(errors_with_draw("state.front_face = 'ccw'\n"),
            "a.toml:4:20: unknown front_face \"ccw\"\n  hint: known: counter_clockwise, clockwise\n");
  EXPECT_EQ(errors_with_draw("state.depth_compare = 'les_or_equal'\n"),
            "a.toml:4:23: unknown depth_compare \"les_or_equal\"\n  hint: did you mean \"less_or_equal\"?\n");
}

TEST(BadState, Viewport) {
  EXPECT_EQ(errors_with_draw("state.viewport = [0, 0]\n"), "a.toml:4:18: viewport must be a table, not an array\n");
  EXPECT_EQ(errors_with_draw("state.viewport.widht = 1\n"),
            "a.toml:4:16: unknown key \"widht\" in viewport\n  hint: did you mean \"width\"?\n");
  EXPECT_EQ(errors_with_draw("state.viewport.width = 0\n"),
            "a.toml:4:24: viewport width must be above 0 and up to 16384, not 0\n");
  EXPECT_EQ(errors_with_draw("state.viewport.height = 0\n"),
            "a.toml:4:25: viewport height must be nonzero, from -16384 to 16384, not 0\n");
  EXPECT_EQ(errors_with_draw("state.viewport.width = -1\n"),
            "a.toml:4:24: viewport width must be above 0 and up to 16384, not -1\n");
  EXPECT_EQ(errors_with_draw("state.viewport.width = 16385\n"),
            "a.toml:4:24: viewport width must be above 0 and up to 16384, not 16385\n");
  EXPECT_EQ(errors_with_draw("state.viewport.x = nan\n"), "a.toml:4:20: viewport x must be finite, not nan\n");
  EXPECT_EQ(errors_with_draw("state.viewport.max_depth = 1.5\n"),
            "a.toml:4:28: viewport max_depth must be 0 to 1, not 1.5\n");
  EXPECT_EQ(errors_with_draw("state.viewport = { x = 32700, width = 100 }\n"),
            "a.toml:4:18: viewport reaches from x = 32700 to 32800\n"
            "  hint: Vulkan's bounds are -32768 to 32767\n");
  EXPECT_EQ(errors_with_draw("state.viewport = { y = -32700, height = -100 }\n"),
            "a.toml:4:18: viewport reaches from y = -32700 to -32800\n"
            "  hint: Vulkan's bounds are -32768 to 32767\n");
}

TEST(BadState, Scissor) {
  EXPECT_EQ(errors_with_draw("state.scissor.x = -1\n"), "a.toml:4:19: scissor x must be 0 to 2147483647, not -1\n");
  EXPECT_EQ(errors_with_draw("state.scissor.y = 0.5\n"), "a.toml:4:19: scissor y must be a whole number, not 0.5\n");
  EXPECT_EQ(errors_with_draw("state.scissor = { x = 2147483647, width = 1 }\n"),
            "a.toml:4:17: scissor ends beyond the range of int32\n"
            "  hint: Vulkan demands x + width and y + height up to 2147483647\n");
  EXPECT_EQ(errors_with_draw("state.scissor.w = 1\n"),
            "a.toml:4:15: unknown key \"w\" in scissor\n  hint: known keys: x, y, width, height\n");
}

TEST(BadState, Depth) {
  EXPECT_EQ(errors_with_draw("state.depth_bias = 1\n"), "a.toml:4:20: depth_bias must be a table, not an integer\n");
  EXPECT_EQ(errors_with_draw("state.depth_bias.slop = 1\n"),
            "a.toml:4:18: unknown key \"slop\" in depth_bias\n  hint: did you mean \"slope\"?\n");
  EXPECT_EQ(errors_with_draw("state.depth_bias = { constant = inf, slope = nan, clamp = 'x' }\n"),
            "a.toml:4:33: depth_bias constant must be finite, not inf\n"
            "a.toml:4:46: depth_bias slope must be finite, not nan\n"
            "a.toml:4:59: unknown name \"x\" in expression \"x\"\n"
            "  hint: known names: pi, abs, acos, acosh, asin, asinh, atan, atan2, atanh, avg, ceil, cos, cosh, exp, "
            "floor, ln, log, log10, log2, max, min, mod, random, rint, sign, sin, sinh, sqrt, sum, tan, tanh, ulp\n");
  EXPECT_EQ(errors_with_draw("state.depth_bounds = true\n"),
            "a.toml:4:22: depth_bounds must be a table, not a boolean\n");
  EXPECT_EQ(errors_with_draw("state.depth_bounds.near = 1\n"),
            "a.toml:4:20: unknown key \"near\" in depth_bounds\n  hint: known keys: min, max\n");
  EXPECT_EQ(errors_with_draw("state.depth_bounds = { min = -0.5, max = 1.5 }\n"),
            "a.toml:4:30: depth_bounds min must be 0 to 1, not -0.5\n"
            "a.toml:4:42: depth_bounds max must be 0 to 1, not 1.5\n");
  EXPECT_EQ(errors_with_draw("state.depth_bounds = { min = 0.5, max = 0.25 }\n"),
            "a.toml:4:22: depth_bounds: min 0.5 is above max 0.25\n  hint: no fragment could pass\n");
  EXPECT_EQ(errors_with_draw("state = { depth_clamp = 1, depth_clip = 'no', negative_one_to_one = 1.0 }\n"),
            "a.toml:4:25: depth_clamp must be true or false, not an integer\n"
            "a.toml:4:41: depth_clip must be true or false, not \"no\"\n"
            "a.toml:4:69: negative_one_to_one must be true or false, not a float\n");
}

TEST(BadState, LinesAndSamples) {
  EXPECT_EQ(errors_with_draw("state.polygon_mode = 'lines'\n"),
            "a.toml:4:22: unknown polygon_mode \"lines\"\n  hint: did you mean \"line\"?\n");
  EXPECT_EQ(errors_with_draw("state.line_mode = 'smooth'\n"),
            "a.toml:4:19: unknown line_mode \"smooth\"\n  hint: known: rectangular, bresenham\n");
  EXPECT_EQ(errors_with_draw("state.provoking_vertex = 'lst'\n"),
            "a.toml:4:26: unknown provoking_vertex \"lst\"\n  hint: did you mean \"last\"?\n");
  EXPECT_EQ(errors_with_draw("state.line_width = 0\n"), "a.toml:4:20: line_width must be above 0, not 0\n");
  EXPECT_EQ(errors_with_draw("state.line_width = inf\n"), "a.toml:4:20: line_width must be finite, not inf\n");
  EXPECT_EQ(errors_with_draw("state.sample_mask = -1\n"),
            "a.toml:4:21: sample_mask must be 0 to 4294967295, not -1\n");
}

TEST(BadNumber, Float32) {
  EXPECT_EQ(errors_of("[[draw]]\npositions = [[1e39, 0, 0, 1]]\n"),
            "a.toml:5:15: coordinate = 1e+39 is beyond float32\n  hint: write inf if infinity is meant\n");
  EXPECT_EQ(errors_of("[[draw]]\nspace = 'ndc'\npositions = [[1e30, 0, 0, 1e30]]\n"),
            "a.toml:6:14: clip-space coordinate 1.0000000000000001e+60 is beyond float32\n  hint: write inf if "
            "infinity is meant\n");
  EXPECT_EQ(errors_of("[[draw]]\npositions = [['0x1.8q', 0, 0, 'bits:12']]\n"),
            "a.toml:5:15: malformed hexadecimal float \"0x1.8q\"\n"
            "  hint: write it as in C, for example \"0x1.8p-3\" = 0.1875\n"
            "a.toml:5:31: malformed float32 bits \"bits:12\"\n"
            "  hint: write up to 8 hexadecimal digits, for example \"bits:0x7fc00001\"\n");
}

TEST(BadNumber, Expressions) {
  const auto in_position = [](const std::string& expression) {
    return errors_of("sweep = { angle = [1], cull = ['back'] }\n[[draw]]\npositions = [['" + expression +
                     "', 0, 0, 1]]\n");
  };
  EXPECT_EQ(in_position("cos(angel)"),
            "a.toml:6:15: unknown name \"angel\" in expression \"cos(angel)\"\n  hint: did you mean \"angle\"?\n");
  EXPECT_EQ(
      in_position("zebra"),
      "a.toml:6:15: unknown name \"zebra\" in expression \"zebra\"\n"
      "  hint: known names: angle, pi, abs, acos, acosh, asin, asinh, atan, atan2, atanh, avg, ceil, cos, cosh, "
      "exp, floor, ln, log, log10, log2, max, min, mod, random, rint, sign, sin, sinh, sqrt, sum, tan, tanh, "
      "ulp\n");
  EXPECT_EQ(in_position("cull + 1"),
            "a.toml:6:15: variable \"cull\" is text, not a number, in \"cull + 1\"\n"
            "  hint: text variables stand alone where text is expected: \"$cull\"\n");
  EXPECT_EQ(in_position("$angle"),
            "a.toml:6:15: coordinate must be a number, not \"$angle\"\n"
            "  hint: numeric variables are written without $: \"angle\"\n");
  EXPECT_EQ(in_position("sin("), "a.toml:6:15: expression \"sin(\": Unexpected end of expression at position 5\n");
  EXPECT_EQ(in_position(""), "a.toml:6:15: expression \"\": Expression is empty\n");
  EXPECT_EQ(in_position("1,5"),
            "a.toml:6:15: expression \"1,5\" has several values\n  hint: the decimal separator is a point\n");
  EXPECT_EQ(in_position("angle = 2"),
            "a.toml:6:15: expression \"angle = 2\": a variable cannot be assigned to\n  hint: compare with ==\n");
  EXPECT_EQ(in_position("1 / 0"),
            "a.toml:6:15: expression \"1 / 0\" is infinite\n  hint: write nan or inf if that is meant\n");
  EXPECT_EQ(in_position("sqrt(-angle)"),
            "a.toml:6:15: expression \"sqrt(-angle)\" is not a number\n  hint: write nan or inf if that is meant\n");
}

TEST(BadNumber, TextVariable) {
  EXPECT_EQ(errors_with_draw("sweep.cull = ['back']\nstate.cull_mode = '$cul'\n"),
            "a.toml:5:19: unknown variable \"cul\" in \"$cul\"\n  hint: did you mean \"cull\"?\n");
  EXPECT_EQ(errors_with_draw("sweep.cull = [1]\nstate.cull_mode = '$cull'\n"),
            "a.toml:5:19: variable \"cull\" is a number, not text\n  hint: $ takes the text variables of [sweep]\n");
}

TEST(BadSweep, Values) {
  EXPECT_EQ(errors_with_draw("sweep.a = 3\n"),
            "a.toml:4:11: sweep variable \"a\" must be a list or a range, not an integer\n"
            "  hint: for example [0, 15] or { from = 0, to = 90, step = 15 }\n");
  EXPECT_EQ(errors_with_draw("sweep.a = []\n"), "a.toml:4:11: sweep variable \"a\" has no values\n");
  EXPECT_EQ(errors_with_draw("sweep.a = [1, 2, 1]\n"),
            "a.toml:4:18: sweep variable \"a\" has the value 1 twice\n  hint: cases would have one name\n");
  EXPECT_EQ(errors_with_draw("sweep.a = [1, 'back']\n"),
            "a.toml:4:11: sweep variable \"a\" mixes numbers and text\n");
  EXPECT_EQ(errors_with_draw("sweep.a = ['1 +']\n"),
            "a.toml:4:12: expression \"1 +\": Unexpected end of expression at position 4\n");
  EXPECT_EQ(errors_with_draw("sweep = 1\n"), "a.toml:4:9: sweep must be a table, not an integer\n");
}

TEST(BadSweep, Names) {
  EXPECT_EQ(errors_with_draw("sweep.sin = [1]\n"),
            "a.toml:4:7: \"sin\" is taken by expressions\n  hint: choose another name\n");
  EXPECT_EQ(errors_with_draw("sweep.'1a' = [1]\n"),
            "a.toml:4:7: \"1a\" is not a variable name\n"
            "  hint: a name has letters, digits and _, and does not begin with a digit\n");
}

TEST(BadSweep, Range) {
  EXPECT_EQ(errors_with_draw("sweep.a = { from = 0, to = 1 }\n"),
            "a.toml:4:11: sweep variable \"a\" lacks \"step\"\n  hint: write { from = 0, to = 90, step = 15 }\n");
  EXPECT_EQ(errors_with_draw("sweep.a = { from = 0, to = 1, step = 0 }\n"),
            "a.toml:4:11: sweep variable \"a\" never gets from 0 to 1 by steps of 0\n");
  EXPECT_EQ(errors_with_draw("sweep.a = { from = 0, to = 1, step = -1 }\n"),
            "a.toml:4:11: sweep variable \"a\" never gets from 0 to 1 by steps of -1\n");
  EXPECT_EQ(errors_with_draw("sweep.a = { from = nan, to = 1, step = 1 }\n"),
            "a.toml:4:20: from must be finite, not nan\n");
  EXPECT_EQ(errors_with_draw("sweep.a = { from = 0, to = 1, by = 1, step = 1 }\n"),
            "a.toml:4:31: unknown key \"by\" in sweep variable \"a\"\n  hint: known keys: from, to, step\n");
}

TEST(BadSweep, TooLarge) {
  const std::string error = "sweep makes too many cases\n  hint: a file expands to at most 65536\n";
  EXPECT_EQ(errors_with_draw("[sweep]\na = { from = 1, to = 65537, step = 1 }\n"), "a.toml:4:1: " + error);
  EXPECT_EQ(errors_with_draw("[sweep]\na = { from = 0, to = 1e300, step = 1e-300 }\n"), "a.toml:4:1: " + error);
  EXPECT_EQ(errors_with_draw("[sweep]\na = { from = 1, to = 257, step = 1 }\nb = { from = 1, to = 256, step = 1 }\n"),
            "a.toml:4:1: " + error);
}

TEST(BadSweep, ErrorOfALaterCaseNamesIt) {
  EXPECT_EQ(errors_of("sweep.a = [1, 2, 3]\n[[draw]]\npositions = [['1 / (a - 2)', 0, 0, 1]]\n"),
            "a.toml:6:15: expression \"1 / (a - 2)\" is infinite (in case [a=2])\n"
            "  hint: write nan or inf if that is meant\n");
}

TEST(BadLet, NamesAndExpressions) {
  EXPECT_EQ(errors_with_draw("sweep.a = [1]\nlet.a = 2\n"),
            "a.toml:5:5: variable \"a\" is defined already\n  hint: choose another name\n");
  EXPECT_EQ(errors_with_draw("let = 2\n"), "a.toml:4:7: let must be a table, not an integer\n");
  // What is wrong in [let] is not wrong again wherever it is used; a later variable is not known to an earlier one.
  EXPECT_EQ(errors_of("let.a = 'b + 1'\nlet.b = 1\n[[draw]]\npositions = [['a', 0, 0, 1]]\n"),
            "a.toml:4:9: unknown name \"b\" in expression \"b + 1\"\n"
            "  hint: known names: pi, abs, acos, acosh, asin, asinh, atan, atan2, atanh, avg, ceil, cos, cosh, "
            "exp, floor, ln, log, log10, log2, max, min, mod, random, rint, sign, sin, sinh, sqrt, sum, tan, tanh, "
            "ulp\n");
}

TEST(BadRepeat, NamesAndCounts) {
  EXPECT_EQ(errors_of(kDraw + "repeat = 3\n"), "a.toml:6:10: repeat must be a table, not an integer\n");
  EXPECT_EQ(errors_of(kDraw + "repeat = { i = 0 }\n"), "a.toml:6:16: repeat i must be 1 to 4194304, not 0\n");
  EXPECT_EQ(errors_of(kDraw + "repeat = { pi = 2 }\n"),
            "a.toml:6:12: \"pi\" is taken by expressions\n  hint: choose another name\n");
  EXPECT_EQ(errors_of(kDraw + "repeat = { i = 4000, j = 4000 }\n"),
            "a.toml:6:10: repeat makes too many vertices\n  hint: at most 4194304 copies of this draw fit\n");
  // The variables end with their draw.
  EXPECT_TRUE(errors_of(kDraw + "repeat = { i = 2 }\n[[draw]]\npositions = [['i', 0, 0, 1]]\n")
                  .starts_with("a.toml:8:15: unknown name \"i\" in expression \"i\"\n"));
}

TEST(BadFile, ManyErrorsAreAllReportedInTheOrderOfTheFile) {
  EXPECT_EQ(errors_of("target.size = [0, 1]\nstate.cull_mode = 1\n[[draw]]\nfoo = 1\n" + kDraw + "bar = 1\n"),
            "a.toml:4:16: width must be 1 to 16384, not 0\n"
            "a.toml:5:19: cull_mode must be a string, not an integer\n"
            "a.toml:6:1: draw has no positions\n  hint: positions = [[x, y, z, w], ...]\n"
            "a.toml:7:1: unknown key \"foo\" in [[draw]]\n"
            "  hint: known keys: topology, space, positions, indices, index_type, vertex_offset, primitive_restart, "
            "point_sizes, "
            "clip_distances, cull_distances, repeat, varyings, state\n"
            "a.toml:10:1: unknown key \"bar\" in [[draw]]\n"
            "  hint: known keys: topology, space, positions, indices, index_type, vertex_offset, primitive_restart, "
            "point_sizes, "
            "clip_distances, cull_distances, repeat, varyings, state\n");
}

}  // namespace
}  // namespace fillrule::format
