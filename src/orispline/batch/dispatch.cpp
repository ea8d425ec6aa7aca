// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/dispatch.hpp>

#include <cstdlib>
#include <cstring>
#include <iterator>

namespace orispline::batch {

#if defined(ORISPLINE_X86_KERNELS)
extern const Kernels v2, v3, v4;
extern const PolynomialKernels polynomials_v2, polynomials_v3, polynomials_v4;
#else
extern const Kernels native;
extern const PolynomialKernels polynomials_native;
#endif

namespace {

struct Candidate {
  const Kernels* kernels;
  const PolynomialKernels* polynomials;
  bool (*usable)();
};

#if defined(ORISPLINE_X86_KERNELS)
// By single features: Clang 14 does not know the levels x86-64-v3 and x86-64-v4 here.
bool has_v3() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
         __builtin_cpu_supports("bmi2");
}
bool has_v4() {
  return has_v3() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
}
#endif

// The best one first.
#if defined(ORISPLINE_X86_KERNELS)
const Candidate candidates[] = {
    {&v4, &polynomials_v4, has_v4}, {&v3, &polynomials_v3, has_v3}, {&v2, &polynomials_v2, [] { return true; }}};
#else
const Candidate candidates[] = {{&native, &polynomials_native, [] { return true; }}};
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

const PolynomialKernels& polynomial_kernels(const Kernels& of) noexcept {
  for (const Candidate& candidate : candidates)
    if (candidate.kernels == &of) return *candidate.polynomials;
  return *candidates[std::size(candidates) - 1].polynomials;
}

}  // namespace orispline::batch
