#include "harness/terminal/preview.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "harness/report/picture.h"

namespace fillrule::terminal {
namespace {

using report::Picture;
using report::Rgb;

constexpr size_t kIndent = 4;
constexpr uint32_t kWidestPanel = 64;   // characters
constexpr uint32_t kWantedPanel = 256;  // pixels, where the terminal draws pixels
constexpr size_t kKittyChunk = 4096;    // bytes of base64, by the protocol's specification

std::vector<Picture> panels_of(const Case& test_case, const run::Drawing& drawing) {
  const Planes* const reference = drawing.reference ? &*drawing.reference : nullptr;
  const report::ValueRange range = report::range_of(drawing.candidate, reference);
  std::vector<Picture> panels{report::picture_of(test_case, drawing.candidate, range)};
  if (reference != nullptr) panels.push_back(report::picture_of(test_case, *reference, range));
  panels.push_back(report::difference_picture(test_case, drawing.verdict));
  return panels;
}

// Upper half blocks: the colour of the text above, that of the background below. Of a picture that is too wide every
// n-th pixel is shown.
std::string blocks_text(const std::vector<Picture>& panels, const Style& style) {
  const size_t room = style.columns == 0 ? kWidestPanel * panels.size() + panels.size()
                                         : style.columns - std::min(style.columns, kIndent);
  const auto widest = std::clamp<uint32_t>(static_cast<uint32_t>(room / panels.size()), 2, kWidestPanel + 1) - 1;
  const uint32_t width = panels.front().width;
  const uint32_t height = panels.front().height;
  const uint32_t step = (width + widest - 1) / widest;
  std::string text;
  for (uint32_t y = 0; y < height; y += 2 * step) {
    text.append(kIndent, ' ');
    for (const Picture& panel : panels) {
      for (uint32_t x = 0; x < width; x += step) {
        const Rgb& above = panel.at(x, y);
        const Rgb& below = panel.at(x, std::min(y + step, height - 1));
        text += fmt::format("\x1b[38;2;{};{};{};48;2;{};{};{}m\u2580", above[0], above[1], above[2], below[0],
                            below[1], below[2]);
      }
      text += "\x1b[0m ";
    }
    text.back() = '\n';
  }
  return text;
}

std::string base64(const std::vector<Rgb>& pixels) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(pixels.size() * 4);
  // Three bytes a pixel are four digits: nothing is left over.
  for (const Rgb& pixel : pixels) {
    const uint32_t bits = uint32_t{pixel[0]} << 16 | uint32_t{pixel[1]} << 8 | pixel[2];
    for (const int shift : {18, 12, 6, 0}) text += kDigits[bits >> shift & 63];
  }
  return text;
}

// The terminal is told not to answer (q=2), as nobody would read it.
std::string kitty_text(const std::vector<Picture>& panels) {
  const uint32_t scale = std::max(1U, kWantedPanel / std::max(panels.front().width, panels.front().height));
  const Picture sheet = report::side_by_side(panels, scale);
  const std::string text_of_pixels = base64(sheet.pixels);
  const std::string_view data = text_of_pixels;
  std::string text(kIndent, ' ');
  for (size_t begin = 0; begin < data.size(); begin += kKittyChunk) {
    const std::string head =
        begin == 0 ? fmt::format("a=T,f=24,s={},v={},q=2,", sheet.width, sheet.height) : std::string();
    text += fmt::format("\x1b_G{}m={};{}\x1b\\", head, begin + kKittyChunk < data.size() ? 1 : 0,
                        data.substr(begin, kKittyChunk));
  }
  return text + "\n";
}

}  // namespace

std::string preview_text(const Case& test_case, const run::Drawing& drawing, const Style& style) {
  if (style.preview == Preview::kNone) return {};
  const std::vector<Picture> panels = panels_of(test_case, drawing);
  const std::string head = drawing.reference ? "    candidate | reference | verdict\n" : "    candidate | verdict\n";
  return head + (style.preview == Preview::kKitty ? kitty_text(panels) : blocks_text(panels, style));
}

}  // namespace fillrule::terminal
