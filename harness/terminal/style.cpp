#include "harness/terminal/style.h"

#include <fmt/format.h>

namespace fillrule::terminal {
namespace {

// ECMA-48, "Select Graphic Rendition", in the 16 colours that every terminal's theme defines.
std::string_view code_of(Role role) {
  switch (role) {
    case Role::kPlain:
      return "";
    case Role::kGood:
      return "32";
    case Role::kBad:
      return "1;31";
    case Role::kReference:
      return "35";
    case Role::kCaution:
      return "33";
    case Role::kPermitted:
      return "34";
    case Role::kDim:
      return "2";
    case Role::kHeading:
      return "1";
  }
  return "";
}

bool wants_colour(const Wishes& wishes, const Surroundings& surroundings) {
  if (wishes.colour != "auto") return wishes.colour == "always";
  if (!surroundings.variable("NO_COLOR").empty()) return false;
  const std::string forced = surroundings.variable("CLICOLOR_FORCE");
  if (!forced.empty() && forced != "0") return true;
  return surroundings.is_terminal && surroundings.variable("TERM") != "dumb";
}

Preview preview_of(const Surroundings& surroundings) {
  const std::string term = surroundings.variable("TERM");
  const std::string program = surroundings.variable("TERM_PROGRAM");
  const bool kitty = term == "xterm-kitty" || term == "xterm-ghostty" || program == "WezTerm" || program == "ghostty";
  // A multiplexer swallows the protocol.
  if (kitty && surroundings.variable("TMUX").empty()) return Preview::kKitty;
  const std::string colours = surroundings.variable("COLORTERM");
  return colours == "truecolor" || colours == "24bit" ? Preview::kBlocks : Preview::kNone;
}

}  // namespace

std::string Style::paint(Role role, std::string_view text) const {
  const std::string_view code = code_of(role);
  if (!colour || code.empty() || text.empty()) return std::string(text);
  return fmt::format("\x1b[{}m{}\x1b[0m", code, text);
}

Style choose_style(const Wishes& wishes, const Surroundings& surroundings) {
  Style style{.colour = wants_colour(wishes, surroundings),
              .columns = surroundings.is_terminal ? surroundings.columns : 0};
  if (wishes.preview == "blocks") style.preview = Preview::kBlocks;
  if (wishes.preview == "kitty") style.preview = Preview::kKitty;
  if (wishes.preview == "auto" && style.colour && surroundings.is_terminal) style.preview = preview_of(surroundings);
  return style;
}

}  // namespace fillrule::terminal
