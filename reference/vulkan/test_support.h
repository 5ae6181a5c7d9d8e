// What the tests of the Vulkan reference share: a reference under validation, and small cases. Positions are in
// framebuffer coordinates (pixels) of a square viewport that covers the target.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "reference/vulkan/reference.h"

namespace fillrule::vulkan {

// The program that the harness draws with.
Program varyings_program();

// Lavapipe under the validation layers, with the program `varyings`.
Options validated_options();

// A reference of these options; fails the test and throws where there is none.
Reference create_or_throw(const Options& options);

// The reference that the tests share, since an instance under validation takes its time.
Reference& shared_reference();

// The drivers that tests go over, and the shared reference of one: null where it is not installed. Lavapipe must be
// there; SwiftShader is what ci/swiftshader fetches.
inline constexpr std::array kDrivers = {"lavapipe", "swiftshader"};
Reference* shared_reference_of(const std::string& driver);

// A test on one of the drivers; skipped where it is missing.
class OnEachDriver : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override;
  [[nodiscard]] Reference& reference() const { return *reference_; }
  // The error is what the device lacks, for the test to skip; every other one fails the test.
  [[nodiscard]] Result<Planes> draw(const Case& drawn) const;

 private:
  Reference* reference_ = nullptr;
};

// Draws one case with the shared reference. Fails the test on an error and on any validation message.
Planes draw_one(const Case& drawn);
Planes draw_one(Reference& reference, const Case& drawn);
void expect_no_messages(const Reference& reference);

// Clip-space position, w = 1, of a position in a viewport of `size` x `size` pixels.
ClipPosition at(uint32_t size, float x, float y, float z = 0.5F);

// A case without draws, `size` x `size` pixels.
Case empty_case(uint32_t size, std::vector<Varying> varyings = {});

// A draw whose viewport and scissor are the case's target.
Draw draw_of(const Case& drawn, std::vector<ClipPosition> positions, std::vector<float> varyings = {});

// Index of a pixel in a plane.
size_t pixel(const Planes& planes, uint32_t x, uint32_t y);

// Equal to the byte, NaN included.
bool same_bytes(const Planes& a, const Planes& b);

}  // namespace fillrule::vulkan
