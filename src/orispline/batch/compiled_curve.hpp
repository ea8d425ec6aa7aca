// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>
#include <vector>

#include <orispline/batch/kernel/record.hpp>
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

/// Has the kernel write `count` samples of a segment whose record nobody keeps.
template <class T>
[[nodiscard]] ORISPLINE_EXPORT bool by_kernel(const AnyCurve& curve, std::size_t segment, const Clock& clock,
                                              std::size_t count, const Target<T>& target) noexcept;

}}}  // namespace orispline::batch

namespace orispline { inline namespace ORISPLINE_ABI {

/// A curve with all its segments compiled for evaluation in bulk: for curves that are evaluated again and again.
///
/// 704 bytes a segment in double, 384 in float. `sample…` take it in place of the curve, with the same results.
template <class T = double>
class ORISPLINE_EXPORT CompiledCurve {
 public:
  explicit CompiledCurve(AnyCurve curve);

  [[nodiscard]] const AnyCurve& curve() const noexcept { return curve_; }
  [[nodiscard]] const batch::SegmentRecord<T>& record(std::size_t segment) const noexcept { return records_[segment]; }

  /// Orientation at time t [s], with the bits of a sample; outside the domain the end orientation, NaN at a NaN time.
  [[nodiscard]] Eigen::Quaternion<T> operator()(double t) const noexcept;

 private:
  AnyCurve curve_;
  std::vector<batch::SegmentRecord<T>> records_;
};

}}  // namespace orispline
