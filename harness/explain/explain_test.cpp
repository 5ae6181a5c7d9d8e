#include "harness/explain/explain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "harness/explain/test_support.h"

namespace fillrule::explain {
namespace {

TEST(Explain, ACoveredSample) {
  EXPECT_EQ(explained(upright("inside"), 4, 5), R"(inside, pixel 4,5 sample 0, at (4.5, 5.5)
the oracle, for 8 subpixel bits; dx, dy are pixels from the viewport's centre:
  primitive 0 (draw 0, vertices 0 1 2): clockwise, back-facing; must cover the sample
    edge v1-v2                         +1086 subpixels, rounding 0.708: must      E = 72 = -12 dx -12 dy +0
    edge v0-v2 (left)                   +640 subpixels, rounding 0.501: must      E = 30 = 12 dx +0 dy +72
    edge v0-v1 (top)                    +896 subpixels, rounding 0.501: must      E = 42 = 0 dx +12 dy +72
    the viewport's left side           +1152 subpixels, rounding 0.501: must      E = 4.5 = 1 dx +0 dy +8
  right: hits 1; owner 0, the depth of 0
candidate renderer (8 subpixel bits): hits 1, owner 0, back-facing
  depth                0.447916657  0x3ee55555  exact 0.447916666667 +- 0.000123 (snapping 0.000122, rounding 4.86e-07); off by 8.09e-05 tolerances, 0.333 ULP
  u                    0.791666687  0x3f4aaaab  exact 0.791666666667 +- 0.000491 (snapping 0.000489, rounding 2.07e-06); off by 4.04e-05 tolerances, 0.333 ULP
reference lavapipe (8 subpixel bits): hits 1, owner 0, back-facing
  depth                0.447916657  0x3ee55555  exact 0.447916666667 +- 0.000123 (snapping 0.000122, rounding 4.86e-07); off by 8.09e-05 tolerances, 0.333 ULP
  u                    0.791666687  0x3f4aaaab  exact 0.791666666667 +- 0.000491 (snapping 0.000489, rounding 2.07e-06); off by 4.04e-05 tolerances, 0.333 ULP
verdicts: coverage identical, hits identical, owner identical, front_facing identical, depth identical, u identical
The sample lies 640 subpixels inside edge v0-v2 of primitive 0, which must cover it; every plane is identical.
)");
}

TEST(Explain, ASampleOnAnEdge) {
  EXPECT_EQ(explained(upright("tie"), 10, 5), R"(tie, pixel 10,5 sample 0, at (10.5, 5.5)
the oracle, for 8 subpixel bits; dx, dy are pixels from the viewport's centre:
  primitive 0 (draw 0, vertices 0 1 2): clockwise, back-facing; may cover the sample
    edge v1-v2                            +0 subpixels, rounding 0.708: may       E = 0 = -12 dx -12 dy +0
    edge v0-v2 (left)                  +2176 subpixels, rounding 0.501: must      E = 102 = 12 dx +0 dy +72
    edge v0-v1 (top)                    +896 subpixels, rounding 0.501: must      E = 42 = 0 dx +12 dy +72
    the viewport's right side          +1408 subpixels, rounding 0.501: must      E = 5.5 = -1 dx +0 dy +8
  right: hits 0 to 1; owner none, the clear depth; owner 0, the depth of 0
candidate renderer (8 subpixel bits): hits 0, owner none
  depth                          1  0x3f800000  exact 1  right
  u                              0  0x00000000  exact 0  right
reference lavapipe (8 subpixel bits): hits 0, owner none
  depth                          1  0x3f800000  exact 1  right
  u                              0  0x00000000  exact 0  right
verdicts: coverage identical, hits identical, owner identical, front_facing identical, depth identical, u identical
The sample lies exactly on edge v1-v2 of primitive 0, which rounding may move by 0.708 subpixels: both answers are permitted.
)");
}

TEST(Explain, ASampleThatTheCandidateMustNotCover) {
  const auto text = explained(upright("extra"), 1, 5, [](Planes& planes, size_t index) {
    planes.hits[index] = 1;
    planes.owner[index] = 0;
  });
  EXPECT_EQ(text, R"(extra, pixel 1,5 sample 0, at (1.5, 5.5)
the oracle, for 8 subpixel bits; dx, dy are pixels from the viewport's centre:
  primitive 0 (draw 0, vertices 0 1 2): clockwise, back-facing; must not cover the sample
    edge v1-v2                         +1629 subpixels, rounding 0.708: must      E = 108 = -12 dx -12 dy +0
    edge v0-v2 (left)                   -128 subpixels, rounding 0.501: must not  E = -6 = 12 dx +0 dy +72
    edge v0-v1 (top)                    +896 subpixels, rounding 0.501: must      E = 42 = 0 dx +12 dy +72
    the viewport's left side            +384 subpixels, rounding 0.501: must      E = 1.5 = 1 dx +0 dy +8
  right: hits 0; owner none, the clear depth
candidate renderer (8 subpixel bits): hits 1, owner 0, back-facing
  depth                          1  0x3f800000  not judged
  u                              0  0x00000000  not judged
reference lavapipe (8 subpixel bits): hits 0, owner none
  depth                          1  0x3f800000  exact 1  right
  u                              0  0x00000000  exact 0  right
verdicts: coverage candidate fault, hits candidate fault, owner candidate fault, front_facing identical, depth identical, u identical
The candidate covers a sample 128 subpixels outside edge v0-v2 of primitive 0: candidate fault.
)");
}

TEST(Explain, AWrongValueOfTheReference) {
  const auto text = explained(upright("value"), 4, 5, nullptr,
                              [](Planes& planes, size_t index) { planes.varyings[0][index] += 0.25F; });
  EXPECT_EQ(text, R"(value, pixel 4,5 sample 0, at (4.5, 5.5)
the oracle, for 8 subpixel bits; dx, dy are pixels from the viewport's centre:
  primitive 0 (draw 0, vertices 0 1 2): clockwise, back-facing; must cover the sample
    edge v1-v2                         +1086 subpixels, rounding 0.708: must      E = 72 = -12 dx -12 dy +0
    edge v0-v2 (left)                   +640 subpixels, rounding 0.501: must      E = 30 = 12 dx +0 dy +72
    edge v0-v1 (top)                    +896 subpixels, rounding 0.501: must      E = 42 = 0 dx +12 dy +72
    the viewport's left side           +1152 subpixels, rounding 0.501: must      E = 4.5 = 1 dx +0 dy +8
  right: hits 1; owner 0, the depth of 0
candidate renderer (8 subpixel bits): hits 1, owner 0, back-facing
  depth                0.447916657  0x3ee55555  exact 0.447916666667 +- 0.000123 (snapping 0.000122, rounding 4.86e-07); off by 8.09e-05 tolerances, 0.333 ULP
  u                    0.791666687  0x3f4aaaab  exact 0.791666666667 +- 0.000491 (snapping 0.000489, rounding 2.07e-06); off by 4.04e-05 tolerances, 0.333 ULP
reference lavapipe (8 subpixel bits): hits 1, owner 0, back-facing
  depth                0.447916657  0x3ee55555  exact 0.447916666667 +- 0.000123 (snapping 0.000122, rounding 4.86e-07); off by 8.09e-05 tolerances, 0.333 ULP
  u                     1.04166675  0x3f855556  exact 0.791666666667 +- 0.000491 (snapping 0.000489, rounding 2.07e-06); off by 509 tolerances, 4.19e+06 ULP
verdicts: coverage identical, hits identical, owner identical, front_facing identical, depth identical, u reference fault
The reference's u is 1.04166675, 509 tolerances from the exact 0.791666667: reference fault.
)");
}

TEST(Explain, ATriangleAcrossTheNearPlane) {
  const Case one = triangle_case("near", {at(2, 2, -0.5), at(14, 2, 0.5), at(2, 14, 0.5)});
  EXPECT_EQ(explained(one, 5, 5), R"(near, pixel 5,5 sample 0, at (5.5, 5.5)
the oracle, for 8 subpixel bits; dx, dy are pixels from the viewport's centre:
  primitive 0 (draw 0, vertices 0 1 2): clockwise, back-facing, to be clipped; must cover the sample
    edge v1-v2                        +905.1 subpixels, rounding 0.708: must      E = 60 = -12 dx -12 dy +0
    edge v0-v2 (left)                   +896 subpixels, rounding 0.501: must      E = 42 = 12 dx +0 dy +72
    edge v0-v1 (top)                    +896 subpixels, rounding 0.501: must      E = 42 = 0 dx +12 dy +72
    the near plane                      +181 subpixels, rounding 0.708: must      E = 0.0833333 = 0.0833333 dx +0.0833333 dy +0.5
    the viewport's left side           +1408 subpixels, rounding 0.501: must      E = 5.5 = 1 dx +0 dy +8
  right: hits 1; owner 0, the depth of 0
candidate renderer (8 subpixel bits): hits 1, owner 0, back-facing
  depth               0.0833333358  0x3daaaaab  exact 0.0833333333333 +- 0.000327 (snapping 0.000326, rounding 1.07e-06); off by 7.59e-06 tolerances, 0.333 ULP
  u                          0.875  0x3f600000  exact 0.875 +- 0.000491 (snapping 0.000489, rounding 2.14e-06); off by 0 tolerances, 0 ULP
reference lavapipe (8 subpixel bits): hits 1, owner 0, back-facing
  depth               0.0833333358  0x3daaaaab  exact 0.0833333333333 +- 0.000327 (snapping 0.000326, rounding 1.07e-06); off by 7.59e-06 tolerances, 0.333 ULP
  u                          0.875  0x3f600000  exact 0.875 +- 0.000491 (snapping 0.000489, rounding 2.14e-06); off by 0 tolerances, 0 ULP
verdicts: coverage identical, hits identical, owner identical, front_facing identical, depth identical, u identical
The sample lies 181 subpixels inside the near plane of primitive 0, which must cover it; every plane is identical.
)");
}

TEST(Explain, ReasonsOfOtherFaults) {
  const Case one = upright("reasons");
  const auto reason = [&](const Change& change) { return last_line(explained(one, 4, 5, change)); };
  EXPECT_EQ(reason([](Planes& planes, size_t index) {
              planes.hits[index] = 0;
              planes.owner[index] = kNoOwner;
            }),
            "The candidate leaves out a sample 640 subpixels inside edge v0-v2 of primitive 0: candidate fault.\n");
  EXPECT_EQ(reason([](Planes& planes, size_t index) { planes.hits[index] = 2; }),
            "The candidate hits the sample 2 times where once is right: candidate fault.\n");
  EXPECT_EQ(reason([](Planes& planes, size_t index) { planes.owner[index] = 7; }),
            "The candidate shows primitive 7 where primitive 0 is right: candidate fault.\n");
  EXPECT_EQ(
      reason([](Planes& planes, size_t index) { planes.front_facing[index] ^= 1U; }),
      "The candidate takes primitive 0 for front-facing, which is clockwise in the framebuffer and back-facing: "
      "candidate fault.\n");
  EXPECT_EQ(reason([](Planes& planes, size_t index) { planes.depth[index] = std::nanf(""); }),
            "The candidate's depth is nan, far from the exact 0.447916667: candidate fault.\n");
}

TEST(Explain, ReasonsWithoutFault) {
  EXPECT_EQ(last_line(explained(upright("far"), 15, 15)),
            "No primitive that is drawn comes within a pixel of the sample.\n");
  EXPECT_EQ(last_line(explained(upright("near"), 1, 5)),
            "No primitive may cover the sample, which lies 128 subpixels outside edge v0-v2 of primitive 0.\n");
  Case behind = upright("behind");
  behind.target.clear_depth = 0;
  EXPECT_EQ(last_line(explained(behind, 4, 5)), "Primitive 0 covers the sample and fails the depth test.\n");
  const Case undefined = triangle_case("nan", {at(2, 2, 0.5), at(14, 2, 0.5), {NAN, 0, 0, 1}});
  EXPECT_EQ(last_line(explained(undefined, 4, 5)),
            "Vulkan leaves primitive 0 undefined: whatever it does here is nobody's fault.\n");
}

TEST(Explain, PartiesOfOtherSubpixelBitsHaveAViewOfTheirOwn) {
  const Case one = upright("bits");
  const Planes planes = programs::draw_case(one, {}).value();
  const NamedParty fine{.name = "fine", .party = {.planes = &planes, .subpixel_bits = 8}};
  const NamedParty coarse{.name = "coarse", .party = {.planes = &planes, .subpixel_bits = 4}};
  const Explanation explanation = explain(one, fine, &coarse, {}, {.x = 2, .y = 5}).value();
  ASSERT_EQ(explanation.views.size(), 2U);
  EXPECT_EQ(explanation.parties[1].view, 1U);
  const Boundary* const fine_edge = explanation.views[0].primitives[0].deciding();
  const Boundary* const coarse_edge = explanation.views[1].primitives[0].deciding();
  EXPECT_EQ(fine_edge->distance, 128);
  EXPECT_EQ(coarse_edge->distance, 8);
  EXPECT_TRUE(fine_edge->left);
}

TEST(Explain, AloneWithTheOracle) {
  const Case one = upright("alone");
  const Planes planes = programs::draw_case(one, {}).value();
  const Explanation explanation =
      explain(one, {.name = "renderer", .party = {.planes = &planes}}, nullptr, {}, {.x = 4, .y = 5}).value();
  EXPECT_EQ(explanation.parties.size(), 1U);
  EXPECT_EQ(explanation.planes.size(), 6U);
}

TEST(Explain, ASampleOutsideOfTheTargetIsAnError) {
  const Case one = upright("error");
  const Planes planes = programs::draw_case(one, {}).value();
  const NamedParty party{.name = "renderer", .party = {.planes = &planes}};
  const auto pixel = explain(one, party, nullptr, {}, {.x = 16, .y = 2});
  ASSERT_FALSE(pixel);
  EXPECT_EQ(pixel.error().what, "pixel 16,2 is not in the target of 16 x 16 pixels");
  EXPECT_EQ(pixel.error().hint, "X is 0 to 15, Y is 0 to 15");
  const auto second_sample = explain(one, party, nullptr, {}, {.x = 1, .y = 2, .sample = 1});
  ASSERT_FALSE(second_sample);
  EXPECT_EQ(second_sample.error().what, "sample 1 is not in a target of 1 sample per pixel");
}

}  // namespace
}  // namespace fillrule::explain
