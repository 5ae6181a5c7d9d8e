#include "renderer/isa.h"

#include <algorithm>

namespace fillrule::renderer {

std::string_view to_string(Isa isa) {
  switch (isa) {
    case Isa::kScalar:
      return "scalar";
    case Isa::kSse41:
      return "sse4.1";
    case Isa::kAvx2:
      return "avx2";
    case Isa::kAvx512:
      break;
  }
  return "avx512";
}

std::optional<Isa> isa_named(std::string_view name) {
  const auto* const found = std::ranges::find(kAllIsas, name, to_string);
  return found == kAllIsas.end() ? std::nullopt : std::optional(*found);
}

bool is_supported(Isa isa) {
  switch (isa) {
    case Isa::kScalar:
      return true;
    case Isa::kSse41:
      return __builtin_cpu_supports("sse4.1") != 0;
    case Isa::kAvx2:
      return __builtin_cpu_supports("avx2") != 0;
    case Isa::kAvx512:
      break;
  }
  return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
         __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0;
}

Isa best_isa() {
  static const Isa best = *std::find_if(kAllIsas.rbegin(), kAllIsas.rend(), is_supported);
  return best;
}

}  // namespace fillrule::renderer
