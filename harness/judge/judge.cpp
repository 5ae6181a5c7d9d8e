#include "harness/judge/judge.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <string>

#include "harness/judge/judged_party.h"

namespace fillrule::judge {
namespace {

using Class = Standing::Class;

bool is_value(PlaneKind kind) {
  return kind == PlaneKind::kDepth || kind == PlaneKind::kVarying;
}

Verdict combine(const Standing& candidate, const Standing* reference, bool equal_bits) {
  const bool reference_outside = reference != nullptr && reference->outside();
  if (candidate.outside()) return reference_outside ? Verdict::kBothFault : Verdict::kCandidateFault;
  if (reference_outside) return Verdict::kReferenceFault;
  if (reference != nullptr && equal_bits) return Verdict::kIdentical;
  if (candidate.level == Class::kImprecise || (reference != nullptr && reference->level == Class::kImprecise)) {
    return Verdict::kImprecise;
  }
  return reference == nullptr && candidate.level == Class::kExact ? Verdict::kIdentical : Verdict::kPermitted;
}

// Where numbers that are equal to the first end; several at a time.
size_t end_of_equal(const std::vector<uint32_t>& numbers, size_t begin, size_t limit) {
  constexpr size_t kAtOnce = 16;
  size_t end = begin + 1;
  for (; end + kAtOnce <= limit; end += kAtOnce) {
    uint32_t difference = 0;
    for (size_t i = 0; i < kAtOnce; ++i) difference |= numbers[end + i] ^ numbers[begin];
    if (difference != 0) break;
  }
  while (end < limit && numbers[end] == numbers[begin]) ++end;
  return end;
}

std::vector<PlaneVerdict> planes_of(const Case& test_case, bool with_depth) {
  std::vector<PlaneVerdict> planes{{.name = "coverage", .kind = PlaneKind::kCoverage},
                                   {.name = "hits", .kind = PlaneKind::kHits},
                                   {.name = "owner", .kind = PlaneKind::kOwner},
                                   {.name = "front_facing", .kind = PlaneKind::kFrontFacing}};
  if (with_depth) planes.push_back({.name = "depth", .kind = PlaneKind::kDepth});
  uint32_t component = 0;
  for (const Varying& varying : test_case.varyings) {
    planes.push_back({.name = varying.name,
                      .kind = PlaneKind::kVarying,
                      .first_component = component,
                      .components = varying.components});
    component += varying.components;
  }
  return planes;
}

class CaseJudge {
 public:
  CaseJudge(const Case& test_case, JudgedParty& candidate, JudgedParty* reference, const Settings& settings)
      : case_(test_case), candidate_(candidate), reference_(reference), settings_(settings) {}

  CaseVerdict run() {
    const Planes& planes = *candidate_.party.planes;
    CaseVerdict verdict{.planes = planes_of(case_, !planes.depth.empty())};
    verdict.samples = planes.hits.size();
    if (settings_.keep_maps) {
      for (PlaneVerdict& plane : verdict.planes) plane.map.assign(verdict.samples, Verdict::kIdentical);
      verdict.oracle.resize(verdict.samples);
    }
    const size_t row = size_t{planes.width} * planes.samples;
    for (size_t begin = 0; begin < verdict.samples;) {
      const size_t end = end_of_run(begin, row);
      judge_run(verdict, begin, end);
      begin = end;
    }
    return verdict;
  }

 private:
  [[nodiscard]] bool has_reference() const { return reference_ != nullptr; }
  // Whether what is exact for the candidate is not the same for the reference.
  [[nodiscard]] bool reference_differs() const {
    return has_reference() && &reference_->answers != &candidate_.answers;
  }

  // Samples [begin, end) of one class for both oracles: of one row, unless nothing lands there.
  [[nodiscard]] size_t end_of_run(size_t begin, size_t row) const {
    const std::vector<uint32_t>& classes = candidate_.answers.expectation.classes();
    const std::vector<uint32_t>& other = has_reference() ? reference_->answers.expectation.classes() : classes;
    const bool nothing = classes[begin] == exact::kNothing && other[begin] == exact::kNothing;
    const size_t limit = nothing ? classes.size() : begin - begin % row + row;
    size_t end = end_of_equal(classes, begin, limit);
    if (&other != &classes) end = end_of_equal(other, begin, end);
    return end;
  }

  // Whether it is certain for both parties what lands at the run.
  bool start_bulk(size_t begin, size_t end) {
    return candidate_.answers.rows.start(begin, end) &&
           (!reference_differs() || reference_->answers.rows.start(begin, end));
  }

