// What the specification says of a whole case, for a party of given subpixel bits: at each sample the primitives that
// must or may land there, in submission order, culling and scissor applied, the depth test not yet.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cases/model/case.h"
#include "reference/exact/triangle.h"
#include "reference/exact/value_bound.h"

namespace fillrule::exact {

struct Primitive {
  uint32_t draw = 0;  // index into Case::draws
  std::array<uint32_t, 3> vertices{};
  uint32_t provoking = 0;  // which of the three
  Triangle triangle;
  Latitude latitude;
  bool front_facing = false;
  bool facing_in_doubt = false;  // rounding may turn it over
  bool culled = false;           // if rounding does not turn it over
  bool thin = false;             // its values are undefined ground
};

// One primitive at one sample.
struct Entry {
  uint32_t primitive = 0;
  Coverage coverage = Coverage::kMay;  // kMay or kMust
  uint8_t doubt = 0;                   // DoubtBits
};

// What Expectation::sole() says where no primitive can land, and where there is more to say than one number.
inline constexpr uint32_t kNothing = 0xFFFFFFFFU;
inline constexpr uint32_t kSeveral = 0xFFFFFFFEU;

class Expectation {
 public:
  Expectation(const Case& test_case, uint32_t subpixel_bits);

  [[nodiscard]] const std::vector<Primitive>& primitives() const { return primitives_; }

  // For each sample the number of the primitive that must cover it while no other one may, kNothing or kSeveral.
  [[nodiscard]] const std::vector<uint32_t>& sole() const { return sole_; }

  // All entries of a sample, in submission order.
  void collect(size_t sample, std::vector<Entry>& entries) const;

 private:
  // The entries of samples with several, as a list for each sample.
  struct Node {
    Entry entry;
    uint32_t next = 0;
  };
  struct Classified {
    size_t sample = 0;
    Classification classification;
  };
  struct SampleList {
    uint32_t first = 0;
    uint32_t last = 0;
  };
  void add_draw(const Case& test_case, uint32_t draw, uint32_t subpixel_bits);
  void add_primitive(const Case& test_case, uint32_t number);
  template <typename Visit>
  void classify_block(const Primitive& primitive, const VkRect2D& block, uint32_t width, const Visit& visit) const;
  void append(size_t sample, const Classification& classification, uint32_t number);
  void append_node(size_t sample, const Entry& entry);

  std::vector<Primitive> primitives_;
  std::vector<uint32_t> sole_;
  std::vector<Node> nodes_;
  std::vector<SampleList> lists_;  // empty until a sample has several entries
};

}  // namespace fillrule::exact
