// SPDX-License-Identifier: Apache-2.0
// Goes with support/matching_delete.cpp.
#include <curve/counting_new.hpp>

#include <cstdlib>
#include <new>

namespace {
thread_local std::size_t allocations = 0, bytes = 0;

void count(std::size_t size) {
  ++allocations;
  bytes += size;
}
}  // namespace

std::size_t orispline::testing_support::allocations_of_this_thread() { return allocations; }
std::size_t orispline::testing_support::bytes_of_this_thread() { return bytes; }

void* operator new(std::size_t size) {
  count(size);
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  count(size);
  const auto step = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(step, (size + step - 1) / step * step)) return memory;
  throw std::bad_alloc();
}
