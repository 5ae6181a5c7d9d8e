// The GLSL side of the programs, embedded at build time from the .vert and .frag files beside this one.
#pragma once

#include <string>

namespace fillrule::programs {

std::string varyings_vertex_glsl();
std::string varyings_fragment_glsl();

std::string shaded_vertex_glsl();
std::string shaded_fragment_glsl();

}  // namespace fillrule::programs
