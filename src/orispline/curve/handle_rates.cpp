// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/handle_rates.hpp>

#include <utility>

namespace orispline { inline namespace ORISPLINE_ABI {

HandleTurn widest_handle(std::span<const double> times, const HandleRates& rates) {
  return widest_handle(times.size(), [&](std::size_t i) {
    const double after = i + 1 < times.size() ? times[i + 1] - times[i] : 0.0;
    const double before = i > 0 ? times[i] - times[i - 1] : 0.0;
    return std::pair(Eigen::Vector3d(after / 3.0 * rates.leaving[i]),
                     Eigen::Vector3d(before / 3.0 * rates.arriving[i]));
  });
}

}}  // namespace orispline
