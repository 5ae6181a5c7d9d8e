// Coverage of small triangles by spans: on a row of pixels each edge is inside from some pixel on, or up to one, and
// what all three leave is cut into runs of eight pixels. That asks fewer pixels in vain than blocks (edge_fill.h) do.
//
// An edge whose value (edge_function.h) on a row's first pixel is E and changes by s from pixel to pixel is inside
// where x >= q, q = -E / s, if s > 0, and where x <= q if s < 0. float32 says exactly which pixels those are:
//   - A triangle is small if its corners are less than 2^13 subpixels apart. Then |s| < 2^13 and, with 4 subpixel
//   bits
//     or more, |E| < 2^24, so both are exact.
//   - q is computed as a product with a rounded reciprocal: it is wrong by less than 2^-23 |q|, which within a tile,
//     |q| <= 64, is 2^-17; the sum with a constant that follows adds 2^-18. All is less than 2^-16.
//   - q is whole or at least 1 / |s| > 2^-13 away from any whole number. So 2^-15, by which it is moved to the side
//     where a whole q is not rounded away, moves it beyond no whole number else.
// Further away than a tile only the order counts, which rounding keeps.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#include "renderer/coverage.h"
#include "renderer/edge_function.h"
#include "renderer/primitive_setup.h"

namespace fillrule::renderer::internal {

// Eight pixels side by side, the first at (x, y) of the tile. Bit kSamples * i + s: sample s of the pixel x + i.
struct PixelRun {
  uint32_t pixel;  // x + y * kTileSize
  uint32_t samples;
  uint32_t primitive;  // whoever made the list knows which

  [[nodiscard, gnu::always_inline]] uint32_t x() const { return pixel % static_cast<uint32_t>(kTileSize); }
  [[nodiscard, gnu::always_inline]] uint32_t y() const { return pixel / static_cast<uint32_t>(kTileSize); }
};

inline constexpr int32_t kMaxSpanPixels = 32;  // of the rectangle in which a small triangle is covered, either way
inline constexpr uint32_t kMaxRunsOfTriangle =
    kMaxSpanPixels * kMaxSpanPixels / kBlockSize + 1;  // and one that is empty

// The runs with a covered sample, of one triangle after the other; their members apart, so that lanes write them.
struct RunList {
  static constexpr uint32_t kCapacity = 8 * kMaxRunsOfTriangle;

  std::array<uint32_t, kCapacity> places;  // pixel + (primitive << kPixelBits)
  std::array<uint32_t, kCapacity> samples;
  uint32_t count = 0;
  uint32_t primitive = 0;  // of the runs that are added
  int32_t tile_left = 0;   // pixels
  int32_t tile_top = 0;

  static constexpr uint32_t kPixelBits = 12;
  static_assert(kTileSize * kTileSize == 1 << kPixelBits);

  // Lanes write beyond the last run.
  [[nodiscard]] bool has_room() const { return count + kMaxRunsOfTriangle + kBlockSize <= kCapacity; }

