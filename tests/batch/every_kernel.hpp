// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>
#include <variant>
#include <vector>

#include <orispline/batch/compiled_curve.hpp>
#include <orispline/batch/kernel/dispatch.hpp>

// The kernels of every instruction set that this processor has, one by one, where the library takes the best.

namespace orispline::testing_support {

[[nodiscard]] inline std::vector<const batch::Kernels*> all_kernels() {
  std::vector<const batch::Kernels*> all;
  for (const char* name : {"v2", "v3", "v4", "neon", "simd128", "native"})
    if (const batch::Kernels* kernels = batch::kernels_named(name)) all.push_back(kernels);
  return all;
}

inline constexpr std::size_t block_and_part = 173;  ///< samples: a whole block and a part of one

/// Writes `count` samples of a segment, of a spherical quadrangle the orientations alone; none of one that is left to
/// the scalar evaluator.
template <class T>
void run(const batch::Kernels& k, const batch::SegmentRecord<T>& record, const batch::Clock& clock, std::size_t count,
         const batch::Target<T>& to) {
  constexpr bool is_double = std::is_same_v<T, double>;
  if (const auto* cumulative = std::get_if<batch::CumulativeRecord<T>>(&record)) {
    if constexpr (is_double) k.cumulative(*cumulative, clock, count, to);
    else k.cumulative_float(*cumulative, clock, count, to);
  }
  if (const auto* chart = std::get_if<batch::ChartRecord<T>>(&record)) {
    if constexpr (is_double) k.chart(*chart, clock, count, to);
    else k.chart_float(*chart, clock, count, to);
  }
  if (const auto* rational = std::get_if<batch::RationalRecord<T>>(&record)) {
    if constexpr (is_double) k.polynomials->rational(*rational, clock, count, to);
    else k.polynomials->rational_float(*rational, clock, count, to);
  }
  if (const auto* squad = std::get_if<batch::SquadRecord<T>>(&record)) {
    if constexpr (is_double) k.squad(*squad, clock, count, to);
    else k.squad_float(*squad, clock, count, to);
  }
}

}  // namespace orispline::testing_support
