// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <orispline/batch/sample.hpp>
#include <string_view>
#include <workload/definition.hpp>

namespace orispline::bench {

/// What a contender may differ from the definition in a component: ours per rad of the largest half angle, but at least
/// as for one.
inline constexpr double our_limit = 1e-15, our_float_limit = 3e-7, peer_limit = 1e-12, peer_float_limit = 2e-6;
/// ω and α may differ from differences of the definition [rad/s], [rad/s²].
inline constexpr double rates_limit = 1e-7;

using Truth = std::function<LongQuaternion(std::size_t sample)>;

/// Ends the program when the error of a contender is above the limit (or not a number), else returns it.
double accept(std::string_view contender, double error, double limit);

/// Which samples are compared: at most some twenty thousand, and no matter how many per segment, all places of it.
[[nodiscard]] inline std::size_t stride(std::size_t samples) noexcept {
  return std::max<std::size_t>(1, samples / 20011) | 1U;
}

/// Largest error of a component; NaN where a sample is not a number.
template <class T>
[[nodiscard]] double largest_error(std::span<const T> out, Layout layout, const Truth& truth) {
  const std::size_t samples = out.size() / 4;
  const auto number = [&](std::size_t k, std::size_t i) {
    return static_cast<Real>(layout == Layout::planar ? out[i * samples + k] : out[4 * k + i]);
  };
  Real largest = 0;
  const auto compare = [&](std::size_t k) {
    const LongQuaternion wanted = truth(k);
    for (std::size_t i = 0; i < 4; ++i) {
      const Real error = std::abs(number(k, i) - wanted.coeffs()[static_cast<Eigen::Index>(i)]);
      if (!(error <= largest)) largest = error;
    }
  };
  for (std::size_t k = 0; k < samples; k += stride(samples)) compare(k);
  compare(samples - 1);
  return static_cast<double>(largest);
}

}  // namespace orispline::bench
