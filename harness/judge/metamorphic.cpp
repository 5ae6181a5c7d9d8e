#include "harness/judge/metamorphic.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

#include "harness/judge/variants.h"
#include "reference/exact/expectation.h"

namespace fillrule::judge {
namespace {

using Outcome = CheckResult::Outcome;

constexpr int kScaleExponent = 6;
// Numbers of threads that divide no common tile count.
constexpr std::array<uint32_t, 2> kThreadCounts{2, 5};

CheckResult passed(std::string_view name) {
  return {.name = std::string(name)};
}

CheckResult failed(std::string_view name, std::string message) {
  return {.name = std::string(name), .outcome = Outcome::kFailed, .message = std::move(message)};
}

// What a difference means, for somebody who has not read what the check does.
struct Meaning {
  std::string_view check;
  std::string_view text;
};
constexpr std::array<Meaning, kChecks.size()> kMeanings{{
    {"second_run", "in a second drawing of the same case"},
    {"any_number_of_threads", "though nothing else was changed"},
    {"rotated_vertices",
     "where each triangle begins with its next vertex: coverage or facing depends on where one begins"},
    {"flipped_winding",
     "where winding and front face are both turned over: facing or culling does not go by the two together"},
    {"scaled_clip_space", "where x, y, z and w are all 64 times as large, which is the same geometry"},
    {"partition", "of what a clip distance and its negative leave: they cut the whole, and something more or less"},
    {"scissor_crop", "under a smaller scissor: it cuts at other borders than it has, or changes what is inside"},
}};

static_assert(std::ranges::is_permutation(kMeanings, kChecks, {}, &Meaning::check));

CheckResult differs(std::string_view name, const std::string& difference) {
  const auto* const meaning = std::ranges::find(kMeanings, name, &Meaning::check);
  return failed(name, fmt::format("{}, {}", difference, meaning->text));
}

CheckResult does_not_fit(std::string_view name, std::string reason) {
  return {.name = std::string(name), .outcome = Outcome::kDoesNotFit, .message = std::move(reason)};
}

// Where two planes differ first in their bits, if they do.
template <typename T>
std::optional<size_t> first_difference(const std::vector<T>& a, const std::vector<T>& b) {
  static_assert(sizeof(T) == 4);
  if (a.size() != b.size()) return 0;
  if (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0) return std::nullopt;
  size_t i = 0;
  while (std::bit_cast<uint32_t>(a[i]) == std::bit_cast<uint32_t>(b[i])) ++i;
  return i;
}

std::string place(std::string_view plane, size_t index, const Planes& planes) {
  const size_t pixel = index / planes.samples;
  return fmt::format("{} differs at ({}, {})", plane, pixel % planes.width, pixel / planes.width);
}

std::string differing_coverage(const Planes& a, const Planes& b, bool with_facing) {
  if (const auto at = first_difference(a.hits, b.hits)) return place("hits", *at, a);
  if (const auto at = first_difference(a.owner, b.owner)) return place("owner", *at, a);
  if (!with_facing) return {};
  if (const auto at = first_difference(a.front_facing, b.front_facing)) return place("front_facing", *at, a);
  return {};
}

constexpr const char* kNotFilled = "not all of it is filled triangles";

// A rectangle of a picture, in which pictures may be alike while the rest is cleared.
struct Crop {
  const Planes& picture;
  const VkRect2D& rectangle;

