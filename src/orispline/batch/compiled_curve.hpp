// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include <orispline/batch/kernel/record.hpp>
#include <orispline/curve/curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

/// A segment ready for the kernel; empty: left to the scalar evaluator.
template <class T>
using SegmentRecord =
    std::variant<std::monostate, CumulativeRecord<T>, ChartRecord<T>, RationalRecord<T>, SquadRecord<T>>;

template <class T>
[[nodiscard]] ORISPLINE_EXPORT SegmentRecord<T> record_of(const AnyCurve& curve, std::size_t segment) noexcept;

/// Orientation at t [s] on a segment, with the bits of a sample.
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Eigen::Quaternion<T> orientation_by(const SegmentRecord<T>& record,
                                                                   const AnyCurve& curve, std::size_t segment,
                                                                   double t) noexcept;

/// What a kernel writes of the samples that are wanted; the rest is left to the scalar evaluator.
enum class Written { nothing, orientations, all };

/// Has the kernel write `count` samples of the segment, as far as it can.
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Written by_kernel(const SegmentRecord<T>& record, const Clock& clock, std::size_t count,
                                                 const Target<T>& target) noexcept;

/// Has the kernel write `count` samples of a segment whose record nobody keeps.
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Written by_kernel(const AnyCurve& curve, std::size_t segment, const Clock& clock,
                                                 std::size_t count, const Target<T>& target) noexcept;

/// Records that are made when they are first wanted, by any thread, and kept.
template <class T>
class KeptRecords;

}}}  // namespace orispline::batch

namespace orispline { inline namespace ORISPLINE_ABI {

/// When the segments of a curve are compiled.
enum class Compiling {
  at_once,
  as_wanted,  ///< each by the first sample on it, which allocates memory: for a few samples of a curve of many segments
};

/// A curve with its segments compiled for evaluation in bulk: for curves that are evaluated again and again.
///
/// 704 bytes a segment in double, 384 in float. `sample…` take it in place of the curve, with the same results, in any
/// number of threads. Copies share what is compiled as wanted.
template <class T = double>
class ORISPLINE_EXPORT CompiledCurve {
 public:
  explicit CompiledCurve(AnyCurve curve, Compiling when = Compiling::at_once);

  [[nodiscard]] const AnyCurve& curve() const noexcept { return curve_; }
  /// Null where there is no memory for it.
  [[nodiscard]] const batch::SegmentRecord<T>* record(std::size_t segment) const noexcept {
    return wanted_ ? made(segment) : &records_[segment];
  }

  /// Orientation at time t [s], with the bits of a sample; outside the domain the end orientation, NaN at a NaN time.
  [[nodiscard]] Eigen::Quaternion<T> operator()(double t) const noexcept;

 private:
  [[nodiscard]] const batch::SegmentRecord<T>* made(std::size_t segment) const noexcept;

  AnyCurve curve_;
  std::vector<batch::SegmentRecord<T>> records_;  ///< of all segments; empty where they are made as wanted
  std::shared_ptr<batch::KeptRecords<T>> wanted_;
};

}}  // namespace orispline
