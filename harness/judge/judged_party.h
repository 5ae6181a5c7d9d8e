// A party of a judgement, with everything that judging it takes.
#pragma once

#include "harness/judge/judge.h"
#include "harness/judge/row_judge.h"
#include "harness/judge/standing.h"

namespace fillrule::judge {

// What is exact for all parties of equal subpixel bits.
struct ExactAnswers {
  const exact::Expectation& expectation;
  ValueCache values;
  RowJudge rows;

  ExactAnswers(const Case& test_case, const exact::Expectation& expected)
      : expectation(expected), values(test_case, expected), rows(test_case, expected, values) {}
};

struct JudgedParty {
  const Party& party;
  ExactAnswers& answers;
  Replay replay;
  PartyJudge judge;
  const Possibilities* possible = nullptr;  // at the sample that is judged

  JudgedParty(const Case& test_case, const Party& judged, ExactAnswers& exact_answers, Replay::Rules rules)
      : party(judged),
        answers(exact_answers),
        replay(test_case, answers.expectation, answers.values, judged.subpixel_bits, rules),
        judge(test_case, *judged.planes, answers.expectation, answers.values) {}

  // How what the plane shows stands to what is possible.
  [[nodiscard]] Standing standing_of(PlaneKind kind, uint32_t component, size_t index) const;
};

// Whether two parties that show equal bits stand alike at the sample: the same is possible there, values belong to
// the same owner, and hits are part of no line that breaks a rule as a whole.
bool stand_alike(const JudgedParty& a, const JudgedParty& b, PlaneKind kind, size_t index);

// What a plane shows, whatever its type.
struct PlaneValue {
  uint32_t bits = 0;
  double number = 0;
};
PlaneValue value_of(const Planes& planes, PlaneKind kind, uint32_t component, size_t index);

}  // namespace fillrule::judge
