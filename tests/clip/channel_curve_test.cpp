// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <orispline/clip/clip.hpp>
#include <orispline/clip/clip_motion.hpp>

namespace orispline { namespace {

using std::numbers::pi;

Eigen::Quaterniond about_x(double angle) { return {std::cos(angle / 2), std::sin(angle / 2), 0.0, 0.0}; }

RotationChannel quarter_turn(ChannelInterpolation interpolation) {
  RotationChannel channel{
      .interpolation = interpolation, .times = {1.0, 3.0}, .values = {about_x(0.0), about_x(pi / 2)}};
  if (interpolation == ChannelInterpolation::cubicspline)
    channel.in_tangents = channel.out_tangents = {Eigen::Quaterniond(0, 0, 0, 0), Eigen::Quaterniond(0, 0, 0, 0)};
  return channel;
}

double angle_to(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) { return angular_distance(a, b); }

TEST(ChannelCurve, OfStepsKeepsTheKeyBeforeUntilTheNext) {
  const ChannelCurve<Eigen::Quaterniond> curve(quarter_turn(ChannelInterpolation::step));
  EXPECT_EQ(angle_to(curve.at(0.0), about_x(0.0)), 0.0);
  EXPECT_EQ(angle_to(curve.at(2.999), about_x(0.0)), 0.0);
  EXPECT_EQ(angle_to(curve.at(3.0), about_x(pi / 2)), 0.0);
  EXPECT_EQ(angle_to(curve.at(9.0), about_x(pi / 2)), 0.0);
  EXPECT_EQ(curve.motion(2.0).angular_velocity, Eigen::Vector3d::Zero());
}

TEST(ChannelCurve, OfGeodesicsGoesTheShorterWayWhateverTheSigns) {
  RotationChannel channel = quarter_turn(ChannelInterpolation::linear);
  channel.values[1].coeffs() = -channel.values[1].coeffs();
  const ChannelCurve<Eigen::Quaterniond> curve(channel);
  EXPECT_NEAR(angle_to(curve.at(2.0), about_x(pi / 4)), 0.0, 1e-15);
  const Motion motion = curve.motion(1.5);
  EXPECT_NEAR(motion.angular_velocity.x(), pi / 4, 1e-14);
  EXPECT_NEAR(motion.angular_acceleration.norm(), 0.0, 1e-13);
}

/// The formula of glTF 2.0, appendix C, written out.
Eigen::Vector4d specified(const RotationChannel& c, double t) {
  const double h = c.times[1] - c.times[0], u = (t - c.times[0]) / h, u2 = u * u, u3 = u2 * u;
  const Eigen::Vector4d sum = (2 * u3 - 3 * u2 + 1) * c.values[0].coeffs() +
                              h * (u3 - 2 * u2 + u) * c.out_tangents[0].coeffs() +
                              (-2 * u3 + 3 * u2) * c.values[1].coeffs() + h * (u3 - u2) * c.in_tangents[1].coeffs();
  return sum.normalized();
}

TEST(ChannelCurve, OfCubicSplinesIsTheFormulaOfItsSpecification) {
  RotationChannel channel = quarter_turn(ChannelInterpolation::cubicspline);
  channel.out_tangents[0] = {0.1, 0.3, -0.2, 0.4};
  channel.in_tangents[1] = {-0.2, 0.1, 0.5, 0.05};
  const ChannelCurve<Eigen::Quaterniond> curve(channel);
  for (const double t : {1.0, 1.01, 1.7, 2.5, 2.99})
    EXPECT_LT((curve.at(t).coeffs() - specified(channel, t)).norm(), 1e-15) << t;
}

TEST(ChannelCurve, OfCubicSplinesHasTheRatesOfThatFormula) {
  RotationChannel channel = quarter_turn(ChannelInterpolation::cubicspline);
  channel.out_tangents[0] = {0.1, 0.3, -0.2, 0.4};
  channel.in_tangents[1] = {-0.2, 0.1, 0.5, 0.05};
  const ChannelCurve<Eigen::Quaterniond> curve(channel);
  const double t = 1.8, h = 1e-5;
  const auto rate = [&](double at) {
    const Eigen::Quaterniond derivative(
        Eigen::Vector4d((specified(channel, at + h) - specified(channel, at - h)) / (2 * h)));
    return Eigen::Vector3d(2.0 * (Eigen::Quaterniond(specified(channel, at)).conjugate() * derivative).vec());
  };
  const Motion motion = curve.motion(t);
  EXPECT_LT((motion.angular_velocity - rate(t)).norm(), 1e-9);
  EXPECT_LT((motion.angular_acceleration - (rate(t + h) - rate(t - h)) / (2 * h)).norm(), 1e-5);
}

TEST(ChannelCurve, OfCubicSplinesIsWithinTheStatedAnglesOfAConstantRate) {
  for (const auto& [turn, bound] : {std::pair(60.0, 0.0013), std::pair(90.0, 0.010), std::pair(120.0, 0.042)}) {
    const double angle = turn * pi / 180.0;
    RotationChannel channel{.interpolation = ChannelInterpolation::cubicspline,
                            .times = {0.0, 1.0},
                            .values = {about_x(0.0), about_x(angle)}};
    for (const Eigen::Quaterniond& q : channel.values) {
      const Eigen::Quaterniond rate = q * Eigen::Quaterniond(0.0, angle / 2, 0.0, 0.0);
      channel.in_tangents.push_back(rate);
      channel.out_tangents.push_back(rate);
    }
    const ChannelCurve<Eigen::Quaterniond> curve(channel);
    double worst = 0.0;
    for (int i = 0; i <= 1000; ++i) worst = std::max(worst, angle_to(curve.at(i * 1e-3), about_x(angle * i * 1e-3)));
    EXPECT_LT(worst * 180.0 / pi, 1.05 * bound) << turn;
    EXPECT_GT(worst * 180.0 / pi, 0.90 * bound) << turn;
  }
}

TEST(ChannelCurve, OfVectorsHasItsTangentsOnBothSidesOfAKey) {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), none = Eigen::Vector3d::Zero();
  const VectorChannel channel{.interpolation = ChannelInterpolation::cubicspline,
                              .times = {0.0, 2.0, 3.0},
                              .values = {none, x, none},
                              .in_tangents = {none, 2.0 * x, -x},
                              .out_tangents = {x, -3.0 * x, none}};
  const ChannelCurve<Eigen::Vector3d> curve(channel);
  EXPECT_NEAR(curve.motion(0.0).velocity.x(), 1.0, 1e-15);
  EXPECT_NEAR(curve.motion(std::nextafter(2.0, 0.0)).velocity.x(), 2.0, 1e-12);
  EXPECT_NEAR(curve.motion(2.0).velocity.x(), -3.0, 1e-15);
  EXPECT_NEAR(curve.motion(3.0).velocity.x(), -1.0, 1e-15);
  EXPECT_EQ(curve.at(2.0), x);
  EXPECT_EQ(curve.motion(4.0).velocity, none);
}

TEST(ChannelCurve, OfOneKeyStandsStill) {
  for (const auto interpolation : {ChannelInterpolation::step, ChannelInterpolation::linear}) {
    const ChannelCurve<Eigen::Vector3d> curve({.interpolation = interpolation, .times = {1.0}, .values = {{1, 2, 3}}});
    for (const double t : {0.0, 1.0, 2.0}) EXPECT_EQ(curve.at(t), Eigen::Vector3d(1, 2, 3));
  }
}

}}  // namespace orispline