  void judge_run(CaseVerdict& verdict, size_t begin, size_t end) {
    const bool in_bulk = start_bulk(begin, end);
    if (!in_bulk && !settings_.keep_maps && !reference_differs()) {
      judge_layers(verdict, begin, end);
      return;
    }
    if (in_bulk && candidate_.answers.rows.top() != kNoOwner) verdict.covered_samples += end - begin;
    judge_planes(verdict, begin, end, in_bulk);
  }

  // Samples of one class at which several pieces may land, or one fail the depth test. Where the same is certain from
  // one end to the other they are judged at once; else each half is, down to a few.
  void judge_layers(CaseVerdict& verdict, size_t begin, size_t end) {
    constexpr size_t kFew = 4;
    if (end - begin <= kFew || !candidate_.replay.may_tell_between(begin)) {
      judge_few_layers(verdict, begin, end);
      return;
    }
    const std::optional<Landed> top = certain_landing(begin, end);
    if (top) {
      judge_top(verdict, top, begin, end);
      return;
    }
    const size_t middle = begin + (end - begin) / 2;
    judge_layers(verdict, begin, middle);
    judge_layers(verdict, middle, end);
  }

  // The same sample by sample. Wherever it is certain which piece is on top, neighbours of the same one are judged at
  // once.
  void judge_few_layers(CaseVerdict& verdict, size_t begin, size_t end) {
    std::optional<Landed> top;
    size_t first = begin;
    for (size_t index = begin; index < end; ++index) {
      const std::optional<Landed> here = certain_landing(index, index + 1);
      if (here && here == top) continue;
      judge_top(verdict, top, first, index);
      top = here;
      first = index;
      if (here) continue;
      // At once: what is possible here has just been worked out.
      judge_top(verdict, here, index, index + 1);
      first = index + 1;
    }
    judge_top(verdict, top, first, end);
  }

  void judge_top(CaseVerdict& verdict, const std::optional<Landed>& top, size_t begin, size_t end) {
    if (begin == end) return;
    const bool in_bulk = top && candidate_.answers.rows.start_top(*top, begin, end);
    if (in_bulk && top->hits > 0) verdict.covered_samples += end - begin;
    judge_planes(verdict, begin, end, in_bulk);
  }

  // What lands at all samples [begin, end), of one class and row, whatever rounding does, if that is certain for
  // every party, and the same.
  std::optional<Landed> certain_landing(size_t begin, size_t end) {
    Replay& replay = candidate_.replay;
    if (!replay.is_same_between(begin, end - 1) || replay.used_rules()) return std::nullopt;
    return landed_of(replay.at(end - 1));
  }

  // Samples [begin, end) of one outcome, if it is certain (`in_bulk`): all planes at once where all values are right.
  void judge_planes(CaseVerdict& verdict, size_t begin, size_t end, bool in_bulk) {
    const bool try_bulk = in_bulk && !settings_.keep_maps;
    const bool integers = try_bulk && integers_right();
    size_t open = 0;  // planes that have to be judged sample by sample
    open_planes_.assign(verdict.planes.size(), 0);
    for (size_t p = 0; p < verdict.planes.size(); ++p) {
      PlaneVerdict& plane = verdict.planes[p];
      const bool right = is_value(plane.kind) ? try_bulk && judge_values(plane, end - begin) : integers;
      if (right && !is_value(plane.kind)) count(plane, Verdict::kIdentical, end - begin);
      open_planes_[p] = right ? 0 : 1;
      open += right ? 0 : 1;
    }
    if (open == 0) return;
    for (size_t index = begin; index < end; ++index) judge_sample(verdict, index, !in_bulk);
  }

  static void count(PlaneVerdict& plane, Verdict verdict, uint64_t samples) {
    plane.counts[static_cast<size_t>(verdict)] += samples;
  }

  [[nodiscard]] bool integers_right() const {
    return candidate_.answers.rows.integers_right(*candidate_.party.planes) &&
           (!has_reference() || reference_->answers.rows.integers_right(*reference_->party.planes));
  }

  // The run of one plane of values, where every value of both parties is well within its tolerance; false where it is
  // not.
  bool judge_values(PlaneVerdict& plane, size_t size) {
    const Planes& planes = *candidate_.party.planes;
    const Planes* const other = has_reference() ? reference_->party.planes : nullptr;
    RowJudge& rows = candidate_.answers.rows;
    bool marked = false;  // nearly always both parties have the same bits
    for (uint32_t c = plane.first_component; c < plane.first_component + plane.components; ++c) {
      if (!rows.expect(plane.kind, c) || !rows.within(planes)) return false;
      if (reference_differs() && !reference_->answers.rows.expect(plane.kind, c)) return false;
      const bool different = other == nullptr || rows.differ(planes, *other);
      // Equal bits are as good for both, where the same is exact.
      if (other != nullptr && (different || reference_differs()) && !reference_->answers.rows.within(*other)) {
        return false;
      }
      if (!different) continue;
      if (!marked) marks_.assign(size, 0);
      marked = true;
      rows.mark_different(planes, other, marks_);
    }
    const auto identical = marked ? static_cast<uint64_t>(std::count(marks_.begin(), marks_.end(), 0U)) : size;
    count(plane, Verdict::kIdentical, identical);
    count(plane, Verdict::kPermitted, size - identical);
    return true;
  }

