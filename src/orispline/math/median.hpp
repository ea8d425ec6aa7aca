// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include <orispline/base/abi.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The middle one of some numbers, or the mean of the two in the middle; 0 of none.
[[nodiscard]] inline double median(std::vector<double> numbers) {
  if (numbers.empty()) return 0.0;
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::ranges::nth_element(numbers, middle);
  if (numbers.size() % 2 != 0) return *middle;
  return 0.5 * (*middle + *std::max_element(numbers.begin(), middle));
}

/// Of successive times; 0 for fewer than two.
[[nodiscard]] inline double median_interval(std::span<const double> times) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < times.size(); ++i) intervals.push_back(times[i] - times[i - 1]);
  return median(std::move(intervals));
}

/// That of each component.
[[nodiscard]] inline Eigen::Vector3d median_of_each(std::span<const Eigen::Vector3d> vectors) {
  Eigen::Vector3d medians;
  for (Eigen::Index k = 0; k < 3; ++k) {
    std::vector<double> components;
    components.reserve(vectors.size());
    for (const Eigen::Vector3d& v : vectors) components.push_back(v[k]);
    medians[k] = median(std::move(components));
  }
  return medians;
}

/// That of the lengths.
[[nodiscard]] inline double median_of_lengths(std::span<const Eigen::Vector3d> vectors) {
  std::vector<double> lengths;
  lengths.reserve(vectors.size());
  for (const Eigen::Vector3d& v : vectors) lengths.push_back(v.norm());
  return median(std::move(lengths));
}

}}  // namespace orispline
