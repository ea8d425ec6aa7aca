// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>
#include <workload/track.hpp>

namespace orispline::bench {

using Real = long double;
using LongQuaternion = Eigen::Quaternion<Real>;
using LongVector = Eigen::Matrix<Real, 3, 1>;

/// A curve straight from its definition, in long double, by code of its own: what all contenders must agree with.
class Definition {
 public:
  explicit Definition(const Track& track);

  [[nodiscard]] LongQuaternion quintic(double t) const { return quintic(Real(t), segment_at(t)); }
  [[nodiscard]] LongQuaternion slerp(double t) const;
  /// Cubic B-spline over the keys at even times, in the segment that blends the keys from that one on, u from 0 to 1.
  [[nodiscard]] LongQuaternion uniform_bspline(Real u, std::size_t first_key) const;

  /// Body rates of the quintic curve [rad/s], [rad/s²]: differences of fourth order, good to about 1e-9.
  [[nodiscard]] LongVector angular_velocity(double t) const { return angular_velocity(Real(t), segment_at(t)); }
  [[nodiscard]] LongVector angular_acceleration(double t) const;
  /// Of the B-spline, per segment.
  [[nodiscard]] LongVector uniform_bspline_velocity(Real u, std::size_t first_key) const;
  [[nodiscard]] LongVector uniform_bspline_acceleration(Real u, std::size_t first_key) const;

 private:
  [[nodiscard]] std::size_t segment_at(double t) const;
  [[nodiscard]] Real local(Real t, std::size_t segment) const;
  [[nodiscard]] LongQuaternion quintic(Real t, std::size_t segment) const;
  [[nodiscard]] LongVector angular_velocity(Real t, std::size_t segment) const;

  std::vector<Real> times_, tensions_;
  std::vector<LongQuaternion> keys_;
  std::vector<LongVector> half_angles_;  ///< from key to key, half the rotation vector [rad]; zero beyond the ends
};

}  // namespace orispline::bench
