// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/families/beta_g2_handles.hpp>
#include <orispline/tune/construction.hpp>
#include <orispline/tune/moving_controls.hpp>

// Beta curves as functions of one β.

namespace orispline { inline namespace ORISPLINE_ABI {

using Betas = families::BetasOver<double>;
using MovingBetas = families::BetasOver<Slope>;
using MovingPoints = std::vector<Quaternion<Slope>>;

/// These along a variable of the keys, the first of which is key `first`.
[[nodiscard]] inline MovingBetas along(const Betas& betas, const Variable& variable, std::size_t first = 0) {
  MovingBetas moving{{betas.beta1.begin(), betas.beta1.end()}, {betas.beta2.begin(), betas.beta2.end()}};
  (variable.parameter == "beta1" ? moving.beta1 : moving.beta2)[variable.key - first].c[1] = 1.0;
  return moving;
}

/// Those of so many keys from that one on.
[[nodiscard]] inline Betas window(const Betas& betas, std::size_t first, std::size_t count) {
  const auto some = [&](const std::vector<double>& list) {
    const auto start = list.begin() + static_cast<std::ptrdiff_t>(first);
    return std::vector<double>(start, start + static_cast<std::ptrdiff_t>(count));
  };
  return {some(betas.beta1), some(betas.beta2)};
}

[[nodiscard]] inline MovingPoints still_points(std::span<const Eigen::Quaterniond> points) {
  MovingPoints still;
  for (const Eigen::Quaterniond& q : points) still.push_back(constant<Slope>(q));
  return still;
}

template <Number T>
[[nodiscard]] BetaShapeOver<T> shape_of(const families::BetasOver<T>& betas) {
  return beta_shape_over(betas.beta1, betas.beta2);
}

/// How a segment changes with the variable that it is a function of.
[[nodiscard]] inline SegmentSlope slope_of(const BetaSegment<Slope>& segment) {
  Eigen::Quaterniond base, change;
  for (Eigen::Index i = 0; i < 4; ++i) {
    base.coeffs()[i] = segment.base.coeffs()[i].c[0];
    change.coeffs()[i] = segment.base.coeffs()[i].c[1];
  }
  SegmentSlope slope{.increments = {}, .from = 2.0 * (base.conjugate() * change).vec()};
  for (std::size_t k = 0; k < segment.increments.size(); ++k) slope.increments[k] = slope_part(segment.increments[k]);
  return slope;
}

/// The segments of a Beta curve of these points between these times.
[[nodiscard]] inline std::vector<TensionSegment> beta_segments(std::span<const Eigen::Quaterniond> points,
                                                               const BetaShape& shape, std::span<const double> times) {
  std::vector<TensionSegment> segments;
  for (std::size_t i = 1; i + 2 < points.size(); ++i) {
    const BetaSegment<double> segment = beta_segment<double>(points, shape, i);
    segments.push_back(cumulative_segment(times[i - 1], times[i] - times[i - 1], segment.base, segment.increments));
  }
  return segments;
}

}}  // namespace orispline
