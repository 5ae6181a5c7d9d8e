// The verdict: a candidate and, where there is one, a reference, each held against the exact oracle at every sample.
// The two are never held against each other, so that neither can be accused for the other's fault.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "harness/judge/verdict.h"
#include "reference/exact/expectation.h"

namespace fillrule::judge {

struct Party {
  const Planes* planes = nullptr;
  uint32_t subpixel_bits = 8;
};

// What a candidate is asked for beyond the specification.
struct Profile {
  // Ties follow the top-left rule, wherever the vertices lie exactly on the candidate's subpixel grid.
  bool top_left = false;
  // Bresenham lines are what the diamond-exit rule makes of them, wherever their ends lie exactly on that grid.
  bool diamond_exit = false;
  // Imprecise values are faults.
  bool precise = false;
  // Coverage, owner and hits are equal to the reference's wherever no primitive had to be clipped, nor is a Bresenham
  // line, of which the specification leaves open more than rounding. Applies only to a
  // candidate of the same subpixel bits as the reference.
  bool same_bits = false;
};

struct ProfilePart {
  const char* name;
  bool Profile::*member;
};
inline constexpr std::array kProfileParts{
    ProfilePart{"top_left", &Profile::top_left}, ProfilePart{"precise", &Profile::precise},
    ProfilePart{"diamond_exit", &Profile::diamond_exit}, ProfilePart{"same_bits", &Profile::same_bits}};

// The names of its parts with commas between them; empty where nothing is asked for.
std::string to_string(const Profile& profile);

struct Settings {
  Profile profile;
  bool keep_maps = false;  // fill PlaneVerdict::map and worst_samples, and CaseVerdict::oracle
};

// What a case must and may cover, for parties of given subpixel bits.
class Oracle {
 public:
  // `reference_bits` where there is a reference.
  Oracle(const Case& test_case, uint32_t candidate_bits, std::optional<uint32_t> reference_bits);

  [[nodiscard]] const exact::Expectation& for_candidate() const { return for_candidate_; }
  // The same object where the bits are equal.
  [[nodiscard]] const exact::Expectation& for_reference() const {
    return for_reference_ ? *for_reference_ : for_candidate_;
  }

 private:
  exact::Expectation for_candidate_;
  std::optional<exact::Expectation> for_reference_;
};

// `reference` may be null: the candidate is then held against the oracle alone, and "identical" means equal to the
// exact value rounded to float32.
CaseVerdict judge(const Case& test_case, const Party& candidate, const Party* reference, const Settings& settings);

// The same with an oracle of the case, made for the parties' subpixel bits.
CaseVerdict judge(const Case& test_case, const Oracle& oracle, const Party& candidate, const Party* reference,
                  const Settings& settings);

}  // namespace fillrule::judge
