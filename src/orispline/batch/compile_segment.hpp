// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <orispline/batch/kernel/record.hpp>
#include <orispline/curve/curve_through.hpp>
#include <orispline/curve/knots.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

/// Half angles of a segment beyond this [rad] are left to the scalar evaluator: the kernel's series end there, or it
/// would take off quarter turns that its numbers cannot tell any more.
inline constexpr double largest_chart_half_angle = 1.0, largest_cumulative_half_angle = 1e5,
                        largest_squad_half_angle = 1.0;

/// Where the control points of a rational segment are so many times as long as the segment is near to 0, its powers
/// about the middle would lose digits.
inline constexpr double largest_rational_spread = 2.0;

/// A segment taken apart: q(s) = middle ∏ exp(vectors_k f_k(s)), the constant parts of the factors gone into the
/// middle.
struct FactoredSegment {
  Eigen::Quaterniond middle;
  std::array<Eigen::Vector3d, 3> vectors;                        ///< half rotation vectors [rad]
  std::array<std::array<double, record_degree + 1>, 3> factors;  ///< f_k in powers of s = (t - middle_time) * per_step
  std::array<double, 3> largest;                                 ///< bounds of |f_k|
  double middle_time, per_step;                                  ///< [s], [1/s]
};
[[nodiscard]] FactoredSegment factored(const CumulativeForm& form, const KnotSpan& span) noexcept;

/// A segment for the kernel, with a bound on its half angles [rad], which says whether the kernel may be used.
template <class Record>
struct CompiledSegment {
  Record record;
  double half_angle;
};

/// A segment of a cumulative curve.
///
/// The coefficients in s about the segment's middle come from the Bernstein form by exact integers: a shift of powers
/// in double would cost digits. Derivation: docs/performance.md.
template <class T>
[[nodiscard]] CompiledSegment<CumulativeRecord<T>> compile_segment(const CumulativeForm& form,
                                                                   const KnotSpan& span) noexcept;

/// A segment of a chart curve.
template <class T>
[[nodiscard]] CompiledSegment<ChartRecord<T>> compile_segment(const ChartForm& form, const KnotSpan& span) noexcept;

/// A rational segment for the kernel, with the length of its longest control point over a bound of the least |s|.
template <class T>
struct CompiledRational {
  RationalRecord<T> record;
  double spread;
};
template <class T>
[[nodiscard]] CompiledRational<T> compile_segment(const RationalForm& form, const KnotSpan& span) noexcept;

/// A spherical quadrangle, with bounds of the half angles [rad] of its arcs and between them.
template <class T>
[[nodiscard]] CompiledSegment<SquadRecord<T>> compile_segment(const SquadForm& form, const KnotSpan& span) noexcept;

}}}  // namespace orispline::batch
