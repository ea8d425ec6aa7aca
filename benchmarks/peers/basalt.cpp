// SPDX-License-Identifier: Apache-2.0
// gitlab.com/VladyslavUsenko/basalt-headers: its cubic B-spline, with and without rates.
#include <basalt/spline/so3_spline.h>

#include <memory>
#include <peers/peers.hpp>
#include <peers/uniform_time.hpp>

namespace orispline::bench {

namespace {

using Spline = basalt::So3Spline<4>;

std::shared_ptr<const Spline> spline_of(const Track& track) {
  const auto spline = std::make_shared<Spline>(1'000'000'000);
  for (std::size_t i = 0; i < track.keys(); ++i)
    spline->knotsPushBack(
        Sophus::SO3d(Eigen::Quaterniond(Eigen::Map<const Eigen::Quaterniond>(&track.orientations[4 * i]))));
  return spline;
}

}  // namespace

std::vector<Peer<double>> basalt_peers(const Track& track) {
  return {{"basalt So3Spline<4>", Shape::uniform_bspline,
           [spline = spline_of(track), track](std::span<const double> times, std::span<double> out) {
             for (std::size_t k = 0; k < times.size(); ++k)
               Eigen::Vector4d::Map(&out[4 * k]) =
                   spline->evaluate(uniform_place(track, times[k])).unit_quaternion().coeffs();
           }}};
}

RatesPeer basalt_rates_peer(const Track& track) {
  return {"basalt So3Spline<4>", Shape::uniform_bspline,
          [spline = spline_of(track), track](std::span<const double> times, std::span<double> orientations,
                                             std::span<double> velocities, std::span<double> accelerations) {
            for (std::size_t k = 0; k < times.size(); ++k) {
              const std::int64_t place = uniform_place(track, times[k]);
              Eigen::Vector4d::Map(&orientations[4 * k]) = spline->evaluate(place).unit_quaternion().coeffs();
              Eigen::Vector3d::Map(&velocities[3 * k]) = spline->velocityBody(place);
              Eigen::Vector3d::Map(&accelerations[3 * k]) = spline->accelerationBody(place);
            }
          }};
}

}  // namespace orispline::bench
