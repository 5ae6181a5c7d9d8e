#include "harness/judge/line_rules.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "reference/exact/bresenham.h"

namespace fillrule::judge {
namespace {

using exact::BresenhamLine;
using exact::Entry;
using exact::Expectation;
using exact::Piece;

// What a party drew of one line. Columns and rows are an x-major line's; see the header.
struct DrawnLine {
  const Piece* piece = nullptr;
  const BresenhamLine* shape = nullptr;
  bool told = true;                              // the planes tell of every sample whether the line landed there
  std::map<int64_t, std::set<int64_t>> columns;  // the rows of its fragments
  std::map<int64_t, std::set<int64_t>> open;     // where it might have landed and did not
};

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
    for (const auto& [number, line] : lines_) {
      if (!line.told) continue;
      judge_line(line);
      if (previous != nullptr && continues(*previous, line)) judge_joint(*previous, line);
      previous = &line;
    }
    return {broken_.begin(), broken_.end()};
  }

 private:
  void find_lines() {
    for (uint32_t i = 0; i < expectation_.pieces().size(); ++i) {
      const Piece& piece = expectation_.pieces()[i];
      if (piece.kind != Piece::Kind::kBresenhamLine) continue;
      const auto& shape = static_cast<const BresenhamLine&>(*piece.shape);
      if (!shape.has_rules(piece.latitude) || !lands_everywhere(case_, piece)) continue;
      lines_[i] = {.piece = &piece, .shape = &shape};
    }
  }

  void find_fragments() {
    std::vector<Entry> entries;
    for (size_t index = 0; index < planes_.hits.size(); ++index) {
      if (expectation_.sole()[index] != exact::kSeveral) continue;
      expectation_.collect(index, entries);
      for (const Entry& entry : entries) {
        const auto found = lines_.find(entry.piece);
        if (found != lines_.end()) note(found->second, entries, index);
      }
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
    auto& columns = landed ? line.columns : line.open;
    columns[line.shape->x_major() ? x : y].insert(line.shape->x_major() ? y : x);
  }

  void break_at(const DrawnLine& line, int64_t column, int64_t row) {
    const int64_t x = line.shape->x_major() ? column : row;
    const int64_t y = line.shape->x_major() ? row : column;
    broken_.insert(static_cast<size_t>(y) * planes_.width + static_cast<size_t>(x));
  }

  void judge_line(const DrawnLine& line) {
    const auto width = static_cast<size_t>(line.shape->width());
    for (const auto& [column, rows] : line.columns) {
      const bool side_by_side = *rows.rbegin() - *rows.begin() + 1 == static_cast<int64_t>(rows.size());
      if (rows.size() != width || !side_by_side) break_at(line, column, *rows.rbegin());
    }
    const exact::CountRange expected = line.shape->columns(line.piece->latitude);
    const auto columns = static_cast<int64_t>(line.columns.size());
    if (columns > expected.most + 1) {
      const auto& [column, rows] = *line.columns.rbegin();
      break_at(line, column, *rows.begin());
    }
    if (columns < expected.least - 1) break_at_missing(line);
  }

  // In the middle of the first column that lacks its fragments behind one that has them, or else of the first.
  void break_at_missing(const DrawnLine& line) {
    const auto* missing = &*line.open.begin();
    for (const auto& column : line.open) {
      if (line.columns.contains(column.first)) continue;
      missing = &column;
      if (!line.columns.empty() && column.first > line.columns.begin()->first) break;
    }
    const auto& [column, rows] = *missing;
    break_at(line, column, *std::next(rows.begin(), static_cast<std::ptrdiff_t>(rows.size() / 2)));
  }

  [[nodiscard]] static bool continues(const DrawnLine& a, const DrawnLine& b) {
    return a.piece->draw == b.piece->draw && a.shape->width() == b.shape->width() &&
           a.shape->segment().vertices()[1] == b.shape->segment().vertices()[0] &&
           a.shape->x_major() == b.shape->x_major() && a.shape->ascending() == b.shape->ascending();
  }

  void judge_joint(const DrawnLine& a, const DrawnLine& b) {
    for (const auto& [column, rows] : b.columns) {
      const auto same = a.columns.find(column);
      if (same == a.columns.end()) continue;
      for (const int64_t row : rows) {
        if (same->second.contains(row)) break_at(b, column, row);
      }
    }
    if (a.columns.empty() || b.columns.empty()) return;
    const bool ascending = a.shape->ascending();
    const auto& [last, last_rows] = ascending ? *a.columns.rbegin() : *a.columns.begin();
    const auto& [first, first_rows] = ascending ? *b.columns.begin() : *b.columns.rbegin();
    const int64_t gap = (ascending ? first - last : last - first) - 1;
    const bool rows_touch =
        *first_rows.begin() <= *last_rows.rbegin() + 1 && *last_rows.begin() <= *first_rows.rbegin() + 1;
    if (gap > 0 || (gap == 0 && !rows_touch)) break_at(b, first, *first_rows.begin());
  }

  const Case& case_;
  const Expectation& expectation_;
  const Planes& planes_;
  std::map<uint32_t, DrawnLine> lines_;  // by piece
  std::set<size_t> broken_;
};

}  // namespace

std::vector<size_t> broken_line_rules(const Case& test_case, const Expectation& expectation, const Planes& planes) {
  if (planes.samples != 1) return {};
  return LineRules(test_case, expectation, planes).broken();
}

}  // namespace fillrule::judge
