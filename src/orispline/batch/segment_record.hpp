// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include <orispline/batch/kernel/polynomial_record.hpp>
#include <orispline/curve/curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

/// A segment ready for the kernel; empty: left to the scalar evaluator.
template <class T>
using SegmentRecord = std::variant<std::monostate, CumulativeRecord<T>, ChartRecord<T>, RationalRecord<T>>;

template <class T>
[[nodiscard]] ORISPLINE_EXPORT SegmentRecord<T> record_of(const AnyCurve& curve, std::size_t segment) noexcept;

/// Orientation at t [s] on a segment, with the bits of a sample.
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Eigen::Quaternion<T> orientation_by(const SegmentRecord<T>& record,
                                                                   const AnyCurve& curve, std::size_t segment,
                                                                   double t) noexcept;

/// Has the kernel write `count` samples of the segment; false where it cannot.
template <class T>
[[nodiscard]] ORISPLINE_EXPORT bool by_kernel(const SegmentRecord<T>& record, const Clock& clock, std::size_t count,
                                              const Target<T>& target) noexcept;

/// The same of a segment whose record nobody keeps.
template <class T>
[[nodiscard]] ORISPLINE_EXPORT bool by_kernel(const AnyCurve& curve, std::size_t segment, const Clock& clock,
                                              std::size_t count, const Target<T>& target) noexcept;

}}}  // namespace orispline::batch
