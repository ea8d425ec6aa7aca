// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <gtest/gtest.h>

#include <batch/sampled.hpp>
#include <batch/segment_size.hpp>

namespace orispline::testing_support {

/// A curve's samples against the scalar evaluator's at the same times, which lie in its domain or beside it.
template <class T>
[[nodiscard]] ::testing::AssertionResult agree(const Sampled<T>& samples, const AnyCurve& curve,
                                               std::span<const double> times, Wanted wanted) {
  const auto [q_limit, w_limit, a_limit, j_limit] = limits<T>();
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double t = times[i];
    const SegmentSize size = size_of(curve, curve.knots().segment_at(t));
    const Motion motion = wanted == Wanted::orientation ? Motion{.orientation = curve(t)} : curve.motion(t);
    const double angle = std::max(1.0, size.angle);
    const auto beyond = [&](const char* what, const auto& found, const auto& expected, double allowed) {
      const double off = (found - expected).template lpNorm<Eigen::Infinity>();
      if (off <= allowed) return ::testing::AssertionSuccess();
      return ::testing::AssertionFailure()
             << what << " at t = " << t << " off by " << off << ", allowed " << allowed << " (" << off / allowed
             << " times)\n  found  " << found.transpose() << "\n  wanted " << expected.transpose();
    };
    if (auto ok = beyond("orientation", samples.orientation(i), motion.orientation.coeffs(), q_limit * angle); !ok)
      return ok;
    const double velocity = std::max({1.0, size.velocity, motion.angular_velocity.norm()});
    if (wanted >= Wanted::velocity)
      if (auto ok = beyond("velocity", samples.velocity(i), motion.angular_velocity, w_limit * angle * velocity); !ok)
        return ok;
    const double acceleration = std::max({1.0, size.acceleration, motion.angular_acceleration.norm()});
    if (wanted >= Wanted::acceleration)
      if (auto ok = beyond("acceleration", samples.acceleration(i), motion.angular_acceleration,
                           a_limit * angle * acceleration);
          !ok)
        return ok;
    const double jerk = std::max({1.0, size.jerk, motion.angular_jerk.norm()});
    if (wanted >= Wanted::jerk)
      if (auto ok = beyond("jerk", samples.jerk(i), motion.angular_jerk, j_limit * angle * jerk); !ok) return ok;
  }
  return ::testing::AssertionSuccess();
}

/// The same for whatever can be asked of a sample.
template <class T>
[[nodiscard]] ::testing::AssertionResult agree(const AnyCurve& curve, std::span<const double> times) {
  for (const Wanted wanted : {Wanted::orientation, Wanted::velocity, Wanted::acceleration, Wanted::jerk}) {
    Sampled<T> samples(times.size(), wanted);
    if (const auto sampled = sample<T>(curve, times, samples.spans()); !sampled)
      return ::testing::AssertionFailure() << describe(sampled.error());
    if (auto ok = agree(samples, curve, times, wanted); !ok) return ok << (sizeof(T) == 8 ? "  (double)" : "  (float)");
  }
  return ::testing::AssertionSuccess();
}

}  // namespace orispline::testing_support
