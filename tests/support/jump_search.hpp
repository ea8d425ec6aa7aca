// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <gtest/gtest.h>

#include <orispline/curve/curve.hpp>

namespace orispline::testing_support {

/// Looks into every segment for two neighbouring times between which the quaternion goes farther than the rates there
/// allow, by bisection of all neighbouring samples that lie so far apart.
class JumpSearch {
 public:
  explicit JumpSearch(const AnyCurve& curve) : curve_(curve) {}

  /// Success where all is finite and nothing jumps.
  [[nodiscard]] ::testing::AssertionResult operator()(int samples = 48) const {
    for (std::size_t segment = 0; segment < curve_.knots().segments(); ++segment) {
      const KnotSpan span = curve_.knots().span(segment);
      double before = span.start();
      for (int k = 1; k <= samples; ++k) {
        const double t = k == samples ? span.end() : span.start() + span.step() * k / samples;
        if (auto found = between(segment, before, t); !found) return found;
        before = t;
      }
    }
    return ::testing::AssertionSuccess();
  }

 private:
  static constexpr double rounding = 1e-6;  ///< of an orientation that is thousands of turns away from its key [rad]

  [[nodiscard]] ::testing::AssertionResult between(std::size_t segment, double from, double to) const {
    const Motion a = curve_.motion_on(segment, from), b = curve_.motion_on(segment, to);
    for (const Motion& m : {a, b})
      if (!(m.orientation.coeffs().allFinite() && m.angular_velocity.allFinite() &&
            m.angular_acceleration.allFinite() && m.angular_jerk.allFinite()))
        return ::testing::AssertionFailure() << "not finite in segment " << segment << ", " << from << " s to " << to;
    const double way = 2.0 * (a.orientation.coeffs() - b.orientation.coeffs()).norm();
    const double rate = std::max(a.angular_velocity.norm(), b.angular_velocity.norm());
    if (way <= 2.0 * rate * (to - from) + rounding) return ::testing::AssertionSuccess();
    const double middle = from + 0.5 * (to - from);
    if (!(from < middle && middle < to))
      return ::testing::AssertionFailure()
             << "jumps by " << way << " rad in segment " << segment << " at " << from << " s";
    if (auto found = between(segment, from, middle); !found) return found;
    return between(segment, middle, to);
  }

  const AnyCurve& curve_;
};

}  // namespace orispline::testing_support