  // Where the plane differs first from the picture's inside, or from the cleared value outside.
  template <typename T>
  [[nodiscard]] std::optional<size_t> first_difference(const std::vector<T>& inside, T cleared,
                                                       const std::vector<T>& plane) const {
    static_assert(sizeof(T) == 4);
    if (plane.size() != inside.size()) return 0;
    if (plane.empty()) return std::nullopt;
    std::vector<T> expected;
    const size_t row = size_t{picture.width} * picture.samples;
    const size_t left = static_cast<size_t>(rectangle.offset.x) * picture.samples;
    const size_t right = left + size_t{rectangle.extent.width} * picture.samples;
    const auto top = static_cast<size_t>(rectangle.offset.y);
    for (size_t y = 0; y < picture.height; ++y) {
      expected.assign(row, cleared);
      if (y >= top && y < top + rectangle.extent.height) {
        std::memcpy(&expected[left], &inside[y * row + left], (right - left) * sizeof(T));
      }
      const T* const found = &plane[y * row];
      if (std::memcmp(expected.data(), found, row * sizeof(T)) == 0) continue;
      size_t x = 0;
      while (std::bit_cast<uint32_t>(expected[x]) == std::bit_cast<uint32_t>(found[x])) ++x;
      return y * row + x;
    }
    return std::nullopt;
  }
};

// The same for all planes, in words.
std::string differing_crop(const Planes& whole, const VkRect2D& rectangle, float clear_depth, const Planes& planes) {
  const Crop crop{.picture = whole, .rectangle = rectangle};
  if (const auto at = crop.first_difference(whole.hits, 0U, planes.hits)) return place("hits", *at, whole);
  if (const auto at = crop.first_difference(whole.owner, kNoOwner, planes.owner)) return place("owner", *at, whole);
  if (const auto at = crop.first_difference(whole.front_facing, 0U, planes.front_facing)) {
    return place("front_facing", *at, whole);
  }
  if (const auto at = crop.first_difference(whole.depth, clear_depth, planes.depth))
    return place("depth", *at, whole);
  for (size_t c = 0; c < whole.varyings.size(); ++c) {
    if (const auto at = crop.first_difference(whole.varyings[c], 0.0F, planes.varyings[c])) {
      return place(fmt::format("varying component {}", c), *at, whole);
    }
  }
  return {};
}

// The samples where the hits of two parts do not add up to those of the whole.
std::vector<size_t> differing_sums(const Planes& whole, const Planes& one, const Planes& other) {
  // Nearly everywhere they do: so many samples at once are found to.
  constexpr size_t kAtOnce = 64;
  std::vector<size_t> differing;
  const size_t size = whole.hits.size();
  for (size_t begin = 0; begin < size; begin += kAtOnce) {
    const size_t end = std::min(begin + kAtOnce, size);
    uint32_t difference = 0;
    for (size_t i = begin; i < end; ++i) difference |= (one.hits[i] + other.hits[i]) ^ whole.hits[i];
    if (difference == 0) continue;
    for (size_t i = begin; i < end; ++i) {
      if (one.hits[i] + other.hits[i] != whole.hits[i]) differing.push_back(i);
    }
  }
  return differing;
}

class Checker {
 public:
  Checker(const Case& test_case, const CheckedParty& party, const Planes& original)
      : case_(test_case),
        party_(party),
        original_(original),
        drawn_(without_texts(case_)),
        bare_(without_depth_test(without_varyings(drawn_))) {}

  CheckResult run(std::string_view name) {
    if (name == "second_run") return second_run(name);
    if (name == "any_number_of_threads") return any_number_of_threads(name);
    if (name == "rotated_vertices") return rotated_vertices(name);
    if (name == "flipped_winding") return flipped_winding(name);
    if (name == "scaled_clip_space") return scaled_clip_space(name);
    if (name == "partition") return partition(name);
    return scissor_crop(name);
  }

 private:
  // Draws the variant and compares; an error of the party is a failure.
  template <typename Compare>
  CheckResult compare(std::string_view name, const Case& variant, uint32_t threads, const Compare& difference_to) {
    const Result<Planes> planes = party_.draw(variant, threads);
    if (!planes) return failed(name, to_string(planes.error()));
    const std::string difference = difference_to(*planes);
    return difference.empty() ? passed(name) : differs(name, difference);
  }

  CheckResult second_run(std::string_view name) {
    return compare(name, case_, 0, [this](const Planes& planes) { return differing_bytes(original_, planes); });
  }

  CheckResult any_number_of_threads(std::string_view name) {
    for (const uint32_t threads : kThreadCounts) {
      CheckResult result = compare(name, case_, threads, [this, threads](const Planes& planes) {
        const std::string difference = differing_bytes(original_, planes);
        return difference.empty() ? difference : fmt::format("with {} threads {}", threads, difference);
      });
      if (result.outcome == Outcome::kFailed) return result;
    }
    return passed(name);
  }

  CheckResult rotated_vertices(std::string_view name) {
    if (!draws_filled_triangles(case_)) return does_not_fit(name, kNotFilled);
    return compare_coverage(name, as_triangle_list(bare_, {1, 2, 0}));
  }

  CheckResult flipped_winding(std::string_view name) {
    if (!draws_filled_triangles(case_)) return does_not_fit(name, kNotFilled);
    return compare_coverage(name, with_front_faces_flipped(as_triangle_list(bare_, {0, 2, 1})));
  }

  // Against the original without its depth test, drawn once for both checks that need it.
  CheckResult compare_coverage(std::string_view name, const Case& variant) {
    const Result<const Planes*> whole = without_depth_test_drawn();
    if (!whole) return failed(name, to_string(whole.error()));
    return compare(name, variant, 0, [&](const Planes& planes) { return differing_coverage(**whole, planes, true); });
  }

  Result<const Planes*> without_depth_test_drawn() {
    if (!tests_depth(case_)) return &original_;
    if (!without_depth_test_) without_depth_test_ = party_.draw(bare_, 0);
    if (!*without_depth_test_) return tl::unexpected(without_depth_test_->error());
    return &**without_depth_test_;
  }

