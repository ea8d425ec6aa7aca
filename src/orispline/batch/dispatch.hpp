// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/batch/polynomial_record.hpp>

namespace orispline::batch {

/// The loops for the best instruction set of this processor: `v4` (AVX-512), `v3` (AVX2) or `v2` (the baseline of
/// x86-64), elsewhere `native`. The environment variable ORISPLINE_ISA forces one that the processor has. Chosen once.
///
/// Every choice gives the same bits, unless the library was built with contraction into fused multiply-adds.
[[nodiscard]] const Kernels& kernels() noexcept;

/// The same by name; null where this build or this processor does not have it.
[[nodiscard]] const Kernels* kernels_named(const char* name) noexcept;

/// The loops over polynomials for the instruction set of these kernels.
[[nodiscard]] const PolynomialKernels& polynomial_kernels(const Kernels& of = kernels()) noexcept;

}  // namespace orispline::batch
