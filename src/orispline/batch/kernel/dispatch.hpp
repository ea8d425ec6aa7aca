// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <orispline/base/expected.hpp>
#include <orispline/batch/kernel/record.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

/// The loops for the best instruction set of this processor: `v4` (AVX-512), `v3` (AVX2) or `v2` (the baseline of
/// x86-64), `neon` on 64-bit ARM, `simd128` or `scalar` in WebAssembly, elsewhere `native`.
///
/// The environment variable ORISPLINE_ISA forces one; where it cannot, the best is taken all the same, and
/// forced_kernels() says why. Chosen once. Every choice gives the same bits, unless the library was built with
/// contraction into fused multiply-adds.
[[nodiscard]] ORISPLINE_EXPORT const Kernels& kernels() noexcept;

/// The kernels of that name; null where this build or this processor does not have it.
[[nodiscard]] ORISPLINE_EXPORT const Kernels* kernels_named(const char* name) noexcept;

/// The loops that ORISPLINE_ISA forces, null where it is not set or empty. Errors: bad_argument for a name that this
/// build does not know or this processor lacks.
[[nodiscard]] ORISPLINE_EXPORT Expected<const Kernels*> forced_kernels();

/// The loops of one instruction set, and whether the processor has it.
struct Candidate {
  const Kernels* kernels;
  bool usable;
};

/// forced_kernels() among any candidates, the text of the variable given; null where it is not set.
[[nodiscard]] ORISPLINE_EXPORT Expected<const Kernels*> forced_kernels(std::span<const Candidate> candidates,
                                                                       const char* text);

}}}  // namespace orispline::batch
