// Room for some values that costs nothing to make: whoever reads a value must have written it.
#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <span>
#include <type_traits>

namespace fillrule::renderer {

template <typename T, size_t kCount>
class Uncleared {
  // Such objects begin to live in an array of bytes when they are first used (C++20, [intro.object]).
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T> && std::is_aggregate_v<T>);

 public:
  // Not cleared: `bytes_` has no initialiser. NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
  Uncleared() = default;

  T& operator[](size_t i) { return values()[i]; }
  const T& operator[](size_t i) const { return values()[i]; }
  [[nodiscard]] std::span<const T> span() const { return {values(), kCount}; }

 private:
  T* values() { return std::launder(reinterpret_cast<T*>(bytes_.data())); }
  [[nodiscard]] const T* values() const { return std::launder(reinterpret_cast<const T*>(bytes_.data())); }

  alignas(T) std::array<std::byte, sizeof(T) * kCount> bytes_;
};

}  // namespace fillrule::renderer
