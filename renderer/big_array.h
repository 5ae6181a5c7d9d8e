// Memory for many values, not cleared, and kept for the next draw. A draw goes to and fro in it, so that where pages
// are small the processor keeps looking for their addresses; the system is asked for large ones.
#pragma once

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

namespace fillrule::renderer {

template <typename T>
class BigArray {
  static_assert(std::is_trivially_destructible_v<T> && alignof(T) <= alignof(std::max_align_t));

 public:
  // Room for so many, which nobody has cleared: whoever reads a value must have written it. What there was is lost.
  // Throws std::bad_alloc, as a vector does.
  std::span<T> room_for(size_t count) {
    if (count > capacity_ || capacity_ > kMaxKept) {
      values_.reset();
      capacity_ = 0;
      values_.reset(allocate(count * sizeof(T)));
      capacity_ = count;
    }
    return {values_.get(), count};
  }

 private:
  struct Free {
    void operator()(T* values) const { std::free(values); }  // NOLINT(cppcoreguidelines-no-malloc)
  };

  static T* allocate(size_t bytes) {
    constexpr size_t kLargePage = size_t{2} << 20U;
    if (bytes < kLargePage) {
      return checked(std::malloc(bytes == 0 ? 1 : bytes));  // NOLINT(cppcoreguidelines-no-malloc)
    }
    const size_t whole_pages = (bytes + kLargePage - 1) / kLargePage * kLargePage;
    T* const values = checked(std::aligned_alloc(kLargePage, whole_pages));  // NOLINT(cppcoreguidelines-no-malloc)
#if defined(MADV_HUGEPAGE)
    static_cast<void>(madvise(values, whole_pages, MADV_HUGEPAGE));  // a wish: without it everything works as well
#endif
    return values;
  }

  static T* checked(void* memory) {
    if (memory == nullptr) {
      throw std::bad_alloc();
    }
    return static_cast<T*>(memory);
  }

  static constexpr size_t kMaxKept = (size_t{32} << 20U) / sizeof(T);  // from one draw to the next

  size_t capacity_ = 0;
  std::unique_ptr<T[], Free> values_;  // NOLINT(modernize-avoid-c-arrays)
};

}  // namespace fillrule::renderer
