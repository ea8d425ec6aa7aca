// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <orispline/math/eigen.hpp>

// The numbers that the data of a page hold, as coarse as a drawing allows: what is drawn is computed from these.

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

/// Times as whole numbers of steps from a start, of which 32 bits hold the last one.
struct TimeSteps {
  double start = 0.0, step = 0.0;  ///< [s]

  [[nodiscard]] static TimeSteps of(double start, double end) noexcept {
    return {start, (end - start) / static_cast<double>(std::numeric_limits<std::uint32_t>::max())};
  }
  [[nodiscard]] std::uint32_t nearest(double t) const noexcept {
    constexpr auto last = static_cast<double>(std::numeric_limits<std::uint32_t>::max());
    return step > 0.0 ? static_cast<std::uint32_t>(std::clamp(std::round((t - start) / step), 0.0, last)) : 0;
  }
  [[nodiscard]] double at(std::uint32_t count) const noexcept { return start + static_cast<double>(count) * step; }
  [[nodiscard]] double rounded(double t) const noexcept { return at(nearest(t)); }
};

/// Half floats in a unit that is a power of two, so that all larger and smaller units round alike.
struct HalfFloats {
  double unit = 1.0;

  /// The unit in which nothing up to `largest` overflows.
  [[nodiscard]] static HalfFloats up_to(double largest) noexcept {
    if (!(largest > 0.0) || !std::isfinite(largest)) return {};
    const int exponent = std::clamp(std::ilogb(largest), -1000, 1000);
    return {std::ldexp(1.0, exponent)};
  }
  [[nodiscard]] std::uint16_t bits(double value) const noexcept {
    return Eigen::numext::bit_cast<std::uint16_t>(Eigen::half(static_cast<float>(value / unit)));
  }
  [[nodiscard]] double rounded(double value) const noexcept {
    return unit * static_cast<double>(static_cast<float>(Eigen::half(static_cast<float>(value / unit))));
  }
  [[nodiscard]] Eigen::Vector3d rounded(const Eigen::Vector3d& v) const noexcept {
    return {rounded(v.x()), rounded(v.y()), rounded(v.z())};
  }
};

/// An orientation in single precision.
[[nodiscard]] inline Eigen::Quaterniond rounded(const Eigen::Quaterniond& q) noexcept {
  return q.cast<float>().cast<double>();
}

}}}  // namespace orispline::report