  CheckResult partition(std::string_view name) {
    if (!party_.features.has(Feature::kClipDistances)) return does_not_fit(name, "it has no user clip distances");
    if (!draws_filled_triangles(case_)) return does_not_fit(name, kNotFilled);
    Case one_side = bare_;
    Case other_side = one_side;
    if (!add_cut(one_side, false) || !add_cut(other_side, true)) {
      return does_not_fit(name, "no clip distance is left");
    }
    const Result<const Planes*> whole = without_depth_test_drawn();
    if (!whole) return failed(name, to_string(whole.error()));
    const Result<Planes> one = party_.draw(one_side, 0);
    if (!one) return failed(name, to_string(one.error()));
    return compare(name, other_side, 0, [&](const Planes& other) -> std::string {
      std::vector<size_t> differing = differing_sums(**whole, *one, other);
      // The oracle is asked of what differs alone.
      if (!differing.empty()) remove_open_samples(one_side, differing);
      if (!differing.empty()) remove_open_samples(other_side, differing);
      return differing.empty() ? std::string() : place("the sum of hits", differing.front(), **whole);
    });
  }

  // Where rounding may cover the sample or not. The cut leaves new vertices on the primitives' own edges, which move
  // them within the latitude: so not only samples along the cut.
  void remove_open_samples(const Case& variant, std::vector<size_t>& samples) const {
    const exact::Expectation expectation(variant, party_.subpixel_bits, samples);
    std::vector<exact::Entry> entries;
    std::erase_if(samples, [&](size_t sample) {
      expectation.collect(sample, entries);
      return std::any_of(entries.begin(), entries.end(),
                         [](const exact::Entry& entry) { return entry.coverage == exact::Coverage::kMay; });
    });
  }

  CheckResult scaled_clip_space(std::string_view name) {
    const bool shows_w = std::any_of(case_.varyings.begin(), case_.varyings.end(), [](const Varying& varying) {
      return varying.source == VaryingSource::kFragCoord;
    });
    if (shows_w) return does_not_fit(name, "gl_FragCoord shows w");
    Case scaled = drawn_;
    if (!scale_clip_space(scaled, kScaleExponent))
      return does_not_fit(name, "scaling leaves the normal float32 numbers");
    return compare(name, scaled, 0, [this](const Planes& planes) -> std::string {
      const std::string difference = differing_bytes(original_, planes);
      if (difference.empty()) return {};
      const Party party{.planes = &planes, .subpixel_bits = party_.subpixel_bits};
      return judge(case_, party, nullptr, {}).candidate_faults() == 0 ? std::string() : difference;
    });
  }

  CheckResult scissor_crop(std::string_view name) {
    const uint32_t width = case_.target.width;
    const uint32_t height = case_.target.height;
    if (width < 2 || height < 2) return does_not_fit(name, "the target is too small to crop");
    // Off-centre and of odd size, so that its sides fall between blocks and tiles.
    const VkRect2D rectangle{.offset = {.x = static_cast<int32_t>(width / 4), .y = static_cast<int32_t>(height / 5)},
                             .extent = {.width = (width / 2) | 1U, .height = (height / 2) | 1U}};
    return compare(name, with_scissor(drawn_, rectangle), 0, [&](const Planes& planes) {
      return differing_crop(original_, rectangle, case_.target.clear_depth, planes);
    });
  }

  const Case& case_;
  const CheckedParty& party_;
  const Planes& original_;
  const Case drawn_;  // what variants are made of
  const Case bare_;   // for the checks of coverage alone: without varyings and depth test
  std::optional<Result<Planes>> without_depth_test_;
};

}  // namespace

std::string differing_bytes(const Planes& a, const Planes& b) {
  if (std::string difference = differing_coverage(a, b, true); !difference.empty()) return difference;
  if (const auto at = first_difference(a.depth, b.depth)) return place("depth", *at, a);
  for (size_t c = 0; c < a.varyings.size(); ++c) {
    if (const auto at = first_difference(a.varyings[c], b.varyings[c])) {
      return place(fmt::format("varying component {}", c), *at, a);
    }
  }
  return {};
}

std::vector<CheckResult> metamorphic_checks(const Case& test_case, const CheckedParty& party,
                                            const Planes& original) {
  Checker checker(test_case, party, original);
  std::vector<CheckResult> results;
  for (const std::string_view name : kChecks) {
    const auto opt_out = std::find_if(test_case.opt_outs.begin(), test_case.opt_outs.end(),
                                      [name](const OptOut& one) { return one.check == name; });
    if (opt_out != test_case.opt_outs.end()) {
      results.push_back({.name = std::string(name), .outcome = Outcome::kOptedOut, .message = opt_out->reason});
    } else {
      results.push_back(checker.run(name));
    }
  }
  return results;
}

}  // namespace fillrule::judge
