#include "harness/judge/line_rules.h"

#include <algorithm>
#include <array>
#include <compare>
#include <span>

#include "reference/exact/bresenham.h"

namespace fillrule::judge {
namespace {

using exact::BresenhamLine;
using exact::Entry;
using exact::Expectation;
using exact::Piece;

// A place of a fragment; columns and rows are an x-major line's, see the header.
struct Cell {
  int64_t column = 0;
  int64_t row = 0;
  auto operator<=>(const Cell&) const = default;  // NOLINT(modernize-use-nullptr): mistakes the 0 within
};
// Of one line, ascending.
using Cells = std::vector<Cell>;

// What a party drew of one line.
struct DrawnLine {
  const Piece* piece = nullptr;
  const BresenhamLine* shape = nullptr;
  bool told = true;  // the planes tell of every sample whether the line landed there
  Cells fragments;
  Cells open;  // where it might have landed and did not
};

// The cells of one column.
std::span<const Cell> in_column(const Cells& cells, int64_t column) {
  return {std::ranges::lower_bound(cells, column, {}, &Cell::column),
          std::ranges::upper_bound(cells, column, {}, &Cell::column)};
}

// Calls visit(cells of a column) for each column.
template <typename Visit>
void for_each_column(const Cells& cells, const Visit& visit) {
  for (std::span<const Cell> rest = cells; !rest.empty();) {
    const auto end = std::ranges::find_if(
        rest, [first = rest.front().column](int64_t column) { return column != first; }, &Cell::column);
    const auto size = static_cast<size_t>(end - rest.begin());
    visit(rest.first(size));
    rest = rest.subspan(size);
  }
}

bool contains(const VkRect2D& rectangle, const std::array<double, 4>& box) {
  const double left = rectangle.offset.x;
  const double top = rectangle.offset.y;
  return box[0] >= left && box[1] >= top && box[2] <= left + static_cast<double>(rectangle.extent.width) &&
         box[3] <= top + static_cast<double>(rectangle.extent.height);
}

// No fragment that a rule counts may get lost on its way into the planes.
bool lands_everywhere(const Case& test_case, const Piece& piece) {
  const RasterState& state = test_case.draws[piece.draw].state;
  if ((state.depth_test && state.depth_compare != VK_COMPARE_OP_ALWAYS) || state.depth_bounds) return false;
  if ((state.sample_mask & 1U) == 0 || piece.culled || piece.open || piece.facing_in_doubt) return false;
  const std::array<double, 4> box = piece.shape->bounds(piece.latitude);
  const VkViewport& viewport = state.viewport;
  const double top = std::min(double{viewport.y}, double{viewport.y} + double{viewport.height});
  const double bottom = std::max(double{viewport.y}, double{viewport.y} + double{viewport.height});
  const bool in_viewport = box[0] >= double{viewport.x} && box[1] >= top &&
                           box[2] <= double{viewport.x} + double{viewport.width} && box[3] <= bottom;
  const VkRect2D target{.offset = {}, .extent = {.width = test_case.target.width, .height = test_case.target.height}};
  return in_viewport && contains(state.scissor, box) && contains(target, box);
}

class LineRules {
 public:
  LineRules(const Case& test_case, const Expectation& expectation, const Planes& planes)
      : case_(test_case), expectation_(expectation), planes_(planes) {}

  std::vector<size_t> broken() {
    find_lines();
    if (lines_.empty()) return {};
    find_fragments();
    const DrawnLine* previous = nullptr;
    for (const DrawnLine& line : lines_) {
      if (!line.told) continue;
      judge_line(line);
      if (previous != nullptr && continues(*previous, line)) judge_joint(*previous, line);
      previous = &line;
    }
    std::ranges::sort(broken_);
    broken_.erase(std::unique(broken_.begin(), broken_.end()), broken_.end());
    return std::move(broken_);
  }

 private:
  void find_lines() {
    for (uint32_t i = 0; i < expectation_.pieces().size(); ++i) {
      const Piece& piece = expectation_.pieces()[i];
      if (piece.kind != Piece::Kind::kBresenhamLine) continue;
      const auto& shape = static_cast<const BresenhamLine&>(*piece.shape);
      if (!shape.has_rules(piece.latitude) || !lands_everywhere(case_, piece)) continue;
      line_of_piece_.resize(expectation_.pieces().size(), kNoLine);
      line_of_piece_[i] = static_cast<uint32_t>(lines_.size());
      lines_.push_back({.piece = &piece, .shape = &shape});
    }
  }