  [[nodiscard, gnu::always_inline]] PixelRun run(uint32_t i) const {
    return {places[i] % (1U << kPixelBits), samples[i], places[i] >> kPixelBits};
  }
  // Run i is run `from`, of which these samples are left.
  [[gnu::always_inline]] void keep(uint32_t i, uint32_t from, uint32_t samples_left) {
    places[i] = places[from];
    samples[i] = samples_left;
  }
};

// Asked of each pair of corners, without branches: which corner is the least cannot be foreseen.
[[gnu::always_inline]] inline bool is_small(const std::array<FixedPosition, 3>& triangle, const PixelRect& rect) {
  constexpr uint32_t kSmallExtent = 1 << 13;
  const auto& [a, b, c] = triangle;
  const auto are_near = [](int32_t p, int32_t q) {
    return static_cast<uint32_t>(p) - static_cast<uint32_t>(q) + (kSmallExtent - 1) < 2 * kSmallExtent - 1 ? 1U : 0U;
  };
  const uint32_t all_near = are_near(a.x_fixed, b.x_fixed) & are_near(b.x_fixed, c.x_fixed) &
                            are_near(c.x_fixed, a.x_fixed) & are_near(a.y_fixed, b.y_fixed) &
                            are_near(b.y_fixed, c.y_fixed) & are_near(c.y_fixed, a.y_fixed);
  return rect.width() <= kMaxSpanPixels && rect.height() <= kMaxSpanPixels && all_near != 0;
}

// One edge on as many rows as lanes hold, for one sample after the other.
template <typename L, uint32_t kSamples>
class SpanEdge {
 public:
  [[gnu::always_inline]] SpanEdge(const FixedPosition& from, const FixedPosition& to, const SpanSamples& samples,
                                  uint32_t subpixel_bits, const PixelRect& rect) {
    const int32_t dx = to.x_fixed - from.x_fixed;
    const int32_t dy = to.y_fixed - from.y_fixed;
    // By signs, not by comparisons, of which compilers make branches; directions cannot be foreseen. A pixel on the
    // edge is excluded unless is_top_left(dx, dy).
    const auto is_negative = [](int32_t value) { return static_cast<uint32_t>(value) >> 31U; };
    const uint32_t up = is_negative(dy);
    const uint32_t down = is_negative(-dy);
    const auto excluded = static_cast<int32_t>(down | ((up | is_negative(-dx)) ^ 1U));
    const auto x = L::load(samples.x_fixed.data()) + ((rect.left << subpixel_bits) - from.x_fixed);
    const auto y = L::load(samples.y_fixed.data()) + ((rect.top << subpixel_bits) - from.y_fixed);
    const auto value = (y * dx - x * dy - excluded) >> static_cast<int32_t>(subpixel_bits);
    value_ = L::to_float(value);
    step_y_ = static_cast<float>(dx * static_cast<int32_t>(L::kWidth / kSamples));
    scale_ = dy == 0 ? kBeyondRow : 1 / static_cast<float>(dy == 0 ? 1 : dy);
    const size_t direction = 1 + down - up;
    begin_ = kBegins[direction];
    end_ = kEnds[direction];
  }

  // Narrows the spans of these rows to what is inside, and steps to the next rows. A span's ends have a fraction
  // still, which is to be cut off.
  [[gnu::always_inline]] void narrow(typename L::Float& begins, typename L::Float& ends) {
    const typename L::Float quotient = value_ * L::all(scale_);
    begins = L::greater(quotient + L::all(begin_), begins);
    ends = L::lesser(quotient + L::all(end_), ends);
    value_ = value_ + L::all(step_y_);
  }

 private:
  // What is added to quotients, of edges that go up, are horizontal and go down. The sums begin with 1: what is cut
  // off after it is rounded up.
  static constexpr float kToTheSide = 0x1p-15F;
  static constexpr float kNone = std::numeric_limits<float>::infinity();
  // Horizontal: inside on all of a row or on nothing of it, 0 and more being inside.
  static constexpr float kBeyondRow = 4096;
  static constexpr std::array<float, 3> kBegins{1 - kToTheSide, -kNone, -kNone};
  static constexpr std::array<float, 3> kEnds{kNone, kBeyondRow / 2, 1 + kToTheSide};

  typename L::Float value_;
  float step_y_;
  float scale_;
  float begin_;
  float end_;
};

// The spans of as many rows of pixels as lanes hold, lane by lane: pixels from the left of the rectangle.
template <typename L>
struct LaneSpans {
  typename L::Int begins;
  typename L::Int ends;
};

// Where runs are added.
struct RunWriter {
  const PixelRect rect;
  RunList& list;
  uint32_t count;        // kept here: what is in the list would be read again after each run
  uint32_t first_place;  // of the rectangle's first pixel and the triangle

  RunWriter(const PixelRect& rect_of_runs, RunList& of_runs)
      : rect(rect_of_runs),
        list(of_runs),
        count(of_runs.count),
        first_place(static_cast<uint32_t>((rect.top - of_runs.tile_top) * kTileSize + rect.left - of_runs.tile_left) +
                    (of_runs.primitive << RunList::kPixelBits)) {}

