// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/rate_bounds.hpp>

#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>

#include "support/random_motion.hpp"

namespace orispline {
namespace {

constexpr double degrees = std::numbers::pi / 180.0;
const Eigen::Vector3d moments(1.0, 2.0, 2.5);
const std::optional<Eigen::Matrix3d> inertia = Eigen::Matrix3d(moments.asDiagonal());
constexpr MotionSizes low_floors{1e-3, 1e-3, 1e-3};

/// Euler's equations, component by component.
double torque_by_components(const Motion& m) {
  const Eigen::Vector3d& w = m.angular_velocity;
  const Eigen::Vector3d& a = m.angular_acceleration;
  return std::hypot(moments[0] * a[0] - (moments[1] - moments[2]) * w[1] * w[2],
                    moments[1] * a[1] - (moments[2] - moments[0]) * w[2] * w[0],
                    moments[2] * a[2] - (moments[0] - moments[1]) * w[0] * w[1]);
}

/// The largest of one segment at so many steps.
MotionSizes densely_sampled(const AnyCurve& curve, std::size_t segment, int steps = 10000) {
  const KnotSpan span = curve.knots().span(segment);
  MotionSizes largest{};
  for (int i = 0; i <= steps; ++i) {
    const Motion m = curve.motion_on(segment, span.start() + i * span.step() / steps);
    largest.rate = std::max(largest.rate, m.angular_velocity.norm());
    largest.acceleration = std::max(largest.acceleration, m.angular_acceleration.norm());
    largest.torque = std::max(largest.torque, torque_by_components(m));
  }
  return largest;
}

void expect_tight(const CertifiedPeak& peak, double sampled, const std::string& what) {
  EXPECT_GE(peak.bound, sampled) << what;
  EXPECT_LE(peak.bound, std::max(1e-3, peak.found * (1.0 + 1.001e-4))) << what;
  EXPECT_LE(peak.found, sampled * (1.0 + 1e-4) + 1e-9) << what;
}

void expect_bounds(const AnyCurve& curve, const std::string& what) {
  const auto peaks = certified_peaks(curve, inertia, low_floors).value();
  ASSERT_EQ(peaks.size(), curve.knots().segments());
  for (std::size_t s = 0; s < peaks.size(); ++s) {
    const MotionSizes sampled = densely_sampled(curve, s);
    expect_tight(peaks[s].rate, sampled.rate, what + ", rate");
    expect_tight(peaks[s].acceleration, sampled.acceleration, what + ", acceleration");
    expect_tight(peaks[s].torque, sampled.torque, what + ", torque");
  }
}

TEST(RateBounds, HoldEverywhereAndAreNearForEveryMethodOfPolynomialsWithRatesOfItsOwn) {
  std::size_t methods = 0;
  for (const FamilyInfo& info : families_info()) {
    const std::string name(info.name);
    unsigned seed = 7;
    for (const RandomKeys how :
         {RandomKeys{4, 60.0 * degrees}, RandomKeys{4, 170.0 * degrees, 100.0}, RandomKeys{2, 170.0 * degrees}}) {
      const auto curve = make_curve(info.name, random_keys(++seed, how));
      if (info.rate_orders > 0 || !curve || !certified_peaks(*curve, {}, low_floors)) continue;
      expect_bounds(*curve, name + " of " + std::to_string(how.count));
      ++methods;
    }
  }
  EXPECT_GE(methods, 40u);
}

TEST(RateBounds, HoldOnIntervalsThatAreNotHalved) {
  constexpr double any = std::numeric_limits<double>::infinity();
  for (unsigned seed = 0; seed < 40; ++seed)
    for (const std::string_view method : {"auto", "timed-c2", "timed-c1", "bspline"}) {
      const AnyCurve curve = make_curve(method, random_keys(seed, {5, 3.0, seed % 2 == 0 ? 1.0 : 10.0})).value();
      const auto peaks = certified_peaks(curve, inertia, {any, any, any}).value();
      for (std::size_t s = 0; s < peaks.size(); ++s) {
        const MotionSizes sampled = densely_sampled(curve, s, 200);
        EXPECT_GE(peaks[s].rate.bound, sampled.rate) << method << seed;
        EXPECT_GE(peaks[s].acceleration.bound, sampled.acceleration) << method << seed;
        EXPECT_GE(peaks[s].torque.bound, sampled.torque) << method << seed;
      }
    }
}

TEST(RateBounds, OfTheSnapIsAboveThatOfTheCurve) {
  for (unsigned seed = 0; seed < 20; ++seed)
    for (const std::string_view method : {"auto", "timed-c2", "timed-sextic", "bspline"}) {
      const AnyCurve curve = make_curve(method, random_keys(seed, {5, 3.0, 10.0})).value();
      for (std::size_t s = 0; s < curve.knots().segments(); ++s) {
        const KnotSpan span = curve.knots().span(s);
        const double bound = snap_bound(curve.form(s), span.step()).value();
        for (int i = 1; i < 100; ++i) {
          const double t = span.start() + 0.01 * i * span.step(), h = 1e-5 * span.step();
          const Eigen::Vector3d difference =
              curve.motion_on(s, t + h).angular_jerk - curve.motion_on(s, t - h).angular_jerk;
          EXPECT_LE(difference.norm() / (2.0 * h), bound * (1.0 + 1e-6)) << method << seed;
        }
      }
    }
}

TEST(RateBounds, OfTheSnapIsThatOfASmallTurn) {
  constexpr double angle = 1e-4, duration = 2.0;  // [rad], [s]; about one axis by angle · u⁴
  ChartForm quartic{.degree = 4, .base = Eigen::Quaterniond::Identity(), .rotation_vector = {}};
  quartic.rotation_vector[1].coefficients[4] = angle;
  EXPECT_NEAR(snap_bound(quartic, duration).value() / (24.0 * angle / std::pow(duration, 4)), 1.0, 0.01);
  CumulativeForm steady{.degree = 1,
                        .base = Eigen::Quaterniond::Identity(),
                        .increments = {Eigen::Vector3d(0, 0, 3), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()},
                        .blending = {}};
  steady.blending[0].coefficients[1] = 1.0;
  EXPECT_NEAR(snap_bound(steady, duration).value(), std::pow(3.0 / duration, 4), 1e-9);
  EXPECT_FALSE(snap_bound({}, duration));
}

TEST(RateBounds, AreZeroAtRest) {
  const auto rest = Keyframes::make({.times = {0, 1, 3}, .orientations = std::vector(3, exp<double>({1.0, 2.0, 0.5}))});
  for (const std::string_view method : {"auto", "timed-c2"}) {
    const auto found = certified_peaks(make_curve(method, rest.value()).value(), inertia, low_floors).value();
    for (const SegmentPeaks& peaks : found) {
      EXPECT_LE(peaks.rate.bound, 1e-12);
      EXPECT_LE(peaks.acceleration.bound, 1e-12);
      EXPECT_LE(peaks.torque.bound, 1e-11);
      EXPECT_EQ(peaks.rate.found, 0.0);
    }
  }
}

TEST(RateBounds, HoldWhereTimesAreRoundedMuch) {
  const Keyframes keys = random_keys(3, {5, 1.0});
  KeyframeData late{.orientations = {keys.orientations().begin(), keys.orientations().end()}};
  for (const double t : keys.times()) late.times.push_back(1.7e9 + 0.01 * t);  // [s]; a double there is exact to 2e-7 s
  expect_bounds(make_curve("timed-c2", Keyframes::make(late).value()).value(), "late");
}

TEST(RateBounds, ThatAreBelowTheFloorsAreNearEnough) {
  const AnyCurve curve = make_curve("auto", random_keys(5, {6, 1.0})).value();
  const auto found = certified_peaks(curve, {}, {100.0, 1000.0, 1.0}).value();
  for (const SegmentPeaks& peaks : found) {
    EXPECT_LE(peaks.rate.bound, 100.0);
    EXPECT_LE(peaks.acceleration.bound, 1000.0);
    EXPECT_EQ(peaks.torque.bound, 0.0);
  }
}

TEST(RateBounds, SamplesAreThoseOfTheCurve) {
  const AnyCurve curve = make_curve("auto", random_keys(5, {6, 2.0, 10.0})).value();
  const auto sampled = sampled_peaks(curve, inertia);
  ASSERT_EQ(sampled.size(), 5u);
  for (std::size_t s = 0; s < sampled.size(); ++s) {
    const MotionSizes dense = densely_sampled(curve, s);
    EXPECT_NEAR(sampled[s].rate / dense.rate, 1.0, 0.02);
    EXPECT_NEAR(sampled[s].acceleration / dense.acceleration, 1.0, 0.05);
    EXPECT_NEAR(sampled[s].torque / dense.torque, 1.0, 0.05);
    EXPECT_LE(sampled[s].rate, dense.rate * (1.0 + 1e-9));
  }
}

TEST(RateBounds, AreUnknownWithoutPolynomials) {
  for (const std::size_t keys : {2u, 5u})
    EXPECT_FALSE(certified_peaks(make_curve("squad", random_keys(1, {keys, 1.0})).value(), {}, low_floors)) << keys;
}

}  // namespace
}  // namespace orispline
