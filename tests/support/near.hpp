// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include <orispline/curve/motion.hpp>
#include <support/tolerance.hpp>

namespace orispline::testing_support {

/// Largest component of the difference, relative to the largest component of the expected value, or to `least` if that
/// is larger.
template <class A, class B>
[[nodiscard]] double relative_error(const Eigen::MatrixBase<A>& found, const Eigen::MatrixBase<B>& wanted,
                                    double least = 1.0) {
  if (!found.allFinite()) return std::numeric_limits<double>::infinity();
  const double scale = std::max(least, wanted.template lpNorm<Eigen::Infinity>());
  return (found - wanted).template lpNorm<Eigen::Infinity>() / scale;
}

/// Quaternions are compared with their signs: q and -q are two apart.
[[nodiscard]] inline double relative_error(const Eigen::Quaterniond& found, const Eigen::Quaterniond& wanted) {
  return relative_error(found.coeffs(), wanted.coeffs());
}

inline ::testing::AssertionResult within(double error, double tolerance, const char* what) {
  if (error <= tolerance) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << what << " off by " << error << " (relative), allowed " << tolerance;
}

template <class A, class B>
::testing::AssertionResult near(const Eigen::MatrixBase<A>& found, const Eigen::MatrixBase<B>& wanted,
                                double tolerance) {
  auto result = within(relative_error(found, wanted), tolerance, "value");
  if (!result) result << "\n  found  " << found.transpose() << "\n  wanted " << wanted.transpose();
  return result;
}

inline ::testing::AssertionResult near(const Eigen::Quaterniond& found, const Eigen::Quaterniond& wanted,
                                       double tolerance) {
  return near(found.coeffs(), wanted.coeffs(), tolerance) << "  (x y z w)";
}

using tolerance::MotionTolerance;

/// The largest components of a curve's rates, 1 at least. Rounding at one time is as large as the rates elsewhere are.
struct RateSizes {
  double velocity = 1.0, acceleration = 1.0, jerk = 1.0;

  void include(const Motion& m) {
    velocity = std::max(velocity, m.angular_velocity.lpNorm<Eigen::Infinity>());
    acceleration = std::max(acceleration, m.angular_acceleration.lpNorm<Eigen::Infinity>());
    jerk = std::max(jerk, m.angular_jerk.lpNorm<Eigen::Infinity>());
  }
};

/// Rates are compared relative to the larger of their own size and that of the curve's.
inline ::testing::AssertionResult near(const Motion& found, const Motion& wanted, const MotionTolerance& allowed,
                                       const RateSizes& of_curve = {}) {
  const auto orientation =
      within(relative_error(found.orientation, wanted.orientation), allowed.orientation, "orientation");
  if (!orientation) return orientation;
  const auto velocity = within(relative_error(found.angular_velocity, wanted.angular_velocity, of_curve.velocity),
                               allowed.angular_velocity, "angular velocity");
  if (!velocity) return velocity;
  const auto acceleration =
      within(relative_error(found.angular_acceleration, wanted.angular_acceleration, of_curve.acceleration),
             allowed.angular_acceleration, "angular acceleration");
  if (!acceleration) return acceleration;
  return within(relative_error(found.angular_jerk, wanted.angular_jerk, of_curve.jerk), allowed.angular_jerk,
                "angular jerk");
}

}  // namespace orispline::testing_support
