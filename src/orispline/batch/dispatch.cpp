// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/dispatch.hpp>

#include <cstdlib>
#include <cstring>

namespace orispline::batch {

#if defined(ORISPLINE_X86_KERNELS)
extern const Kernels v2, v3, v4;
#else
extern const Kernels native;
#endif

namespace {

struct Candidate {
  const Kernels* kernels;
  bool (*usable)();
};

// The best one first.
#if defined(ORISPLINE_X86_KERNELS)
const Candidate candidates[] = {{&v4, [] { return __builtin_cpu_supports("x86-64-v4") != 0; }},
                                {&v3, [] { return __builtin_cpu_supports("x86-64-v3") != 0; }},
                                {&v2, [] { return true; }}};
#else
const Candidate candidates[] = {{&native, [] { return true; }}};
#endif

const Kernels& best() noexcept {
  if (const char* forced = std::getenv("ORISPLINE_ISA"))
    if (const Kernels* named = kernels_named(forced)) return *named;
  for (const Candidate& candidate : candidates)
    if (candidate.usable()) return *candidate.kernels;
  return *candidates[0].kernels;
}

}  // namespace

const Kernels* kernels_named(const char* name) noexcept {
  for (const Candidate& candidate : candidates)
    if (std::strcmp(candidate.kernels->name, name) == 0) return candidate.usable() ? candidate.kernels : nullptr;
  return nullptr;
}

const Kernels& kernels() noexcept {
  static const Kernels& chosen = best();
  return chosen;
}

}  // namespace orispline::batch
