// What may be found at one sample after all primitives have been drawn: the oracle's entries for it, replayed through
// the depth test with every outcome that the specification allows.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "reference/exact/expectation.h"

namespace fillrule::judge {

// One way in which the sample may end up.
struct Outcome {
  uint32_t owner = kNoOwner;         // the primitive that landed last
  uint32_t depth_writer = kNoOwner;  // the primitive whose depth is stored; none: the clear value
  bool owner_certain = false;        // that primitive must cover the sample
  bool depth_certain = false;
  bool operator==(const Outcome&) const = default;
};

struct Possibilities {
  uint32_t least_hits = 0;
  uint32_t most_hits = 0;
  bool in_doubt = false;   // the coverage of some primitive is left open here
  bool undefined = false;  // ... because the primitive is undefined
  std::vector<Outcome> outcomes;
};

// Caches the exact values of a case's primitives while its samples are judged.
class ValueCache {
 public:
  ValueCache(const Case& test_case, const exact::Expectation& expectation);

  [[nodiscard]] const exact::TriangleValues& values(uint32_t primitive);
  [[nodiscard]] const exact::TriangleValues::Component& component(uint32_t primitive, uint32_t component);

 private:
  struct Values {
    exact::TriangleValues triangle;
    std::vector<exact::TriangleValues::Component> components;
  };
  Values& at(uint32_t number);

  const Case& case_;
  const exact::Expectation& expectation_;
  std::vector<std::unique_ptr<Values>> values_;
  std::vector<Interpolation> interpolation_;  // of each component
};

class Replay {
 public:
  // `top_left`: resolve ties by the top-left rule where the vertices are exactly on the subpixel grid; more than the
  // specification asks for.
  Replay(const Case& test_case, const exact::Expectation& expectation, ValueCache& values, uint32_t subpixel_bits,
         bool top_left);

  // `index` is that of Planes. The result is valid until the next call.
  const Possibilities& at(size_t index);

 private:
  enum class DepthResult : uint8_t { kFails, kPasses, kEither };

  void resolve_ties(double x, double y);
  // What the entries [begin, end) of the sample do to the outcomes so far.
  void replay(size_t begin, size_t end, double x, double y);
  bool replay_watertight(size_t begin, size_t end, double x, double y);
  void land(const exact::Entry& entry, bool must, double x, double y);
  [[nodiscard]] DepthResult depth_test(uint32_t primitive, uint32_t stored, double x, double y);
  [[nodiscard]] bool resolved_by_top_left(const exact::Entry& entry);
  [[nodiscard]] exact::Expected depth_of(uint32_t primitive, double x, double y);

  const Case& case_;
  const exact::Expectation& expectation_;
  ValueCache& values_;
  uint32_t subpixel_bits_;
  bool top_left_;
  std::vector<uint8_t> on_grid_;  // for each primitive: 0 not asked yet, 1 no, 2 yes
  std::vector<exact::Entry> entries_;
  std::vector<Outcome> before_;
  Possibilities possibilities_;
};

}  // namespace fillrule::judge
