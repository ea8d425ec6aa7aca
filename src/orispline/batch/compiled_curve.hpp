// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/batch/segment_record.hpp>

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
