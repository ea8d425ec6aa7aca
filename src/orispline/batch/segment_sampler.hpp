// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/batch/sample.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

/// Writes runs of samples that lie on one segment: by the kernel, or where the segment is no polynomial by the scalar
/// evaluator.
template <class T>
class SegmentSampler {
 public:
  /// `compiled` may be null: segments are then compiled one after the other, each for its run.
  SegmentSampler(const AnyCurve& curve, const CompiledCurve<T>* compiled, const Samples<T>& out) noexcept
      : curve_(curve), compiled_(compiled), out_(out) {}

  /// `count` samples from `clock` on, written from sample `at` on.
  void on_segment(std::size_t segment, const Clock& clock, std::size_t at, std::size_t count) noexcept;

  /// Orientation at t [s] in the domain, with the bits of a sample.
  [[nodiscard]] Eigen::Quaterniond orientation_at(double t) const noexcept;

 private:
  const AnyCurve& curve_;
  const CompiledCurve<T>* compiled_;
  const Samples<T>& out_;
};

}}}  // namespace orispline::batch
