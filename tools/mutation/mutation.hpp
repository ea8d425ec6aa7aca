// SPDX-License-Identifier: Apache-2.0
// Put before every source of a mutated build: asks whether a mutant is the chosen one.
#pragma once
#if __cplusplus >= 202002L

#include <type_traits>
#include <utility>

namespace orispline_mutation {

extern int chosen;                       // by ORISPLINE_MUTANT; -1: none
extern bool is_recording;                // whether ORISPLINE_MUTANTS_REACHED names a folder
extern unsigned char reached[1U << 16];  // whether the program came by each mutant

[[gnu::always_inline]] static inline constexpr bool is(int id) {
  if (std::is_constant_evaluated()) return false;
  if (is_recording) reached[id] = 1;
  return id == chosen;
}

/// The same for variables that the compiler would initialise, and by the original: this it cannot evaluate.
bool is_at_start(int id);

/// A value that outlives the operands: a sum of matrices, not the expression for it.
template <class T>
constexpr auto plain(T&& value) {
  if constexpr (requires { value.eval(); }) return value.eval();
  else return std::forward<T>(value);
}

}  // namespace orispline_mutation
#endif
