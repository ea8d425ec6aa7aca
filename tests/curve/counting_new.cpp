// SPDX-License-Identifier: Apache-2.0
// A unit of its own: beside its callers the compiler would inline the pair and complain about malloc and delete.
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
// Sanitizers have some of their own, which would not match what is deleted below.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return operator new(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  try {
    return operator new(size, alignment);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
