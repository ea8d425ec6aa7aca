// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/batch/sample.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Many curves with the same key times and the same blending, such as the joints of a figure: all orientations at one
/// time, side by side in the lanes of the processor.
///
/// Takes the curves of one cumulative method of up to three factors, with tensions that are the same for all. Memory:
/// 13 numbers a curve and segment.
template <class T = double>
class ORISPLINE_EXPORT CurveBundle {
 public:
  /// Errors (bad_argument, with the index of the curve as the key): no curves; a curve that is not of cumulative
  /// pieces, or whose key times or blending differ from those of the first.
  [[nodiscard]] static Expected<CurveBundle> make(std::vector<AnyCurve> curves);

  [[nodiscard]] std::size_t size() const noexcept { return curves_.size(); }

  /// The orientation of every curve at time t [s], as sample_many gives them to rounding; no rates.
  ///
  /// Errors (bad_argument): room for another number of samples; rates that are asked for.
  [[nodiscard]] Expected<void> sample(double t, const Samples<T>& out) const;

 private:
  struct Segment {
    std::vector<T> planes;
    std::array<std::array<double, batch::record_degree + 1>, 3> factors;
    double middle_time, per_step;
    bool within_range;  ///< all angles within 1 rad
  };

  explicit CurveBundle(std::vector<AnyCurve> curves) : curves_(std::move(curves)) {}
  [[nodiscard]] std::optional<Error> add_segment(std::size_t index);

  std::vector<AnyCurve> curves_;
  std::vector<Segment> segments_;
  std::size_t plane_ = 0;  ///< the length of a plane
};

}}  // namespace orispline
