#include "reference/vulkan/test_support.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

namespace fillrule::vulkan {
namespace {

std::string read_program(const std::string& name) {
  std::ifstream file(FILLRULE_SOURCE_DIR "/harness/programs/" + name);
  if (!file) throw std::runtime_error("cannot read " + name);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

template <typename T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

}  // namespace

Program varyings_program() {
  return {.vertex_glsl = read_program("varyings.vert"), .fragment_glsl = read_program("varyings.frag")};
}

Options validated_options() {
  return {.program = varyings_program(), .validation = true};
}

Reference create_or_throw(const Options& options) {
  Result<Reference> reference = Reference::create(options);
  if (!reference) {
    ADD_FAILURE() << to_string(reference.error());
    throw std::runtime_error("no reference");
  }
  return std::move(*reference);
}

Reference& shared_reference() {
  // Never destroyed, so that the libraries stay loaded and the leak sanitizer can tell their memory from ours.
  static Reference* const reference = std::make_unique<Reference>(create_or_throw(validated_options())).release();
  return *reference;
}

Reference* shared_reference_of(const std::string& driver) {
  if (driver == "lavapipe") return &shared_reference();
  static Reference* const swiftshader = []() -> Reference* {
    const std::string manifest = FILLRULE_SOURCE_DIR "/build/swiftshader/vk_swiftshader_icd.json";
    if (!std::filesystem::exists(manifest)) return nullptr;
    Options options = validated_options();
    options.driver = "swiftshader";
    options.driver_files = {manifest};
    return std::make_unique<Reference>(create_or_throw(options)).release();
  }();
  return swiftshader;
}

void OnEachDriver::SetUp() {
  reference_ = shared_reference_of(GetParam());
  if (reference_ == nullptr) GTEST_SKIP() << "SwiftShader is not here; ci/swiftshader fetches it";
}

Result<Planes> OnEachDriver::draw(const Case& drawn) const {
  const Case* const pointer = &drawn;
  std::vector<Result<Planes>> results = reference().draw(std::span(&pointer, 1));
  expect_no_messages(reference());
  const bool is_able = features_of(drawn).without(reference().device().features).empty();
  if (!results.front() && is_able) ADD_FAILURE() << to_string(results.front().error());
  return std::move(results.front());
}

Planes draw_one(const Case& drawn) {
  return draw_one(shared_reference(), drawn);
}

Planes draw_one(Reference& reference, const Case& drawn) {
  const Case* const pointer = &drawn;
  std::vector<Result<Planes>> results = reference.draw(std::span(&pointer, 1));
  expect_no_messages(reference);
  if (!results.front()) {
    ADD_FAILURE() << to_string(results.front().error());
    throw std::runtime_error("not drawn");
  }
  return std::move(*results.front());
}

void expect_no_messages(const Reference& reference) {
  for (const std::string& message : reference.validation_messages()) ADD_FAILURE() << message;
}

ClipPosition at(uint32_t size, float x, float y, float z) {
  const float half = static_cast<float>(size) / 2;
  return {x / half - 1.0F, y / half - 1.0F, z, 1.0F};
}

Case empty_case(uint32_t size, std::vector<Varying> varyings) {
  return {.name = "test", .target = {.width = size, .height = size}, .varyings = std::move(varyings)};
}

Draw draw_of(const Case& drawn, std::vector<ClipPosition> positions, std::vector<float> varyings) {
  const Target& target = drawn.target;
  Draw draw{.positions = std::move(positions), .varyings = std::move(varyings)};
  draw.state.viewport = {.width = static_cast<float>(target.width),
                         .height = static_cast<float>(target.height),
                         .minDepth = 0.0F,
                         .maxDepth = 1.0F};
  draw.state.scissor = {.extent = {target.width, target.height}};
  return draw;
}

size_t pixel(const Planes& planes, uint32_t x, uint32_t y) {
  return size_t{y} * planes.width + x;
}

bool same_bytes(const Planes& a, const Planes& b) {
  if (a.width != b.width || a.height != b.height || a.varyings.size() != b.varyings.size()) return false;
  for (size_t i = 0; i < a.varyings.size(); ++i) {
    if (!same_bytes(a.varyings[i], b.varyings[i])) return false;
  }
  return same_bytes(a.hits, b.hits) && same_bytes(a.owner, b.owner) && same_bytes(a.front_facing, b.front_facing) &&
         same_bytes(a.depth, b.depth);
}

}  // namespace fillrule::vulkan
