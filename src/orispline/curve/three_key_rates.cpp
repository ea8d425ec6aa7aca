// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/three_key_rates.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

std::vector<Eigen::Vector3d> three_key_rates(std::span<const double> times,
                                             std::span<const Eigen::Vector3d> increments) {
  const auto step = [times](std::size_t i) { return times[i + 1] - times[i]; };
  const auto secant = [&](std::size_t i) -> Eigen::Vector3d { return increments[i] / step(i); };
  std::vector<Eigen::Vector3d> rates;
  rates.reserve(times.size());
  rates.push_back(secant(0));
  for (std::size_t i = 1; i < increments.size(); ++i) {
    const double before = step(i - 1), after = step(i);
    rates.push_back((after * secant(i - 1) + before * secant(i)) / (before + after));
  }
  rates.push_back(secant(increments.size() - 1));
  return rates;
}

}}  // namespace orispline