  void judge_sample(CaseVerdict& verdict, size_t index, bool count_sample) {
    candidate_.possible = &candidate_.replay.at(index);
    if (reference_ != nullptr) {
      const bool same = !reference_differs() && !candidate_.replay.used_rules();
      reference_->possible = same ? candidate_.possible : &reference_->replay.at(index);
    }
    const Possibilities& possible = *candidate_.possible;
    if (count_sample) verdict.covered_samples += possible.most_hits > 0 || possible.in_doubt ? 1 : 0;
    verdict.may_samples += possible.in_doubt ? 1 : 0;
    verdict.undefined_samples += possible.undefined ? 1 : 0;
    if (settings_.keep_maps) verdict.oracle[index] = answer_of(possible);
    const bool is_empty = count_sample && is_empty_anywhere(index);
    if (is_empty && repeats_empty(index)) {
      for (size_t p = 0; p < verdict.planes.size(); ++p) count(verdict.planes[p], empty_.verdicts[p], 1);
      return;
    }
    verdicts_.clear();
    for (size_t p = 0; p < verdict.planes.size(); ++p) {
      if (open_planes_[p] == 0) continue;
      PlaneVerdict& plane = verdict.planes[p];
      SampleRecord sample = judge_component(plane.kind, plane.first_component, index);
      for (uint32_t c = 1; c < plane.components; ++c) {
        SampleRecord other = judge_component(plane.kind, plane.first_component + c, index);
        other.component = c;
        if (graver(other, sample)) sample = other;
      }
      count(plane, sample.verdict, 1);
      verdicts_.push_back(sample.verdict);
      if (settings_.keep_maps) plane.map[index] = sample.verdict;
      if (sample.verdict <= Verdict::kPermitted) continue;
      const exact::SamplePlace place = exact::sample_place(case_.target, index);
      sample.x = place.x;
      sample.y = place.y;
      sample.sample = place.sample;
      record(plane, sample);
      if (settings_.keep_maps) keep_worst(plane.worst_samples, sample);
    }
    if (is_empty) keep_empty(index);
  }

  // Whether nobody shows anything at the sample: then no value depends on the place.
  [[nodiscard]] bool is_empty_anywhere(size_t index) const {
    if (settings_.keep_maps || settings_.profile.same_bits) return false;
    return is_empty_anywhere(candidate_, index) && (!has_reference() || is_empty_anywhere(*reference_, index));
  }
  static bool is_empty_anywhere(const JudgedParty& party, size_t index) {
    const Planes& planes = *party.party.planes;
    return planes.hits[index] == 0 && planes.owner[index] == kNoOwner && !party.judge.breaks_line_rule(index);
  }

  // The verdicts of an empty sample hold for others of the same possibilities and values.
  struct Empty {
    size_t index = 0;
    std::array<uint64_t, 2> replays{};  // Replay::number() of the parties; 0: none yet
    std::vector<Verdict> verdicts;      // plane by plane; none worth a record
  };
  [[nodiscard]] std::array<uint64_t, 2> replays() const {
    const bool differs = has_reference() && reference_->possible != candidate_.possible;
    return {candidate_.replay.number(), differs ? reference_->replay.number() : 0};
  }
  [[nodiscard]] bool repeats_empty(size_t index) const {
    return replays() == empty_.replays && has_same_values(*candidate_.party.planes, empty_.index, index) &&
           (!has_reference() || has_same_values(*reference_->party.planes, empty_.index, index));
  }
  void keep_empty(size_t index) {
    if (std::ranges::max(verdicts_) > Verdict::kPermitted) return;
    empty_.index = index;
    empty_.replays = replays();
    empty_.verdicts = verdicts_;
  }
  // To the bit, of two samples where nothing is shown.
  static bool has_same_values(const Planes& planes, size_t a, size_t b) {
    const auto same = [a, b](const std::vector<float>& plane) {
      return std::bit_cast<uint32_t>(plane[a]) == std::bit_cast<uint32_t>(plane[b]);
    };
    return planes.front_facing[a] == planes.front_facing[b] && (planes.depth.empty() || same(planes.depth)) &&
           std::ranges::all_of(planes.varyings, same);
  }

