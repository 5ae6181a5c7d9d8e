#include "harness/terminal/style.h"

#include <gtest/gtest.h>

#include <map>

namespace fillrule::terminal {
namespace {

using Variables = std::map<std::string, std::string>;

Surroundings surroundings(bool is_terminal, const Variables& variables) {
  return {.is_terminal = is_terminal, .columns = 100, .variable = [variables](const std::string& name) {
            const auto found = variables.find(name);
            return found == variables.end() ? std::string() : found->second;
          }};
}

bool has_colour(const std::string& wish, bool is_terminal, const Variables& variables) {
  return choose_style({.colour = wish}, surroundings(is_terminal, variables)).colour;
}

Preview preview(const std::string& wish, bool is_terminal, const Variables& variables) {
  return choose_style({.preview = wish}, surroundings(is_terminal, variables)).preview;
}

TEST(ChooseStyle, ATerminalHasColoursAndAPipeHasNone) {
  EXPECT_TRUE(has_colour("auto", true, {}));
  EXPECT_FALSE(has_colour("auto", false, {}));
  EXPECT_FALSE(has_colour("auto", true, {{"TERM", "dumb"}}));
}

TEST(ChooseStyle, TheEnvironmentForbidsAndAsksForColours) {
  EXPECT_FALSE(has_colour("auto", true, {{"NO_COLOR", "1"}}));
  EXPECT_TRUE(has_colour("auto", true, {{"NO_COLOR", ""}}));
  EXPECT_TRUE(has_colour("auto", false, {{"CLICOLOR_FORCE", "1"}}));
  EXPECT_FALSE(has_colour("auto", false, {{"CLICOLOR_FORCE", "0"}}));
  EXPECT_FALSE(has_colour("auto", false, {{"CLICOLOR_FORCE", "1"}, {"NO_COLOR", "1"}}));
}

TEST(ChooseStyle, TheCommandLineDecides) {
  EXPECT_TRUE(has_colour("always", false, {{"NO_COLOR", "1"}}));
  EXPECT_FALSE(has_colour("never", true, {{"CLICOLOR_FORCE", "1"}}));
}

TEST(ChooseStyle, OnlyATerminalHasAWidth) {
  EXPECT_EQ(choose_style({}, surroundings(true, {})).columns, 100U);
  EXPECT_EQ(choose_style({}, surroundings(false, {})).columns, 0U);
}

TEST(ChooseStyle, PicturesAreForTerminalsThatAreKnownToShowThem) {
  EXPECT_EQ(preview("auto", true, {}), Preview::kNone);
  EXPECT_EQ(preview("auto", true, {{"COLORTERM", "truecolor"}}), Preview::kBlocks);
  EXPECT_EQ(preview("auto", true, {{"TERM", "xterm-kitty"}, {"COLORTERM", "truecolor"}}), Preview::kKitty);
  EXPECT_EQ(preview("auto", true, {{"TERM", "xterm-kitty"}, {"TMUX", "/tmp/x"}}), Preview::kNone);
  EXPECT_EQ(preview("auto", true, {{"COLORTERM", "truecolor"}, {"NO_COLOR", "1"}}), Preview::kNone);
  EXPECT_EQ(preview("auto", false, {{"COLORTERM", "truecolor"}, {"CLICOLOR_FORCE", "1"}}), Preview::kNone);
  EXPECT_EQ(preview("blocks", false, {}), Preview::kBlocks);
  EXPECT_EQ(preview("kitty", true, {}), Preview::kKitty);
  EXPECT_EQ(preview("none", true, {{"COLORTERM", "truecolor"}}), Preview::kNone);
}

TEST(Paint, OnlyWithColours) {
  EXPECT_EQ(Style{}.paint(Role::kBad, "x"), "x");
  EXPECT_EQ(Style{.colour = true}.paint(Role::kBad, "x"), "\x1b[1;31mx\x1b[0m");
  EXPECT_EQ(Style{.colour = true}.paint(Role::kPlain, "x"), "x");
  EXPECT_EQ(Style{.colour = true}.paint(Role::kBad, ""), "");
}

}  // namespace
}  // namespace fillrule::terminal
