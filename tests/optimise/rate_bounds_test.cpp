// SPDX-License-Identifier: Apache-2.0
#include <orispline/optimise/rate_bounds.hpp>

#include <numbers>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>

#include "random_motion.hpp"

namespace orispline::optimise {
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

/// The largest of one segment at 10001 places.
MotionSizes densely_sampled(const AnyCurve& curve, std::size_t segment) {
  const KnotSpan span = curve.knots().span(segment);
  MotionSizes largest{};
  for (int i = 0; i <= 10000; ++i) {
    const Motion m = curve.motion_on(segment, span.start() + 1e-4 * i * span.step());
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
  EXPECT_FALSE(certified_peaks(make_curve("squad", random_keys(1, {5, 1.0})).value(), {}, low_floors));
}

}  // namespace
}  // namespace orispline::optimise
