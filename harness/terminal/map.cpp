#include "harness/terminal/map.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "harness/judge/verdict.h"
#include "harness/report/printable.h"
#include "harness/report/sample_class.h"

namespace fillrule::terminal {
namespace {

using judge::Bounds;
using report::SampleClass;
using report::SampleMark;

constexpr size_t kIndent = 4;
constexpr size_t kRowLabel = 6;  // "   12 "
constexpr uint32_t kMargin = 3;  // pixels around what is wrong

bool is_wrong(const SampleMark& mark) {
  return mark.kind > SampleClass::kPermitted;
}

// The gravest mark of each pixel, row by row.
struct Marks {
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<SampleMark> pixels;

  Marks(const Case& test_case, const run::Drawing& drawing)
      : width(test_case.target.width), height(test_case.target.height), pixels(size_t{width} * height) {
    const size_t samples = drawing.candidate.samples;
    for (size_t pixel = 0; pixel < pixels.size(); ++pixel) {
      for (size_t sample = 0; sample < samples; ++sample) {
        add(pixels[pixel], report::mark_of(drawing, pixel * samples + sample));
      }
    }
  }

  static void add(SampleMark& pixel, const SampleMark& sample) {
    const bool covered = pixel.covered || sample.covered;
    if (sample.graver_than(pixel)) pixel = sample;
    pixel.covered = covered;
  }

  [[nodiscard]] std::optional<Bounds> wrong() const {
    std::optional<Bounds> box;
    for (uint32_t y = 0; y < height; ++y) {
      for (uint32_t x = 0; x < width; ++x) {
        if (!is_wrong(pixels[size_t{y} * width + x])) continue;
        if (!box) box = Bounds{.min_x = x, .min_y = y, .max_x = x, .max_y = y};
        box->min_x = std::min(box->min_x, x);
        box->max_x = std::max(box->max_x, x);
        box->max_y = y;
      }
    }
    return box;
  }
};

// The part of the target that is shown, and how many pixels wide and high the square is that a character stands for.
struct Extract {
  Bounds box;
  uint32_t square = 1;
};

Extract choose_extract(const Marks& marks, const Bounds& wrong, size_t columns) {
  Extract extract{.box = {.max_x = marks.width - 1, .max_y = marks.height - 1}};
  if (marks.width > columns || marks.height > kMapLimit) {
    extract.box = {.min_x = wrong.min_x - std::min(wrong.min_x, kMargin),
                   .min_y = wrong.min_y - std::min(wrong.min_y, kMargin),
                   .max_x = std::min(wrong.max_x + kMargin, marks.width - 1),
                   .max_y = std::min(wrong.max_y + kMargin, marks.height - 1)};
  }
  const size_t width = extract.box.max_x - extract.box.min_x + 1;
  const size_t height = extract.box.max_y - extract.box.min_y + 1;
  while (width > columns * extract.square || height > kMapLimit * extract.square) ++extract.square;
  return extract;
}

Role role_of(const SampleMark& mark) {
  if (mark.kind == SampleClass::kRight) return mark.covered ? Role::kPlain : Role::kDim;
  if (mark.kind == SampleClass::kPermitted) return Role::kPermitted;
  if (mark.kind == SampleClass::kImprecise) return Role::kCaution;
  return mark.reference_alone ? Role::kReference : Role::kBad;
}

// "M missing, v varying", the gravest first, of what the extract shows.
std::string legend(const Marks& marks, const Extract& extract) {
  std::vector<SampleMark> shown;
  for (uint32_t y = extract.box.min_y; y <= extract.box.max_y; ++y) {
    for (uint32_t x = extract.box.min_x; x <= extract.box.max_x; ++x) {
      const SampleMark& mark = marks.pixels[size_t{y} * marks.width + x];
      const bool is_new =
          std::ranges::none_of(shown, [&mark](const SampleMark& other) { return other.letter() == mark.letter(); });
      if (is_new && mark.kind != SampleClass::kRight) shown.push_back(mark);
    }
  }
  std::ranges::sort(shown, [](const SampleMark& a, const SampleMark& b) { return a.graver_than(b); });
  std::string text;
  for (const SampleMark& mark : shown) {
    text += fmt::format("{} {}{}, ", mark.letter(), name_of(mark.kind), mark.reference_alone ? " (reference)" : "");
  }
  return text + "# right, . right and empty";
}

std::string title(const Marks& marks, const Extract& extract) {
  const Bounds& box = extract.box;
  const bool whole = box.max_x - box.min_x + 1 == marks.width && box.max_y - box.min_y + 1 == marks.height;
  std::string text = fmt::format("map of {} x {} pixels", marks.width, marks.height);
  if (!whole) {
    text += fmt::format(", cropped to ({}, {}) to ({}, {})", box.min_x, box.min_y, box.max_x, box.max_y);
  }
  if (extract.square > 1) {
    text += fmt::format(", reduced: a letter is the gravest of {0} x {0} pixels", extract.square);
  }
  return text;
}

// One row of characters, each run of the same role painted at once.
std::string row_text(const Marks& marks, const Extract& extract, uint32_t top, const Style& style) {
  std::string text;
  std::string run;
  Role run_role = Role::kPlain;
  for (uint32_t left = extract.box.min_x; left <= extract.box.max_x; left += extract.square) {
    SampleMark gravest;
    for (uint32_t y = top; y < top + extract.square && y <= extract.box.max_y; ++y) {
      for (uint32_t x = left; x < left + extract.square && x <= extract.box.max_x; ++x) {
        Marks::add(gravest, marks.pixels[size_t{y} * marks.width + x]);
      }
    }
    const Role role = role_of(gravest);
    if (role != run_role) {
      text += style.paint(run_role, run);
      run.clear();
      run_role = role;
    }
    run += gravest.letter();
  }
  return text + style.paint(run_role, run);
}

}  // namespace

std::string map_text(const Case& test_case, const run::Drawing& drawing, const Style& style) {
  const Marks marks(test_case, drawing);
  const std::optional<Bounds> wrong = marks.wrong();
  if (!wrong) return {};
  const size_t taken = kIndent + kRowLabel;
  const size_t room = style.columns == 0 ? kMapLimit : style.columns - std::min(style.columns - 1, taken);
  const Extract extract = choose_extract(marks, *wrong, std::min(room, kMapLimit));
  const std::string head = fmt::format("{:{}}{}; {}", "", kIndent, title(marks, extract), legend(marks, extract));
  std::string text = report::wrapped(head, style.columns, kIndent + 2) + "\n";
  for (uint32_t y = extract.box.min_y; y <= extract.box.max_y; y += extract.square) {
    text += style.paint(Role::kDim, fmt::format("{:>{}} ", y, taken - 1));
    text += row_text(marks, extract, y, style) + "\n";
  }
  return text;
}

}  // namespace fillrule::terminal
