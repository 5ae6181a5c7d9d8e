// The instruction sets that kernels are compiled for, one of which is chosen at run time. All give the same bytes
// (lanes.h); the scalar one is the reference.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "renderer/lanes.h"
#include "renderer/vector_lanes.h"

namespace fillrule::renderer {

enum class Isa : uint8_t { kScalar, kSse41, kAvx2, kAvx512 };
inline constexpr std::array kAllIsas{Isa::kScalar, Isa::kSse41, Isa::kAvx2, Isa::kAvx512};

// "scalar", "sse4.1", "avx2", "avx512".
std::string_view to_string(Isa isa);
std::optional<Isa> isa_named(std::string_view name);

// Whether this processor has it.
bool is_supported(Isa isa);
// The greatest that it has.
Isa best_isa();

namespace internal {

template <typename Kernel>
[[gnu::target("sse4.1")]] void with_sse41(const Kernel& kernel) {
  kernel.template operator()<Sse41Lanes>();
}
template <typename Kernel>
[[gnu::target("avx2,fma")]] void with_avx2(const Kernel& kernel) {
  kernel.template operator()<Avx2Lanes>();
}
template <typename Kernel>
[[gnu::target("avx2,fma,avx512f,avx512bw,avx512dq,avx512vl")]] void with_avx512(const Kernel& kernel) {
  kernel.template operator()<Avx512Lanes>();
}

}  // namespace internal

// Calls kernel.operator()<L>() with the lanes of the instruction set, in a function that may use it. The kernel's
// operator must be inlined always, and so must everything with lanes that it calls.
template <typename Kernel>
void dispatch(Isa isa, const Kernel& kernel) {
  switch (isa) {
    case Isa::kScalar:
      return kernel.template operator()<ScalarLanes>();
    case Isa::kSse41:
      return internal::with_sse41(kernel);
    case Isa::kAvx2:
      return internal::with_avx2(kernel);
    case Isa::kAvx512:
      return internal::with_avx512(kernel);
  }
}

}  // namespace fillrule::renderer
