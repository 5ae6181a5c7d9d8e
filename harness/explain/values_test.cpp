// Where in the pixel values are evaluated, what is left open, and which sample is explained.
#include <gtest/gtest.h>

#include <cmath>

#include "harness/explain/test_support.h"

namespace fillrule::explain {
namespace {

Case four_samples(Sampling sampling) {
  Case one = upright("samples");
  one.target.samples = VK_SAMPLE_COUNT_4_BIT;
  one.varyings[0].sampling = sampling;
  return one;
}

const Value& value_named(const PartyFacts& party, const std::string& name) {
  for (const Value& value : party.values) {
    if (value.name == name) return value;
  }
  ADD_FAILURE() << "no value " << name;
  return party.values.front();
}

TEST(ExplainValues, AreTakenAtTheSampleOrWhereTheVaryingSays) {
  const SampleId third{.x = 4, .y = 5, .sample = 2};
  const Explanation at_sample = explanation_of(four_samples(Sampling::kSample), third);
  EXPECT_EQ(at_sample.samples, 4U);
  EXPECT_EQ(at_sample.position, (std::array<double, 2>{4.125, 5.625}));
  const Value& depth = value_named(at_sample.parties[0], "depth");
  EXPECT_EQ(depth.place, "at the sample");
  EXPECT_NEAR(depth.standing.expected, 0.25 + 2.125 / 48 + 3.625 / 24, 1e-9);
  const Value& sample = value_named(at_sample.parties[0], "u");
  EXPECT_EQ(sample.place, "at the sample");
  EXPECT_NEAR(sample.standing.expected, 2.125 / 12 + 2 * 3.625 / 12, 1e-9);
  ASSERT_TRUE(sample.tolerance);
  EXPECT_NEAR(sample.standing.tolerance, sample.tolerance->total(), 1e-12);

  const Explanation centre = explanation_of(four_samples(Sampling::kCenter), third);
  EXPECT_EQ(value_named(centre.parties[0], "u").place, "at the pixel's centre");
  EXPECT_NEAR(value_named(centre.parties[0], "u").standing.expected, 2.5 / 12 + 2 * 3.5 / 12, 1e-9);

  const Explanation anywhere = explanation_of(four_samples(Sampling::kCentroid), third);
  const Value& centroid = value_named(anywhere.parties[0], "u");
  EXPECT_EQ(centroid.place, "where the pixel and the primitive overlap");
  EXPECT_EQ(centroid.left_open, "the place");
  EXPECT_NEAR(centroid.standing.spread, 1.5 / 12, 1e-6);
  EXPECT_FALSE(centroid.tolerance);
}

TEST(ExplainValues, OneSampleHasOnePlace) {
  const Explanation explanation = explanation_of(upright("one"), {.x = 4, .y = 5});
  EXPECT_EQ(explanation.samples, 1U);
  EXPECT_TRUE(value_named(explanation.parties[0], "u").place.empty());
}

// Built-ins are no components of the vertices: those after them keep their own tolerances.
TEST(ExplainValues, BuiltInsComeBetween) {
  Case one = upright("built-in");
  one.varyings.insert(one.varyings.begin(), {.name = "where",
                                             .components = 4,
                                             .interpolation = Interpolation::kSmooth,
                                             .source = VaryingSource::kFragCoord});
  const Explanation explanation = explanation_of(one, {.x = 4, .y = 5});
  EXPECT_EQ(value_named(explanation.parties[0], "where.x").standing.expected, 4.5);
  EXPECT_NEAR(value_named(explanation.parties[0], "where.z").standing.expected, 0.447916667, 1e-6);
  ASSERT_TRUE(value_named(explanation.parties[0], "u").tolerance);
  EXPECT_NEAR(value_named(explanation.parties[0], "u").tolerance->snapping, 0.000489, 1e-6);
}

TEST(ExplainValues, WhatIsLeftOpenIsNamed) {
  Case one = upright("open");
  one.target.depth_format = VK_FORMAT_D16_UNORM;
  const Explanation format = explanation_of(one, {.x = 4, .y = 5});
  const Value& depth = value_named(format.parties[0], "depth");
  EXPECT_EQ(depth.left_open, "the two closest codes");
  EXPECT_NEAR(depth.standing.spread, 1.0 / 65535, 1e-7);
  ASSERT_TRUE(depth.tolerance);
  EXPECT_NEAR(depth.standing.tolerance, depth.tolerance->total() + depth.standing.spread, 1e-12);
  one.draws[0].state.depth_bias = DepthBias{.slope_factor = 1};
  const Explanation bias = explanation_of(one, {.x = 4, .y = 5});
  EXPECT_EQ(value_named(bias.parties[0], "depth").left_open, "the depth bias and the two closest codes");
  EXPECT_NE(to_text(bias).find("more, as the depth bias and the two closest codes is left open"), std::string::npos);
}

TEST(ExplainValues, NotANumberIsWrongWhereNothingElseIsKnown) {
  const std::string text = explained(upright("nan"), 10, 5, [](Planes& planes, size_t index) {
    planes.hits[index] = 1;
    planes.owner[index] = 0;
    planes.varyings[0][index] = std::nanf("");
  });
  EXPECT_NE(text.find("wrong, no finite input can give it"), std::string::npos) << text;
  EXPECT_EQ(last_line(text), "The candidate's u is nan, which no finite input can give: candidate fault.\n");
}

TEST(ExplainValues, TheGravestSampleIsExplainedUnlessOneIsNamed) {
  const Case one = four_samples(Sampling::kCenter);
  const Change third = [](Planes& planes, size_t index) { planes.depth[index + 2] = 0.9F; };
  EXPECT_EQ(explanation_of(one, {.x = 4, .y = 5}, third).sample, 2U);
  EXPECT_EQ(explanation_of(one, {.x = 4, .y = 5}).sample, 0U);
  EXPECT_EQ(explanation_of(one, {.x = 4, .y = 5, .sample = 1}, nullptr).sample, 1U);
  // An imprecise or permitted sample yields to one at fault.
  const Change two = [](Planes& planes, size_t index) {
    planes.depth[index] += 1e-6F;
    planes.depth[index + 3] = 0.9F;
  };
  EXPECT_EQ(explanation_of(one, {.x = 4, .y = 5}, two).sample, 3U);
}

}  // namespace
}  // namespace fillrule::explain
