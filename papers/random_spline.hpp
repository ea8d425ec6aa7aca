// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <orispline/curve/four_key_curve.hpp>

#include "papers/dice.hpp"
#include "papers/papers_algebra.hpp"

namespace orispline::cli {

/// Two segments of a spline of four keys each, on random keys, uneven knots and tensions, in the papers' words: Q is
/// the key where they meet, A and B are the logarithms of the increments before and behind it.
///
/// Derivatives are those in the local parameter of a segment, which runs from 0 to 1: those in time, times the step to
/// the power of their order.
template <class Family>
class RandomSpline {
 public:
  RandomSpline(Dice& dice, double lowest_tension, double highest_tension) {
    for (double& tension : tensions_) tension = dice.between(lowest_tension, highest_tension);
    keys_[0] = dice.unit_quaternion();
    for (std::size_t i = 1; i < keys_.size(); ++i) keys_[i] = keys_[i - 1] * exp<double>(dice.vector());
    for (std::size_t i = 1; i < knots_.size(); ++i) knots_[i] = knots_[i - 1] + dice.between(0.5, 2.0);
    const Curve curve(Knots({knots_.begin(), knots_.end()}),
                      typename Family::Basis{PerKey({tensions_.begin(), tensions_.end()})}, keys_);
    before_ = curve.point(Jet<double, 3>::variable(knots_[1]), 0);
    after_ = curve.point(Jet<double, 3>::variable(knots_[1]), 1);
  }

  [[nodiscard]] double tension() const { return tensions_[1]; }
  [[nodiscard]] AnyQuaternion q() const { return keys_[2]; }
  [[nodiscard]] AnyQuaternion a() const { return half_log(Eigen::Quaterniond(keys_[1].conjugate() * keys_[2])); }
  [[nodiscard]] AnyQuaternion b() const { return half_log(Eigen::Quaterniond(keys_[2].conjugate() * keys_[3])); }
  /// Of the segment behind the key to that before it.
  [[nodiscard]] double ratio_of_steps() const { return (knots_[2] - knots_[1]) / (knots_[1] - knots_[0]); }

  /// Derivatives at the key of the segment before it and of that behind it.
  [[nodiscard]] AnyQuaternion before(std::size_t order) const {
    return std::pow(knots_[1] - knots_[0], static_cast<double>(order)) * derivative(before_, order);
  }
  [[nodiscard]] AnyQuaternion after(std::size_t order) const {
    return std::pow(knots_[2] - knots_[1], static_cast<double>(order)) * derivative(after_, order);
  }
  /// How far both are from what is stated.
  [[nodiscard]] double error(std::size_t order, const AnyQuaternion& stated) const {
    return std::max(gap(before(order), stated), gap(after(order), stated));
  }

 private:
  using Curve = CumulativeCurve<typename Family::Basis>;

  std::array<Eigen::Quaterniond, 5> keys_;
  std::array<double, 3> knots_{}, tensions_{};
  Quaternion<Jet<double, 3>> before_, after_;
};

/// The four points of one segment in space, its tensions, and how the curve leaves the second and arrives at the third.
template <class Family>
class RandomSegment {
 public:
  using Path = Vector3<Jet<double, 3>>;

  RandomSegment(Dice& dice, double lowest_tension, double highest_tension)
      : start_tension(dice.between(lowest_tension, highest_tension)),
        end_tension(dice.between(lowest_tension, highest_tension)) {
    for (Eigen::Vector3d& point : p) point = dice.vector();
    const CumulativePath<typename Family::Basis> path(Knots({0.0, 1.0}),
                                                      typename Family::Basis{PerKey({start_tension, end_tension})}, p);
    start_ = path.point(Jet<double, 3>::variable(0.0), 0);
    end_ = path.point(Jet<double, 3>::variable(1.0), 0);
  }

  /// How far the derivatives of an order are from what is stated of the two ends.
  [[nodiscard]] double error(std::size_t order, const Eigen::Vector3d& start, const Eigen::Vector3d& end) const {
    return std::max((of(start_, order) - start).norm(), (of(end_, order) - end).norm());
  }

  std::array<Eigen::Vector3d, 4> p;
  double start_tension, end_tension;

 private:
  [[nodiscard]] static Eigen::Vector3d of(const Path& path, std::size_t order) {
    return {path.x().derivative(order), path.y().derivative(order), path.z().derivative(order)};
  }

  Path start_, end_;
};

}  // namespace orispline::cli
