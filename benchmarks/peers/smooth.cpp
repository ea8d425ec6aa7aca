// SPDX-License-Identifier: Apache-2.0
// github.com/pettni/smooth: its interpolating cubic, fitted beforehand.
#include <cstring>
#include <memory>
#include <peers/peers.hpp>
#include <smooth/so3.hpp>
#include <smooth/spline/fit.hpp>

namespace orispline::bench {

std::vector<Peer<double>> smooth_peers(const Track& track) {
  std::vector<smooth::SO3d> keys;
  for (std::size_t i = 0; i < track.keys(); ++i)
    keys.emplace_back(Eigen::Map<const Eigen::Quaterniond>(&track.orientations[4 * i]));
  const auto spline = std::make_shared<const decltype(smooth::fit_spline_cubic(track.times, keys))>(
      smooth::fit_spline_cubic(track.times, keys));
  return {{"smooth fitted cubic", Shape::through_keys,
           [spline, start = track.times.front()](std::span<const double> times, std::span<double> out) {
             for (std::size_t k = 0; k < times.size(); ++k)
               Eigen::Vector4d::Map(&out[4 * k]) = (*spline)(times[k] - start).quat().coeffs();
           }}};
}

}  // namespace orispline::bench
