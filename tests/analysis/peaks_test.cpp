// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/curve_measures.hpp>

#include <gtest/gtest.h>

#include <orispline/curve/motion.hpp>
#include <orispline/families/registry.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using testing_support::about_x;

Keyframes keys_of_ever_faster_turns() {
  KeyframeData data{.times = {0.0}, .orientations = {Eigen::Quaterniond::Identity()}};
  for (std::size_t i = 0; i < 9; ++i) {
    const double x = static_cast<double>(i);
    data.times.push_back(data.times.back() + 0.4 + 0.3 * std::sin(x));
    data.orientations.push_back(data.orientations.back() *
                                exp<double>({0.5 * std::cos(2.1 * x), 0.5 * std::sin(1.3 * x), 0.4 * std::cos(x)}));
  }
  return Keyframes::make(std::move(data)).value();
}

TEST(Peaks, OfACubicTurnAreInTheMiddleAndAtTheEnds) {
  KeyframeData data{.times = {1.0, 3.0}, .orientations = {about_x(0.0), about_x(1.0)}};
  data.angular_velocities = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  const Peaks p = peaks(make_curve("hermite-c1", Keyframes::make(std::move(data)).value()).value());

  EXPECT_NEAR(p.angular_velocity.value, 1.5 / 2.0, 1e-15);  // 6u(1 - u)/h
  EXPECT_NEAR(p.angular_velocity.time, 2.0, 1e-12);
  EXPECT_NEAR(p.angular_acceleration.value, 6.0 / 4.0, 1e-14);  // at both ends alike
  EXPECT_NEAR(std::abs(p.angular_acceleration.time - 2.0), 1.0, 1e-12);
}

TEST(Peaks, AreNeverBelowADenseSampleAndAreReachedAtTheirTimes) {
  const Eigen::Matrix3d inertia = Eigen::Vector3d(1.0, 2.0, 4.0).asDiagonal();
  for (const char* family : {"auto", "timed-c2", "global-c2", "tcb"}) {
    const AnyCurve curve = make_curve(family, keys_of_ever_faster_turns()).value();
    const Peaks p = peaks(curve, inertia);
    Eigen::Array3d largest = Eigen::Array3d::Zero();
    const auto rates = [&](const Motion& m) {
      return Eigen::Array3d(m.angular_velocity.norm(), m.angular_acceleration.norm(), torque(m, inertia).norm());
    };
    const Domain domain = curve.domain();
    constexpr int steps = 20000;
    for (int k = 0; k <= steps; ++k)
      largest = largest.max(rates(curve.motion(std::lerp(domain.start, domain.end, static_cast<double>(k) / steps))));
    for (const double t : curve.knots().times())
      for (const Side side : {Side::left, Side::right}) largest = largest.max(rates(curve.motion(t, side)));
    const Eigen::Array3d found(p.angular_velocity.value, p.angular_acceleration.value, p.torque.value);
    EXPECT_TRUE((found >= largest * (1.0 - 1e-12)).all()) << family << found - largest;
    EXPECT_TRUE((found <= largest * (1.0 + 1e-6)).all()) << family << found - largest;
    const auto reached = [&](double t, int rate) {
      return std::max(rates(curve.motion(t, Side::left))[rate], rates(curve.motion(t, Side::right))[rate]);
    };
    EXPECT_NEAR(reached(p.angular_velocity.time, 0), found[0], 1e-12) << family;
    EXPECT_NEAR(reached(p.angular_acceleration.time, 1), found[1], 1e-11) << family;
    EXPECT_NEAR(reached(p.torque.time, 2), found[2], 1e-11) << family;
  }
}

TEST(Peaks, SeeBothSidesOfAKeyWhereTheRateJumps) {
  const auto keys =
      Keyframes::make({.times = {0.0, 1.0, 3.0}, .orientations = {about_x(0.0), about_x(0.5), about_x(0.6)}}).value();
  EXPECT_NEAR(peaks(make_curve("slerp", keys).value()).angular_velocity.value, 0.5, 1e-15);
}

TEST(Torque, IsItsInertiaTimesTheAccelerationAndWhatTheTurningAxesAdd) {
  const Eigen::Matrix3d inertia = Eigen::Vector3d(1.0, 2.0, 4.0).asDiagonal();
  const Motion m{.angular_velocity = {1.0, 2.0, 3.0}, .angular_acceleration = {0.1, 0.2, 0.3}};
  EXPECT_TRUE(torque(m, inertia).isApprox(Eigen::Vector3d(0.1 + 12.0, 0.4 - 9.0, 1.2 + 2.0), 1e-15));
}

TEST(Torque, ChangesAtItsRate) {
  const AnyCurve curve = make_curve("timed-c3", keys_of_ever_faster_turns()).value();
  const Eigen::Matrix3d inertia = Eigen::Vector3d(1.0, 2.0, 4.0).asDiagonal();
  const double t = 1.3, h = 1e-5;
  const Eigen::Vector3d slope =
      (torque(curve.motion(t + h), inertia) - torque(curve.motion(t - h), inertia)) / (2.0 * h);
  EXPECT_LT((torque_rate(curve.motion(t), inertia) - slope).norm(), 1e-5 * slope.norm());
}

}}  // namespace orispline
