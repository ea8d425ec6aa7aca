// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include <orispline/curve/motion.hpp>
#include <support/tolerance.hpp>

namespace orispline::testing_support {

/// Largest component of the difference, relative to max(1, largest component of the expected value).
template <class A, class B>
[[nodiscard]] double relative_error(const Eigen::MatrixBase<A>& found, const Eigen::MatrixBase<B>& wanted) {
  if (!found.allFinite()) return std::numeric_limits<double>::infinity();
  const double scale = std::max(1.0, wanted.template lpNorm<Eigen::Infinity>());
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

inline ::testing::AssertionResult near(const Motion& found, const Motion& wanted, const MotionTolerance& allowed) {
  const auto orientation =
      within(relative_error(found.orientation, wanted.orientation), allowed.orientation, "orientation");
  if (!orientation) return orientation;
  const auto velocity = within(relative_error(found.angular_velocity, wanted.angular_velocity),
                               allowed.angular_velocity, "angular velocity");
  if (!velocity) return velocity;
  const auto acceleration = within(relative_error(found.angular_acceleration, wanted.angular_acceleration),
                                   allowed.angular_acceleration, "angular acceleration");
  if (!acceleration) return acceleration;
  return within(relative_error(found.angular_jerk, wanted.angular_jerk), allowed.angular_jerk, "angular jerk");
}

}  // namespace orispline::testing_support
