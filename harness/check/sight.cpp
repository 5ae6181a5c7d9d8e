#include "harness/check/sight.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "harness/judge/judge.h"
#include "harness/programs/varyings.h"

namespace fillrule::check {
namespace {

// FNV-1a over 32-bit words; NaN payloads and the sign of zero count.
class Digest {
 public:
  void add(uint32_t word) { state_ = (state_ ^ word) * 0x100000001B3U; }
  void add(const std::vector<uint32_t>& values) {
    for (const uint32_t value : values) add(value);
  }
  void add(const std::vector<float>& values) {
    for (const float value : values) add(std::bit_cast<uint32_t>(value));
  }
  [[nodiscard]] uint64_t value() const { return state_; }

 private:
  uint64_t state_ = 0xCBF29CE484222325U;
};

// Where corners are on the subpixel grid our renderer is held to the top-left rule and to the diamond-exit rule, so a
// case of nothing but ties still shows something.
constexpr judge::Settings kStrict{.profile = {.top_left = true, .diamond_exit = true}};

}  // namespace

Result<Sight> look_at(const Case& test_case) {
  const renderer::Options options;
  const Result<Planes> planes = programs::draw_case(test_case, options);
  if (!planes) return tl::unexpected(planes.error());
  Sight sight;
  sight.drawn = planes->hits.size() - static_cast<uint64_t>(std::ranges::count(planes->hits, 0U));
  Digest digest;
  for (const uint32_t size : {planes->width, planes->height, planes->samples}) digest.add(size);
  digest.add(planes->hits);
  sight.coverage = digest.value();
  digest.add(planes->owner);
  digest.add(planes->front_facing);
  digest.add(planes->depth);
  for (const std::vector<float>& plane : planes->varyings) digest.add(plane);
  sight.picture = digest.value();
  const Planes blank = Planes::cleared(planes->width, planes->height, planes->samples,
                                       component_count(test_case.varyings), test_case.target.clear_depth);
  const judge::Party party{.planes = &blank, .subpixel_bits = options.subpixel_bits};
  const judge::CaseVerdict verdict = judge::judge(test_case, party, nullptr, kStrict);
  sight.allowed = verdict.covered_samples;
  sight.blank_passes = verdict.candidate_faults() == 0;
  return sight;
}

}  // namespace fillrule::check
