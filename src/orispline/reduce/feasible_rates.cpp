// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/feasible_rates.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double largest_angle = 0.999 * std::numbers::pi;  // below the cut of the logarithm
constexpr double rounding_of_rate = 1e-9;                   // in favour of the rate

using Directions = Eigen::Matrix<double, 13, 3>;

/// The middles of the faces, edges and corners of a cube, one of each opposite two; the faces first.
Directions unit_directions() {
  Directions directions;
  directions << 1, 0, 0, 0, 1, 0, 0, 0, 1,                      //
      0, 1, 1, 0, 1, -1, 1, 0, 1, 1, 0, -1, 1, 1, 0, 1, -1, 0,  //
      1, 1, 1, -1, 1, 1, 1, -1, 1, 1, 1, -1;
  return directions.rowwise().normalized();
}

const Directions directions = unit_directions();

}  // namespace

void FeasibleRates::narrow(const Eigen::Vector3d& turn, double elapsed, double bound) {
  const double tolerance = bound + 8.0 * angle_rounding;
  const double norm = turn.norm(), angle = norm + tolerance;
  least_ = std::max(least_, (norm * (1.0 - rounding_of_rate) - tolerance) / elapsed);
  if (!(angle < largest_angle)) return;
  const double half = 0.5 * angle;
  const double radius = tolerance * (half / elementary::sine_cosine(half).sine) * (1.0 + rounding_of_rate) / elapsed;
  const Array along = directions * (turn / elapsed);
  lowest_ = lowest_.max(along - radius);
  highest_ = highest_.min(along + radius);
  narrow_balls(turn / elapsed, radius);
}

/// The new one takes the place of the one that forbids least of it.
void FeasibleRates::narrow_balls(const Eigen::Vector3d& centre, double radius) {
  const auto beyond = beyond_balls(centre).eval();
  are_balls_apart_ = are_balls_apart_ || beyond.maxCoeff() > radius;
  Eigen::Index least = 0;
  beyond.minCoeff(&least);
  centres_.col(least) = centre.array();
  radii_[least] = radius;
}

void FeasibleRates::narrow(const ToleranceCheck& recording, std::size_t i, std::size_t k) {
  const Keyframes& samples = recording.samples();
  narrow(shorter_turn(samples.orientations()[i], samples.orientations()[k]),
         std::abs(samples.times()[k] - samples.times()[i]), recording.tolerance().angle);
}

bool FeasibleRates::is_empty() const {
  const double largest = highest_.head<3>().max(-lowest_.head<3>()).matrix().norm();
  return are_balls_apart_ || (lowest_ > highest_).any() || largest < least_;
}

double FeasibleRates::distance(const Eigen::Vector3d& rate) const {
  const Array along = directions * rate;
  return std::max(
      {(lowest_ - along).max(along - highest_).maxCoeff(), beyond_balls(rate).maxCoeff(), least_ - rate.norm()});
}

}}  // namespace orispline