  // At a pixel and a row of the rectangle; not if there is nothing.
  [[gnu::always_inline]] void add(int32_t column, int32_t row, uint32_t samples) {
    list.places[count] = first_place + static_cast<uint32_t>(column + row * kTileSize);
    list.samples[count] = samples;
    count += samples != 0 ? 1 : 0;
  }

  // The same lane by lane, in rows one below the other.
  template <typename L>
  [[gnu::always_inline]] void add(const typename L::Int& columns, int32_t first_row, const typename L::Int& samples) {
    const uint64_t in_rect = (uint64_t{1} << static_cast<uint32_t>(rect.height() - first_row)) - 1;
    const auto covered = static_cast<uint32_t>(L::nonzero_bits(samples) & in_rect);
    const auto first = static_cast<int32_t>(first_place) + first_row * kTileSize;
    L::store_packed(covered, L::numbers() * kTileSize + first + columns, list.places.data() + count);
    L::store_packed(covered, samples, list.samples.data() + count);
    count += static_cast<uint32_t>(std::popcount(covered));
  }
};

// Of one sample: from the first pixel of each span, and so many on, the runs of as many rows as there are lanes.
template <typename L>
[[gnu::always_inline]] inline void add_runs(const LaneSpans<L>& spans, int32_t first_row, int32_t first_pixel,
                                            RunWriter& writer) {
  const auto begins = spans.begins + first_pixel;
  const auto lengths = L::lesser(L::greater(spans.ends - begins, L::all(0)), L::all(kBlockSize));
  writer.template add<L>(begins, first_row, (1 << lengths) - 1);
}

// Spans of four samples that were kept, row by row and sample by sample: pixels from the first one of any of the
// row's samples, which are few enough for bytes.
struct RowSpans {
  static constexpr size_t kRows = kMaxSpanPixels + kBlockSize;  // lanes write beyond the last row
  std::array<int8_t, 4 * kRows> begins;
  std::array<int8_t, 4 * kRows> ends;
  std::array<int8_t, 4 * kRows> firsts;  // of the first pixel: from the left of the rectangle

  // From row `row` on, as many rows as lanes hold.
  template <typename L>
  [[gnu::always_inline]] void keep(int32_t row, const LaneSpans<L>& spans, const typename L::Int& first_pixels) {
    const size_t first = 4 * static_cast<size_t>(row);
    put<L>(spans.begins - first_pixels, begins.data() + first);
    put<L>(spans.ends - first_pixels, ends.data() + first);
    put<L>(first_pixels, firsts.data() + first);
  }

