// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <span>

namespace orispline::bench {

/// Numbers from the start of a cache line on, touched before use: fresh pages cost several times the computation.
template <class T>
class Buffer {
 public:
  explicit Buffer(std::size_t size)
      : numbers_(static_cast<T*>(::operator new(size * sizeof(T), alignment)), &release), size_(size) {
    std::fill_n(numbers_.get(), size, T(0));
  }
  [[nodiscard]] std::span<T> first(std::size_t count) noexcept { return std::span(numbers_.get(), size_).first(count); }
  [[nodiscard]] std::span<T> all() noexcept { return first(size_); }

 private:
  static constexpr std::align_val_t alignment{64};
  static void release(T* numbers) { ::operator delete(numbers, alignment); }

  std::unique_ptr<T, void (*)(T*)> numbers_;
  std::size_t size_;
};

}  // namespace orispline::bench
