// How text is laid out on the terminal at hand: its colours, its width, and whether it can show pictures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace fillrule::terminal {

enum class Role : uint8_t { kPlain, kGood, kBad, kReference, kCaution, kPermitted, kDim, kHeading };

enum class Preview : uint8_t {
  kNone,
  kBlocks,  // two pixels a character, by 24-bit colours
  kKitty,   // the kitty graphics protocol
};

struct Style {
  bool colour = false;
  size_t columns = 0;  // 0: as many as it takes
  Preview preview = Preview::kNone;

  // The text in the role's colour, if there are colours.
  [[nodiscard]] std::string paint(Role role, std::string_view text) const;
};

// What the user asks for, in the words of the command line: "auto", "always", "never"; "auto", "blocks", "kitty",
// "none".
struct Wishes {
  std::string colour = "auto";
  std::string preview = "auto";
};

// What the output goes to.
struct Surroundings {
  bool is_terminal = false;
  size_t columns = 0;                                            // of the terminal
  std::function<std::string(const std::string& name)> variable;  // of the environment; "" where it is not set
};

// A wish decides. Without one, NO_COLOR forbids colours, CLICOLOR_FORCE other than 0 asks for them, and else a
// terminal that is not dumb has them; pictures are for terminals in colour that are known to show them.
Style choose_style(const Wishes& wishes, const Surroundings& surroundings);

}  // namespace fillrule::terminal
