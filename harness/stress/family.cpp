#include "harness/stress/family.h"

namespace fillrule::stress {
namespace {

struct FamilyFacts {
  std::string_view name;
  uint32_t triangles_per_case;
};

// In the order of the enumeration.
constexpr std::array<FamilyFacts, kFamilyCount> kFacts{{{"small", 16},
                                                        {"big", 4},
                                                        {"sliver", 8},
                                                        {"on_grid", 8},
                                                        {"ties", 8},
                                                        {"collinear", 8},
                                                        {"perspective", 4},
                                                        {"steep", 4},
                                                        {"near", 4},
                                                        {"far", 4},
                                                        {"near_and_far", 4},
                                                        {"mixed_w", 4},
                                                        {"zero_w", 4},
                                                        {"huge", 4},
                                                        {"viewport", 4},
                                                        {"shared_edges", 8}}};

}  // namespace

std::array<Family, kFamilyCount> all_families() {
  std::array<Family, kFamilyCount> families{};
  for (size_t i = 0; i < kFamilyCount; ++i) families[i] = static_cast<Family>(i);
  return families;
}

std::string_view name_of(Family family) {
  return kFacts[static_cast<size_t>(family)].name;
}

std::optional<Family> family_named(std::string_view name) {
  for (const Family family : all_families()) {
    if (name_of(family) == name) return family;
  }
  return std::nullopt;
}

uint32_t triangles_per_case(Family family) {
  return kFacts[static_cast<size_t>(family)].triangles_per_case;
}

}  // namespace fillrule::stress
