// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/batch/baked_curve.hpp>
#include <orispline/batch/sample.hpp>
#include <orispline/batch/segment_runs.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

/// Writes the samples of one piece.
template <class T>
void sample_piece(const BakedRecord<T>& piece, const Clock& clock, std::size_t count, const Target<T>& target) noexcept;

/// Writes runs of samples that lie on one piece of a baked curve.
template <class T>
class BakedSampler {
 public:
  BakedSampler(const BakedCurve<T>& curve, const Samples<T>& out) noexcept : curve_(curve), out_(out) {}

  [[nodiscard]] const Knots& knots() const noexcept { return curve_.knots(); }
  void on_segment(std::size_t piece, const Clock& clock, std::size_t at, std::size_t count) noexcept;
  void hold(Held held, std::size_t at, std::size_t count) noexcept;

 private:
  const BakedCurve<T>& curve_;
  const Samples<T>& out_;
};

}}}  // namespace orispline::batch
