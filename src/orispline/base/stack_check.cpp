// SPDX-License-Identifier: Apache-2.0
// What the arithmetic of 128 bits in Debian's runtime of WebAssembly asks for, which checks the stack.
#include <cstdint>

// NOLINTBEGIN(bugprone-reserved-identifier): the compiler's names
extern "C" {
std::uintptr_t __stack_chk_guard = 0x5ca1ab1e;
[[noreturn]] void __stack_chk_fail() { __builtin_trap(); }
}
// NOLINTEND(bugprone-reserved-identifier)
