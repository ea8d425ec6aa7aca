// SPDX-License-Identifier: Apache-2.0
// A unit of its own, as tests/out_of_memory/failing_new.cpp is.
#include "c/live_allocations.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> live{0};

void* counted(void* memory) {
  if (!memory) throw std::bad_alloc();
  ++live;
  return memory;
}

void forget(void* memory) noexcept {
  if (memory) --live;
  std::free(memory);
}

}  // namespace

long orispline::testing_support::live_allocations() noexcept { return live; }

void* operator new(std::size_t size) { return counted(std::malloc(size > 0 ? size : 1)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(step, (size + step - 1) / step * step));
}
// Those of sanitizers would not match what is deleted below.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  void* const memory = std::malloc(size > 0 ? size : 1);
  return memory ? counted(memory) : nullptr;
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  const auto step = static_cast<std::size_t>(alignment);
  void* const memory = std::aligned_alloc(step, (size + step - 1) / step * step);
  return memory ? counted(memory) : nullptr;
}
void operator delete(void* memory) noexcept { forget(memory); }
void operator delete(void* memory, std::size_t) noexcept { forget(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { forget(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { forget(memory); }
