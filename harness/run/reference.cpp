#include "harness/run/reference.h"

#include "harness/programs/glsl.h"

namespace fillrule::run {

Result<vulkan::Reference> open_device(const std::string& driver, const std::vector<std::string>& driver_files,
                                      bool validation) {
  return vulkan::Reference::create({.driver = driver,
                                    .driver_files = driver_files,
                                    .program = {.vertex_glsl = programs::varyings_vertex_glsl(),
                                                .fragment_glsl = programs::varyings_fragment_glsl()},
                                    .validation = validation});
}

}  // namespace fillrule::run
