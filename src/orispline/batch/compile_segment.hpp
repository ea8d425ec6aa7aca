// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/batch/record.hpp>
#include <orispline/curve/knots.hpp>
#include <orispline/curve/segment_form.hpp>

namespace orispline::batch {

/// Half angles of a chart segment beyond this [rad] are left to the scalar evaluator.
inline constexpr double largest_chart_half_angle = 1.0;

/// A segment of a cumulative curve for the kernel.
///
/// The coefficients in s about the segment's middle come from the Bernstein form by exact integers: a shift of powers
/// in double would cost digits. Derivation: docs/performance.md.
template <class T>
[[nodiscard]] CumulativeRecord<T> compile_segment(const CumulativeForm& form, const KnotSpan& span) noexcept;

/// A segment of a chart curve for the kernel; its bound on the half angle [rad] says whether the kernel may be used.
template <class T>
struct CompiledChart {
  ChartRecord<T> record;
  double half_angle;
};
template <class T>
[[nodiscard]] CompiledChart<T> compile_segment(const ChartForm& form, const KnotSpan& span) noexcept;

template <class T>
[[nodiscard]] PathRecord<T> compile_segment(const PathForm& form, const KnotSpan& span) noexcept;

}  // namespace orispline::batch
