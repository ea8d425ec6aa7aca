// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/kernel/dispatch.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

#if defined(ORISPLINE_X86_KERNELS)
extern const Kernels v2, v3, v4;
#else
extern const Kernels ORISPLINE_ONLY_KERNELS;
#endif

namespace {

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

/// The best one first; the last one is always usable.
auto all_candidates() noexcept {
#if defined(ORISPLINE_X86_KERNELS)
  return std::array{Candidate{&v4, has_v4()}, Candidate{&v3, has_v3()}, Candidate{&v2, true}};
#else
  return std::array{Candidate{&ORISPLINE_ONLY_KERNELS, true}};
#endif
}

const Kernels& best() noexcept {
  const auto candidates = all_candidates();
  return *std::ranges::find_if(candidates, &Candidate::usable)->kernels;
}

}  // namespace

const Kernels* kernels_named(const char* name) noexcept {
  for (const Candidate& candidate : all_candidates())
    if (std::string_view(name) == candidate.kernels->name) return candidate.usable ? candidate.kernels : nullptr;
  return nullptr;
}

Expected<const Kernels*> forced_kernels(std::span<const Candidate> candidates, const char* text) {
  if (text == nullptr || *text == '\0') return nullptr;
  std::vector<std::string_view> usable;
  std::string_view lacking = "";
  for (const Candidate& candidate : candidates) {
    const std::string_view name = candidate.kernels->name;
    if (candidate.usable && name == text) return candidate.kernels;
    if (candidate.usable) usable.push_back(name);
    else if (name == text) lacking = ", which this processor lacks";
  }
  return failure(ErrorCode::bad_argument,
                 formatted("ORISPLINE_ISA: found '{}'{}, wanted one of {}", text, lacking, joined(usable, ", ")));
}

Expected<const Kernels*> forced_kernels() { return forced_kernels(all_candidates(), std::getenv("ORISPLINE_ISA")); }

const Kernels& kernels() noexcept {
  static const Kernels& chosen = []() -> const Kernels& {
    const Kernels* forced = forced_kernels().value_or(nullptr);
    return forced ? *forced : best();
  }();
  return chosen;
}

}}}  // namespace orispline::batch
