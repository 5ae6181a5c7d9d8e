// Everything known about one sample of a case, as plain values: what the oracle says of each primitive near it, what
// each party drew there, and the verdict.
//
// Positions are in framebuffer coordinates (pixels, y down); distances are in subpixels of the party they are for,
// positive inside.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases/model/case.h"
#include "harness/judge/possibilities.h"
#include "harness/judge/standing.h"
#include "harness/judge/verdict.h"
#include "reference/exact/bresenham.h"
#include "reference/exact/expectation.h"
#include "reference/exact/value_bound.h"

namespace fillrule::explain {

// One of the lines that a primitive ends at, or that cut it off.
struct Boundary {
  enum class Kind : uint8_t {
    kEdge,       // of a triangle
    kSide,       // of a line's rectangle, or of a point's square
    kEnd,        // of a line's rectangle
    kFragments,  // as far as the fragments of a Bresenham line may be
    kNear,
    kFar,
    kClipDistance,
    kViewport,
    kScissor
  };
  Kind kind = Kind::kEdge;
  std::string name;  // "edge v1-v2", "the near plane", "the viewport's left side"
  // a dx + b dy + c, with (dx, dy) from the viewport's centre; positive inside, of any scale.
  std::array<double, 3> form{};
  double value = 0;     // of the form at the sample
  double distance = 0;  // of the sample, subpixels
  double latitude = 0;  // how far rounding may move the boundary, subpixels
  bool top = false;     // of an edge
  bool left = false;
  exact::Coverage answer = exact::Coverage::kMay;  // of this boundary alone
};

// What the rules for Bresenham lines say of a line as a whole, and here.
struct BresenhamFacts {
  bool x_major = true;
  int64_t width = 1;                         // fragments side by side
  double distance = 0;                       // of the pixel's centre from the line, along its minor axis, pixels
  std::optional<exact::CountRange> columns;  // that have fragments; none where the line has no such rule
  std::optional<bool> diamond_exit;          // whether that rule makes a fragment here; none where rounding decides
};

// Why a primitive is not drawn at the sample whatever its shape covers.
enum class Exclusion : uint8_t { kNone, kCulledByFacing, kCulledByDistances, kOutsideVolume, kScissored, kMasked };

// A triangle, a line or a point; or an edge or a corner of a polygon that is drawn as lines or points.
struct PrimitiveFacts {
  uint32_t number = 0;  // over all draws
  uint32_t draw = 0;
  exact::Piece::Kind kind = exact::Piece::Kind::kTriangle;
  std::vector<uint32_t> vertices;  // of the draw: three of a triangle, two of a line, one of a point
  std::vector<uint32_t> polygon;   // where it is an edge or a corner: the polygon's vertices
  int orientation = 0;             // of a triangle, 1: clockwise in the framebuffer
  bool front_facing = false;
  bool facing_in_doubt = false;
  bool undefined = false;
  bool thin = false;
  bool clipped = false;  // a vertex is outside of the view volume
  bool open = false;     // whether it is drawn at all is left open
  Exclusion exclusion = Exclusion::kNone;
  exact::Classification coverage;                  // of its shape alone
  exact::Coverage answer = exact::Coverage::kMay;  // with all that excludes it, the depth test left aside
  std::vector<Boundary> boundaries;                // empty where the primitive is undefined
  std::optional<BresenhamFacts> bresenham;         // of a Bresenham line

  // Where the sample is furthest outside, or else the nearest one; null if there is none.
  [[nodiscard]] const Boundary* deciding() const;
};

// What the oracle says to parties of so many subpixel bits.
struct View {
  uint32_t subpixel_bits = 8;
  std::vector<PrimitiveFacts> primitives;  // within a pixel of the sample, or the owner that a party shows there
  judge::Possibilities possible;
  std::vector<uint32_t> depth_owners;  // for each outcome the primitive whose depth is stored, kNoOwner: cleared
};

// Depth, or one component of a varying.
struct Value {
  std::string name;  // "depth", "uv.x"
  float value = 0;
  judge::Standing standing;  // against the exact value, all of the tolerance counted
  // What the tolerance is made of, but for what is left open; none where the clear value, a flat varying, or nothing
  // at all is expected, and where the value may be evaluated at several places.
  std::optional<exact::Tolerance> tolerance;
  std::string left_open;  // why several values are exact: "the depth bias"; empty where only one is
  std::string place;      // where in the pixel it is evaluated; empty where there is only one sample
  double ulps = 0;        // the error in units of the exact value's last place in float32
};

struct PartyFacts {
  std::string role;  // "candidate", "reference"
  std::string name;
  size_t view = 0;  // index into Explanation::views
  uint32_t hits = 0;
  uint32_t owner = kNoOwner;
  bool front_facing = false;
  std::vector<Value> values;
};

struct PlaneFacts {
  std::string name;
  judge::PlaneKind kind = judge::PlaneKind::kCoverage;
  judge::Verdict verdict = judge::Verdict::kIdentical;
};

struct Explanation {
  std::string case_name;
  uint32_t x = 0;  // pixel
  uint32_t y = 0;
  uint32_t sample = 0;
  uint32_t samples = 1;              // of the pixel
  std::array<double, 2> position{};  // of the sample
  std::vector<View> views;           // one, or two where the parties differ in subpixel bits
  std::vector<PartyFacts> parties;
  std::vector<PlaneFacts> planes;
  std::string reason;  // one plain sentence
};

}  // namespace fillrule::explain