  // Without the place, which few records need.
  SampleRecord judge_component(PlaneKind kind, uint32_t component, size_t index) {
    const PlaneValue candidate_value = value_of(*candidate_.party.planes, kind, component, index);
    const Standing judged = candidate_.standing_of(kind, component, index);
    Standing candidate = judged;
    if (settings_.profile.precise && candidate.level == Class::kImprecise) candidate.level = Class::kOutside;
    SampleRecord sample{.candidate = candidate_value.number,
                        .expected = candidate.expected,
                        .tolerance = candidate.tolerance,
                        .severity = candidate.severity};
    if (reference_ == nullptr) {
      sample.verdict = combine(candidate, nullptr, false);
      return sample;
    }
    const PlaneValue reference_value = value_of(*reference_->party.planes, kind, component, index);
    const bool equal_bits = candidate_value.bits == reference_value.bits;
    const Standing reference = equal_bits && stand_alike(candidate_, *reference_, kind, index)
                                   ? judged
                                   : reference_->standing_of(kind, component, index);
    if (!equal_bits && !reference.outside() && must_have_same_bits(kind, index)) candidate.level = Class::kOutside;
    sample.reference = reference_value.number;
    sample.verdict = combine(candidate, &reference, equal_bits);
    if (sample.verdict == Verdict::kReferenceFault) {
      sample.expected = reference.expected;
      sample.tolerance = reference.tolerance;
    }
    sample.severity = std::max(candidate.severity, reference.severity);
    return sample;
  }

  [[nodiscard]] bool must_have_same_bits(PlaneKind kind, size_t index) const {
    if (!settings_.profile.same_bits || candidate_.party.subpixel_bits != reference_->party.subpixel_bits)
      return false;
    if (kind != PlaneKind::kCoverage && kind != PlaneKind::kHits && kind != PlaneKind::kOwner) return false;
    const exact::Expectation& expectation = candidate_.answers.expectation;
    std::vector<exact::Entry> entries;
    expectation.collect(index, entries);
    for (const exact::Entry& entry : entries) {
      const exact::Piece& piece = expectation.pieces()[entry.piece];
      if (!piece.shape->inside_volume() || piece.shape->undefined()) return false;
      // Which fragments a Bresenham line has is left open by more than rounding.
      if (piece.kind == exact::Piece::Kind::kBresenhamLine) return false;
      // Depth within the tolerance of what is stored may pass on one side and fail on the other.
      const RasterState& state = case_.draws[piece.draw].state;
      // Where rounding may turn a primitive over, culling may go either way, as facing may be found before or after.
      if (piece.facing_in_doubt && state.cull_mode != VK_CULL_MODE_NONE) return false;
      if ((state.depth_test || state.depth_bounds) &&
          candidate_.possible->least_hits != candidate_.possible->most_hits)
        return false;
    }
    return true;
  }

  const Case& case_;
  JudgedParty& candidate_;
  JudgedParty* reference_;
  const Settings& settings_;
  std::vector<uint8_t> open_planes_;
  std::vector<uint32_t> marks_;
  std::vector<Verdict> verdicts_;  // of the sample that was judged last
  Empty empty_;
};

}  // namespace

std::string to_string(const Profile& profile) {
  std::string names;
  for (const ProfilePart& part : kProfileParts) {
    if (!(profile.*part.member)) continue;
    if (!names.empty()) names += ',';
    names += part.name;
  }
  return names;
}

Oracle::Oracle(const Case& test_case, uint32_t candidate_bits, std::optional<uint32_t> reference_bits)
    : for_candidate_(test_case, candidate_bits) {
  if (reference_bits && *reference_bits != candidate_bits) for_reference_.emplace(test_case, *reference_bits);
}

CaseVerdict judge(const Case& test_case, const Oracle& oracle, const Party& candidate, const Party* reference,
                  const Settings& settings) {
  ExactAnswers for_candidate(test_case, oracle.for_candidate());
  JudgedParty judged_candidate(
      test_case, candidate, for_candidate,
      {.top_left = settings.profile.top_left, .diamond_exit = settings.profile.diamond_exit});
  if (reference == nullptr) return CaseJudge(test_case, judged_candidate, nullptr, settings).run();
  std::optional<ExactAnswers> for_reference;
  if (&oracle.for_reference() != &oracle.for_candidate()) for_reference.emplace(test_case, oracle.for_reference());
  JudgedParty judged_reference(test_case, *reference, for_reference ? *for_reference : for_candidate, {});
  return CaseJudge(test_case, judged_candidate, &judged_reference, settings).run();
}

CaseVerdict judge(const Case& test_case, const Party& candidate, const Party* reference, const Settings& settings) {
  const std::optional<uint32_t> bits = reference != nullptr ? std::optional(reference->subpixel_bits) : std::nullopt;
  return judge(test_case, Oracle(test_case, candidate.subpixel_bits, bits), candidate, reference, settings);
}

}  // namespace fillrule::judge
