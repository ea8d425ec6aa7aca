// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
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

/// The shortest way to a point: a rotation vector of at most π in the body frame of `from`, whatever the signs, or a
/// difference of positions.
[[nodiscard]] inline Eigen::Vector3d shortest_way(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
  const bool is_long = from.dot(to) < 0.0;
  return displacement<double>(from, is_long ? Eigen::Quaterniond(-to.coeffs()) : to);
}
[[nodiscard]] inline Eigen::Vector3d shortest_way(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return displacement<double>(from, to);
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
