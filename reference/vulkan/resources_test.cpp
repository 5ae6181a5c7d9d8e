// Programs that read uniforms and a texture.
#include "reference/vulkan/resources.h"

#include <gmock/gmock.h>

#include "reference/vulkan/test_support.h"

namespace fillrule::vulkan {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// The texel at the varying, times a factor, and 1 more with each variant.
Program factor_program() {
  Program program = varyings_program();
  program.uniform_bytes = 16;
  program.fragment_glsl = R"(#version 450
layout(set = 0, binding = 0, std140) readonly buffer Factor { vec4 factor; };
layout(set = 0, binding = 1) uniform sampler2D image;
layout(location = 0) out float hits;
layout(location = 1) out uint owner;
#define DECLARE(i, qualifiers) \
  layout(location = i) qualifiers in vec4 in_##i; layout(location = 2 + i) out vec4 out_##i;
#define SAMPLE(i, qualifiers) \
  out_##i = factor * textureLod(image, in_##i.xy, in_##i.z) + float(VARIANT);
INTERPOLATED(DECLARE)
void main() {
  hits = 1.0;
  owner = 1u + uint(gl_PrimitiveID);
  INTERPOLATED(SAMPLE)
}
)";
  return program;
}

Reference& factor_reference() {
  static Reference reference = [] {
    Options options = validated_options();
    options.program = factor_program();
    return create_or_throw(options);
  }();
  return reference;
}

// The whole target of 4 x 4 pixels with one value of the varying.
Case constant_case(const std::vector<std::array<float, 4>>& values) {
  Case one = empty_case(4, {{.name = "v", .components = 4}});
  for (const auto& v : values) {
    std::vector<float> varyings;
    for (int i = 0; i < 3; ++i) varyings.insert(varyings.end(), v.begin(), v.end());
    one.draws.push_back(draw_of(one, {at(4, 0, 0), at(4, 8, 0), at(4, 0, 8)}, varyings));
  }
  return one;
}

std::shared_ptr<const Texture> two_texels(Mipmaps mipmaps = Mipmaps::kNone) {
  Texture texture{.levels = {{.width = 2, .height = 1, .texels = {{1, 2, 3, 4}, {5, 6, 7, 8}}}},
                  .sampling = {.filter = VK_FILTER_NEAREST, .mipmaps = mipmaps}};
  if (mipmaps != Mipmaps::kNone) texture.levels.push_back({.width = 1, .height = 1, .texels = {{9, 9, 9, 9}}});
  return std::make_shared<const Texture>(std::move(texture));
}

DrawResources resources_with(const std::array<float, 4>& factor, std::shared_ptr<const Texture> texture = nullptr) {
  return {.uniforms = std::as_bytes(std::span(factor)), .texture = std::move(texture)};
}

constexpr std::array<float, 4> kOnce{1, 1, 1, 1};
constexpr std::array<float, 4> kTwice{2, 2, 2, 2};

TEST(Resources, AreReadByEachDrawForItself) {
  // The second draw covers the first.
  const Case one = constant_case({{0.25F, 0.5F, 0, 0}, {0.75F, 0.5F, 0, 0}});
  const std::array resources{resources_with(kOnce), resources_with(kTwice, two_texels())};
  const Result<Planes> planes = factor_reference().draw(one, resources);
  ASSERT_TRUE(planes) << to_string(planes.error());
  EXPECT_THAT(planes->hits, Each(2U));
  EXPECT_THAT(planes->varyings[0], Each(10.0F));
  EXPECT_THAT(planes->varyings[3], Each(16.0F));
  expect_no_messages(factor_reference());
}

TEST(Resources, AreAWhiteTexelWithoutATexture) {
  const Result<Planes> planes =
      factor_reference().draw(constant_case({{0.25F, 0.5F, 0, 0}}), std::array{resources_with(kTwice)});
  ASSERT_TRUE(planes) << to_string(planes.error());
  EXPECT_THAT(planes->varyings[1], Each(2.0F));
}

TEST(Resources, HaveAllLevels) {
  const Result<Planes> planes = factor_reference().draw(
      constant_case({{0.25F, 0.5F, 1, 0}}), std::array{resources_with(kOnce, two_texels(Mipmaps::kNearest))});
  ASSERT_TRUE(planes) << to_string(planes.error());
  EXPECT_THAT(planes->varyings[0], Each(9.0F));
}