 private:
  template <typename L>
  [[gnu::always_inline]] static void put(const typename L::Int& values, int8_t* bytes) {
    const uint64_t low = L::low_bytes(values);
    std::memcpy(bytes, &low, L::kWidth);
  }
};

// Of four samples: from the first pixel of each row's spans, and so many on, the row's run.
template <typename L>
[[gnu::always_inline]] inline void add_runs(const RowSpans& spans, int32_t first_pixel, RunWriter& writer) {
  for (int32_t row = 0; row < writer.rect.height(); ++row) {
    const size_t first = 4 * static_cast<size_t>(row);
    writer.add(spans.firsts[first] + first_pixel, row,
               L::within_four(first_pixel, spans.begins.data() + first, spans.ends.data() + first));
  }
}

// Adds the runs of a triangle with positive area.
template <typename L, uint32_t kSamples>
[[gnu::always_inline]] inline void add_spans(const FixedPosition& a, const FixedPosition& b, const FixedPosition& c,
                                             const SpanSamples& samples, uint32_t subpixel_bits, RunWriter& writer) {
  static_assert(kSamples == 1 || kSamples == 4, "RowSpans are of four samples");
  const PixelRect& rect = writer.rect;
  SpanEdge<L, kSamples> edge0(a, b, samples, subpixel_bits, rect);
  SpanEdge<L, kSamples> edge1(b, c, samples, subpixel_bits, rect);
  SpanEdge<L, kSamples> edge2(c, a, samples, subpixel_bits, rect);
  const auto width = L::all(static_cast<float>(rect.width()));
  auto longest = L::all(0.0F);
  RowSpans kept;
  constexpr auto kRows = static_cast<int32_t>(L::kWidth / kSamples);
  for (int32_t row = 0; row < rect.height(); row += kRows) {
    auto begins = L::all(0.0F);
    auto ends = width;
    edge0.narrow(begins, ends);
    edge1.narrow(begins, ends);
    edge2.narrow(begins, ends);
    // Within the row, so that an empty span ends at or before its beginning but not far away.
    const LaneSpans<L> spans{L::truncated(L::lesser(begins, width)), L::truncated(L::greater(ends, L::all(0.0F)))};
    if constexpr (kSamples == 1) {
      for (int32_t pixel = 0; pixel < rect.width(); pixel += kBlockSize) {
        add_runs<L>(spans, row, pixel, writer);
      }
    } else {
      const auto firsts = L::template least_of_each<kSamples>(L::to_float(spans.begins));
      const auto lasts = L::template greatest_of_each<kSamples>(L::to_float(spans.ends));
      longest = L::greater(lasts - firsts, longest);
      kept.keep<L>(row, spans, L::truncated(firsts));
    }
  }
  if constexpr (kSamples > 1) {
    add_runs<L>(kept, 0, writer);
    for (int32_t pixel = kBlockSize; pixel < rect.width() && L::any(longest > L::all(static_cast<float>(pixel)));
         pixel += kBlockSize) {
      add_runs<L>(kept, pixel, writer);
    }
  }
}

// Adds the covered samples of a small triangle, positively oriented or not, within the rectangle.
template <typename L, uint32_t kSamples>
[[gnu::always_inline]] inline void cover_small(const std::array<FixedPosition, 3>& triangle,
                                               const SpanSamples& samples, uint32_t subpixel_bits,
                                               const PixelRect& rect, RunList& list) {
  const int64_t area = doubled_area(triangle[0], triangle[1], triangle[2]);
  if (area == 0) {
    return;
  }
  const size_t turned = area < 0 ? 1 : 0;  // which cannot be foreseen: no branch
  RunWriter writer(rect, list);
  add_spans<L, kSamples>(triangle[0], triangle[1 + turned], triangle[2 - turned], samples, subpixel_bits, writer);
  list.count = writer.count;
}

// Of a triangle's covered pixels (SetupPrimitive::covered_pixels()) those that are within the rectangle, as they are.
[[gnu::always_inline]] inline uint32_t covered_within(const SetupPrimitive& triangle, const PixelRect& rect) {
  constexpr auto kWidth = static_cast<uint32_t>(SetupPrimitive::kCoveredWidth);
  const auto before = static_cast<uint32_t>(rect.left - triangle.left);
  const uint32_t columns = ((1U << static_cast<uint32_t>(rect.width())) - 1) << before;
  const auto rows_before = static_cast<uint32_t>(rect.top - triangle.top);
  const auto rows = static_cast<uint32_t>(rect.height());
  const uint32_t in_rows = ~uint32_t{0} >> (32 - rows * kWidth) << (rows_before * kWidth);
  return triangle.covered_pixels() & in_rows & columns * 0x01010101U;
}

// Adds those pixels, of one sample each.
[[gnu::always_inline]] inline void add_covered(const SetupPrimitive& triangle, const PixelRect& rect, RunList& list) {
  RunWriter writer(rect, list);
  const auto first_row = static_cast<uint32_t>(rect.top - triangle.top);
  uint32_t rest = covered_within(triangle, rect) >> first_row * SetupPrimitive::kCoveredWidth;
  for (int32_t row = 0; row < rect.height(); ++row, rest >>= SetupPrimitive::kCoveredWidth) {
    writer.add(0, row, (rest & 0xFF) >> (rect.left - triangle.left));
  }
  list.count = writer.count;
}

}  // namespace fillrule::renderer::internal
