// SPDX-License-Identifier: Apache-2.0
// Goes with support/matching_delete.cpp.
#include <out_of_memory/failing_new.hpp>

#include <atomic>
#include <cstdlib>

namespace {

std::atomic<long> left{-1};

void* counted(void* memory) {
  long known = left;
  while (known > 0 && !left.compare_exchange_weak(known, known - 1)) {
  }
  if (known != 0 && memory) return memory;
  std::free(memory);
  throw std::bad_alloc();
}

}  // namespace

void orispline::testing_support::allow_allocations(long count) noexcept { left = count; }

void* operator new(std::size_t size) { return counted(std::malloc(size > 0 ? size : 1)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(step, (size + step - 1) / step * step));
}
