// SPDX-License-Identifier: Apache-2.0
// Where the program cannot go on it ends in a trap. The standard libraries would print before that, and their printing
// is a tenth of the small package.
#include <cstddef>
#include <cstdlib>
#include <new>
#include <version>

_LIBCPP_BEGIN_NAMESPACE_STD
void __libcpp_verbose_abort(const char*, ...) noexcept { __builtin_trap(); }
_LIBCPP_END_NAMESPACE_STD

// Weak, for Zig, which links the libraries that have them too before it comes to these.
extern "C" [[gnu::weak]] void __cxa_pure_virtual() { __builtin_trap(); }
extern "C" [[gnu::weak]] void abort() { __builtin_trap(); }

void* operator new(std::size_t size) {
  void* const memory = std::malloc(size);
  if (!memory) __builtin_trap();
  return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
