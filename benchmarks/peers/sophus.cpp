// SPDX-License-Identifier: Apache-2.0
// github.com/strasdat/Sophus: its cubic B-spline.
#include <memory>
#include <peers/peers.hpp>
#include <peers/uniform_time.hpp>
// (the order matters to it)
#include <sophus/so3.hpp>
#include <sophus/spline.hpp>

namespace orispline::bench {

std::vector<Peer<double>> sophus_peers(const Track& track) {
  std::vector<Sophus::SO3d> keys;
  for (std::size_t i = 0; i < track.keys(); ++i)
    keys.emplace_back(Eigen::Quaterniond(Eigen::Map<const Eigen::Quaterniond>(&track.orientations[4 * i])));
  // Its segment i blends the keys i - 1 … i + 2.
  const auto spline = std::make_shared<const Sophus::BasisSpline<Sophus::SO3d>>(std::move(keys), -1.0, 1.0);
  return {{"Sophus BasisSpline", Shape::uniform_bspline,
           [spline, track](std::span<const double> times, std::span<double> out) {
             for (std::size_t k = 0; k < times.size(); ++k) {
               const double place = 1e-9 * static_cast<double>(uniform_place(track, times[k]));
               Eigen::Vector4d::Map(&out[4 * k]) = spline->parent_T_spline(place).unit_quaternion().coeffs();
             }
           }}};
}

}  // namespace orispline::bench
