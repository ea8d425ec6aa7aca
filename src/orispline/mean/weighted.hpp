// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace mean_of {

/// Points that count, with weights above 0 whose sum is 1.
template <CurvePoint P>
struct Weighted {
  std::vector<P> points{};
  std::vector<double> weights{};

  [[nodiscard]] std::size_t size() const noexcept { return points.size(); }
};

/// The shortest way to a point.
struct Way {
  Eigen::Vector3d vector;  ///< of at most π in the body frame of where it begins, whatever the signs, or a difference
  double length;           ///< [rad] or [m]
  double across = 1.0;     ///< the curvature of ½ d² across it, (θ/2) cot(θ/2), of positions 1; along it that is 1
};

/// The turn that leads to an orientation, by at most π.
[[nodiscard]] inline Eigen::Quaterniond shortest_turn(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
  const Eigen::Quaterniond turn = from.conjugate() * to;
  return turn.w() < 0.0 ? Eigen::Quaterniond(-turn.coeffs()) : turn;
}

[[nodiscard]] inline Way way_to(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
  const Eigen::Quaterniond turn = shortest_turn(from, to);
  const double sine = norm_of<double>(turn.vec());
  if (sine < 4 * std::numeric_limits<double>::min()) return {2.0 * turn.vec(), 2.0 * sine};
  const double angle = 2.0 * atan2_of(sine, turn.w());
  return {angle / sine * turn.vec(), angle, 0.5 * angle * turn.w() / sine};
}
[[nodiscard]] inline Way way_to(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d way = displacement<double>(from, to);
  return {way, norm_of<double>(way)};
}

/// A point moved by a vector, of unit norm where it is an orientation.
[[nodiscard]] inline Eigen::Quaterniond moved(const Eigen::Quaterniond& from, const Eigen::Vector3d& by) {
  return displaced<double>(from, by).normalized();
}
[[nodiscard]] inline Eigen::Vector3d moved(const Eigen::Vector3d& from, const Eigen::Vector3d& by) {
  return displaced<double>(from, by);
}

/// A sum that loses no more than its last digits, however many terms it has. Source: Neumaier 1974.
class VectorSum {
 public:
  void add(const Eigen::Vector3d& term) {
    const Eigen::Vector3d sum = sum_ + term;
    for (Eigen::Index i = 0; i < 3; ++i)
      lost_[i] += std::abs(sum_[i]) >= std::abs(term[i]) ? (sum_[i] - sum[i]) + term[i] : (term[i] - sum[i]) + sum_[i];
    sum_ = sum;
  }
  [[nodiscard]] Eigen::Vector3d value() const { return sum_ + lost_; }

 private:
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero(), lost_ = Eigen::Vector3d::Zero();
};

}}}  // namespace orispline::mean_of
