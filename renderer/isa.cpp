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

// The builtin gives an int in GCC and a bool in Clang.
bool is_supported(Isa isa) {
  switch (isa) {
    case Isa::kScalar:
      return true;
    case Isa::kSse41:
      return static_cast<bool>(__builtin_cpu_supports("sse4.1"));
    case Isa::kAvx2:
      return static_cast<bool>(__builtin_cpu_supports("avx2")) && static_cast<bool>(__builtin_cpu_supports("fma"));
    case Isa::kAvx512:
      break;
  }
  return is_supported(Isa::kAvx2) && static_cast<bool>(__builtin_cpu_supports("avx512f")) &&
         static_cast<bool>(__builtin_cpu_supports("avx512bw")) &&
         static_cast<bool>(__builtin_cpu_supports("avx512dq")) &&
         static_cast<bool>(__builtin_cpu_supports("avx512vl"));
}

Isa best_isa() {
  static const Isa best = *std::find_if(kAllIsas.rbegin(), kAllIsas.rend(), is_supported);
  return best;
}

}  // namespace fillrule::renderer
