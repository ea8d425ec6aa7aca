// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

// Plain data and functions only: probes are compiled once per instruction set.

namespace orispline::bench {

/// How many products and sums of doubles the probe does in one call, and what its chains must end at.
struct FmaWork {
  double factor, summand;  ///< x ← factor x + summand
  std::uint64_t rounds;    ///< per chain
};

/// A probe of what the processor can do in one instruction set: chains that do not wait for each other.
struct FmaProbe {
  const char* name;
  std::uint64_t chains;  ///< of doubles, side by side
  /// Runs all chains, chain c from start + c; returns their sum.
  double (*run)(const FmaWork& work, double start);
};

/// The probe of an instruction set by its name, as the library's kernels are called.
[[nodiscard]] const FmaProbe* fma_probe(const char* isa) noexcept;

/// Sum of the chains, by the formula of the geometric series.
[[nodiscard]] double fma_expected(const FmaProbe& probe, const FmaWork& work, double start) noexcept;

/// Writes one 32-byte pattern over the whole span with plain or streaming stores.
void write_plain(std::span<double> out, const double (&pattern)[4]) noexcept;
void write_streaming(std::span<double> out, const double (&pattern)[4]) noexcept;

}  // namespace orispline::bench