  void find_fragments() {
    std::vector<Entry> entries;
    for (size_t index = 0; index < planes_.hits.size(); ++index) {
      // Where one piece alone must cover, it is no Bresenham line: of those no fragment is certain.
      const uint32_t number = expectation_.classes()[index];
      if (number == exact::kNothing || expectation_.sole(number)) continue;
      expectation_.collect(index, entries);
      for (const Entry& entry : entries) {
        const uint32_t line = line_of_piece_[entry.piece];
        if (line != kNoLine) note(lines_[line], entries, index);
      }
    }
    // They were found in the order of samples.
    for (DrawnLine& line : lines_) {
      std::ranges::sort(line.fragments);
      std::ranges::sort(line.open);
    }
  }

  void note(DrawnLine& line, const std::vector<Entry>& entries, size_t index) {
    const uint32_t hits = planes_.hits[index];
    const uint32_t owner = planes_.owner[index];
    const auto of_owner = std::count_if(entries.begin(), entries.end(), [&](const Entry& entry) {
      return expectation_.pieces()[entry.piece].owner == owner;
    });
    const bool all_or_none = hits == 0 || hits == entries.size();
    line.told = line.told && (all_or_none || (hits == 1 && of_owner == 1));
    const bool landed = hits != 0 && (hits == entries.size() || owner == line.piece->owner);
    const auto x = static_cast<int64_t>(index % planes_.width);
    const auto y = static_cast<int64_t>(index / planes_.width);
    Cells& cells = landed ? line.fragments : line.open;
    cells.push_back(line.shape->x_major() ? Cell{.column = x, .row = y} : Cell{.column = y, .row = x});
  }

  void break_at(const DrawnLine& line, const Cell& cell) {
    const int64_t x = line.shape->x_major() ? cell.column : cell.row;
    const int64_t y = line.shape->x_major() ? cell.row : cell.column;
    broken_.push_back(static_cast<size_t>(y) * planes_.width + static_cast<size_t>(x));
  }

  void judge_line(const DrawnLine& line) {
    const auto width = static_cast<size_t>(line.shape->width());
    int64_t columns = 0;
    for_each_column(line.fragments, [&](std::span<const Cell> column) {
      ++columns;
      const bool side_by_side = column.back().row - column.front().row + 1 == static_cast<int64_t>(column.size());
      if (column.size() != width || !side_by_side) break_at(line, column.back());
    });
    const exact::CountRange expected = line.shape->columns(line.piece->latitude);
    if (columns > expected.most + 1) {
      break_at(line, in_column(line.fragments, line.fragments.back().column).front());
    }
    if (columns < expected.least - 1) break_at_missing(line);
  }

  // In the middle of the first column that lacks its fragments behind one that has them, or else of the last that
  // does, or else of the first.
  void break_at_missing(const DrawnLine& line) {
    std::span<const Cell> missing = in_column(line.open, line.open.front().column);
    bool found = false;
    for_each_column(line.open, [&](std::span<const Cell> column) {
      const int64_t number = column.front().column;
      if (found || !in_column(line.fragments, number).empty()) return;
      missing = column;
      found = !line.fragments.empty() && number > line.fragments.front().column;
    });
    break_at(line, missing[missing.size() / 2]);
  }

  [[nodiscard]] static bool continues(const DrawnLine& a, const DrawnLine& b) {
    return a.piece->draw == b.piece->draw && a.shape->width() == b.shape->width() &&
           a.shape->segment().vertices()[1] == b.shape->segment().vertices()[0] &&
           a.shape->x_major() == b.shape->x_major() && a.shape->ascending() == b.shape->ascending();
  }

  void judge_joint(const DrawnLine& a, const DrawnLine& b) {
    for (const Cell& cell : b.fragments) {
      if (std::ranges::binary_search(a.fragments, cell)) break_at(b, cell);
    }
    if (a.fragments.empty() || b.fragments.empty()) return;
    const bool ascending = a.shape->ascending();
    const int64_t last = ascending ? a.fragments.back().column : a.fragments.front().column;
    const int64_t first = ascending ? b.fragments.front().column : b.fragments.back().column;
    const std::span<const Cell> last_rows = in_column(a.fragments, last);
    const std::span<const Cell> first_rows = in_column(b.fragments, first);
    const int64_t gap = (ascending ? first - last : last - first) - 1;
    const bool rows_touch =
        first_rows.front().row <= last_rows.back().row + 1 && last_rows.front().row <= first_rows.back().row + 1;
    if (gap > 0 || (gap == 0 && !rows_touch)) break_at(b, first_rows.front());
  }

  const Case& case_;
  const Expectation& expectation_;
  const Planes& planes_;
  static constexpr uint32_t kNoLine = 0xFFFFFFFFU;
  std::vector<DrawnLine> lines_;         // in the order of their pieces
  std::vector<uint32_t> line_of_piece_;  // where it is in lines_
  std::vector<size_t> broken_;
};

}  // namespace

std::vector<size_t> broken_line_rules(const Case& test_case, const Expectation& expectation, const Planes& planes) {
  if (planes.samples != 1) return {};
  return LineRules(test_case, expectation, planes).broken();
}

}  // namespace fillrule::judge