TEST(Resources, ChooseTheProgramsVariantForEachDraw) {
  // To the left of the second draw the first one stays.
  Case one = constant_case({{0.25F, 0.5F, 0, 0}, {0.25F, 0.5F, 0, 0}});
  one.draws[1].positions = {at(4, 2, 0), at(4, 10, 0), at(4, 2, 8)};
  std::array resources{resources_with(kOnce), resources_with(kOnce)};
  resources[1].variant = 3;
  const Result<Planes> planes = factor_reference().draw(one, resources);
  ASSERT_TRUE(planes) << to_string(planes.error());
  EXPECT_THAT(std::span(planes->varyings[0]).first(4), ElementsAre(1.0F, 1.0F, 4.0F, 4.0F));
  expect_no_messages(factor_reference());
}

TEST(Resources, MakeAColorThatIsReadBackInPlaceOfTheSlots) {
  Options options = validated_options();
  options.program = factor_program();
  options.program.draws_color = true;
  options.program.fragment_glsl = R"(#version 450
layout(set = 0, binding = 0, std140) readonly buffer Factor { vec4 factor; };
layout(set = 0, binding = 1) uniform sampler2D image;
layout(location = 0) out float hits;
layout(location = 1) out uint owner;
layout(location = 0) in vec4 in_0;
layout(location = 1) in vec4 in_1;
layout(location = 2) out vec4 color;
void main() {
  hits = 1.0;
  owner = 1u;
  color = factor * (in_0 + in_1.xyxy);
}
)";
  Reference reference = create_or_throw(options);
  for (const VkSampleCountFlagBits samples : {VK_SAMPLE_COUNT_1_BIT, VK_SAMPLE_COUNT_4_BIT}) {
    Case one = empty_case(4, {{.name = "a", .components = 3}, {.name = "b", .components = 3}});
    one.target.samples = samples;
    std::vector<float> varyings;
    for (int i = 0; i < 3; ++i) varyings.insert(varyings.end(), {1, 2, 3, 4, 50, 60});
    one.draws.push_back(draw_of(one, {at(4, 0, 0), at(4, 8, 0), at(4, 0, 8)}, varyings));
    const Result<Planes> planes = reference.draw(one, std::array{resources_with(kTwice)});
    ASSERT_TRUE(planes) << to_string(planes.error());
    EXPECT_THAT(planes->hits, Each(1U));
    EXPECT_THAT(planes->varyings, ElementsAre(Each(102.0F), Each(124.0F), Each(106.0F), Each(128.0F)));
  }
  expect_no_messages(reference);
}

TEST(Resources, ChangeBetweenDrawings) {
  for (int round = 0; round < 3; ++round) {
    const auto texture = two_texels();
    const auto planes = factor_reference().draw(constant_case({{0.25F, 0.5F, 0, 0}}),
                                                std::array{resources_with(round == 1 ? kTwice : kOnce, texture)});
    ASSERT_TRUE(planes) << to_string(planes.error());
    EXPECT_THAT(planes->varyings[0], Each(round == 1 ? 2.0F : 1.0F));
  }
  expect_no_messages(factor_reference());
}

TEST(Resources, AreRefusedWhereTheyDoNotFit) {
  const Case one = constant_case({{0.25F, 0.5F, 0, 0}});
  const auto error_of = [&](Reference& reference, std::span<const DrawResources> resources) {
    const Result<Planes> planes = reference.draw(one, resources);
    return planes ? std::string("no error") : planes.error().what;
  };
  EXPECT_THAT(error_of(factor_reference(), {}), HasSubstr("0 resources for 1 draws"));
  const std::array<float, 2> small{};
  EXPECT_THAT(error_of(factor_reference(), std::array{DrawResources{.uniforms = std::as_bytes(std::span(small))}}),
              HasSubstr("8 bytes instead of 16"));
  const auto broken = std::make_shared<const Texture>(Texture{.levels = {{.width = 2, .height = 2}}});
  EXPECT_THAT(error_of(factor_reference(), std::array{resources_with(kOnce, broken)}), HasSubstr("texels"));
  EXPECT_THAT(error_of(shared_reference(), std::array{resources_with(kOnce)}), HasSubstr("reads nothing"));
}

}  // namespace
}  // namespace fillrule::vulkan
