// SPDX-License-Identifier: Apache-2.0
// What curves and paths are outside their domain, in each of the ways that can be asked for.
#include <orispline/curve/extrapolation.hpp>

#include <limits>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/key_use.hpp>
#include <support/near.hpp>
#include <support/not_finite.hpp>
#include <support/tracks.hpp>

namespace orispline { namespace {

using namespace testing_support;

const Eigen::Vector3d oblique(0.36, -0.48, 0.8);

/// A turn about one axis by the angle t³/20 − t²/10 + 2t/5 + 3/10 rad, and its rates.
Motion cubic_turn(double t) {
  const double angle = ((0.05 * t - 0.1) * t + 0.4) * t + 0.3;
  return {.orientation = exp<double>(angle * oblique),
          .angular_velocity = ((0.15 * t - 0.2) * t + 0.4) * oblique,
          .angular_acceleration = (0.3 * t - 0.2) * oblique,
          .angular_jerk = 0.3 * oblique};
}

KeyframeData keys_of_cubic_turn() {
  KeyframeData data{.times = {0.0, 1.0, 2.5, 4.0}};
  for (const double t : data.times) {
    data.orientations.push_back(cubic_turn(t).orientation);
    data.positions.emplace_back(1.0 + 2.0 * t - t * t, 3.0 * t, -0.5 * t * t);
  }
  return data;
}

TEST(Extrapolation, BySegmentTheCubicThroughTheKeysGoesOn) {
  const End start{.rule = EndRule::clamped, .angular_velocity = cubic_turn(0.0).angular_velocity};
  const End end{.rule = EndRule::clamped, .angular_velocity = cubic_turn(4.0).angular_velocity};
  const AnyCurve curve =
      make_curve({"rotation-spline", {.start = start, .end = end}}, keyframes(keys_of_cubic_turn())).value();
  for (const double t : {-2.0, -0.7, 2.0, 4.25, 5.5})
    EXPECT_TRUE(near(extrapolated(curve, t, Extrapolation::segment), cubic_turn(t), tolerance::golden)) << t;
}

TEST(Extrapolation, BySegmentAParabolaOfPositionsGoesOn) {
  const PoseCurve curve = make_pose_curve("hermite-c2", keyframes(keys_of_cubic_turn())).value();
  for (const double t : {-3.0, 5.0}) {
    const LinearMotion there = extrapolated(*curve.position, t, Extrapolation::segment);
    EXPECT_TRUE(
        near(there.position, Eigen::Vector3d(1.0 + 2.0 * t - t * t, 3.0 * t, -0.5 * t * t), tolerance::algebra));
    EXPECT_TRUE(near(there.velocity, Eigen::Vector3d(2.0 - 2.0 * t, 3.0, -t), tolerance::series));
    EXPECT_TRUE(near(there.acceleration, Eigen::Vector3d(-2.0, 0.0, -1.0), tolerance::rates));
    EXPECT_TRUE(near(there.jerk, Eigen::Vector3d::Zero().eval(), tolerance::rates));
  }
}

TEST(Extrapolation, ByRateTheTurnGoesOnAboutAFixedAxisAtAConstantSpeed) {
  const Keyframes keys = keyframes(posed_walk(71, 7, Spacing::uneven));
  const PoseCurve curve = make_pose_curve("timed-c2", keys).value();
  for (const std::size_t key : {std::size_t{0}, keys.size() - 1}) {
    const double end = keys.times()[key], away = key == 0 ? -1.75 : 1.75;
    const Motion there = curve.orientation.motion(end),
                 beyond = extrapolated(curve.orientation, end + away, Extrapolation::rate);
    const double speed = there.angular_velocity.norm();
    ASSERT_GT(speed, 0.1);
    const Eigen::AngleAxisd turn(speed * away, there.angular_velocity / speed);
    EXPECT_TRUE((beyond.orientation.toRotationMatrix()).isApprox(there.orientation * turn.toRotationMatrix(), 1e-14));
    EXPECT_EQ(beyond.angular_velocity, there.angular_velocity);
    EXPECT_TRUE(near(angular_velocity_world(beyond), angular_velocity_world(there), tolerance::algebra));
    EXPECT_TRUE(beyond.angular_acceleration.isZero(0) && beyond.angular_jerk.isZero(0));
    const LinearMotion from = curve.position->linear_motion(end),
                       to = extrapolated(*curve.position, end + away, Extrapolation::rate);
    EXPECT_TRUE(near(to.position, Eigen::Vector3d(from.position + away * from.velocity), tolerance::exact));
    EXPECT_EQ(to.velocity, from.velocity);
    EXPECT_TRUE(to.acceleration.isZero(0) && to.jerk.isZero(0));
  }
}

TEST(Extrapolation, ByRateAndBySegmentASlerpIsTheSame) {
  const Keyframes keys = keyframes(posed_walk(72, 5, Spacing::uneven));
  const PoseCurve curve = make_pose_curve("slerp", keys).value();
  for (const double t : {keys.times().front() - 0.3, keys.times().back() + 0.3}) {
    EXPECT_TRUE(near(extrapolated(curve.orientation, t, Extrapolation::rate),
                     extrapolated(curve.orientation, t, Extrapolation::segment), {1e-13, 1e-13, 1e-12, 1e-11}));
    EXPECT_TRUE(near(extrapolated(*curve.position, t, Extrapolation::rate).position,
                     extrapolated(*curve.position, t, Extrapolation::segment).position, tolerance::algebra));
  }
}

TEST(Extrapolation, BySegmentEveryFamilyHasTheRatesOfItsOrientations) {
  for (const FamilyInfo& family : families_info()) {
    const Keyframes keys =
        keyframes(random_walk(73, family.key_use.keys_for(7), Spacing::even, step_on(family, Spacing::even, 0.7)));
    const AnyCurve curve = make_curve(family.name, keys).value();
    const auto [start, end] = curve.domain();
    constexpr double h = tolerance::difference_step;
    for (const double t : {start - 0.05, end + 0.05}) {
      const auto at = [&](double time) { return extrapolated(curve, time, Extrapolation::segment); };
      const Eigen::Vector3d turn = increment<double>(at(t - h).orientation, at(t + h).orientation) / (2.0 * h);
      EXPECT_TRUE(near(turn, at(t).angular_velocity, 1e-6)) << family.name;
      const Eigen::Vector3d change = (at(t + h).angular_velocity - at(t - h).angular_velocity) / (2.0 * h);
      EXPECT_TRUE(near(change, at(t).angular_acceleration, 1e-6)) << family.name;
      const Eigen::Vector3d jerk = (at(t + h).angular_acceleration - at(t - h).angular_acceleration) / (2.0 * h);
      EXPECT_TRUE(near(jerk, at(t).angular_jerk, 1e-5)) << family.name;
    }
    for (const double side : {start, end})
      EXPECT_TRUE(near(extrapolated(curve, side + (side == start ? -1e-9 : 1e-9), Extrapolation::segment),
                       curve.motion(side), {1e-7, 1e-6, 1e-5, 1e-4}))
          << family.name;
  }
}

TEST(Extrapolation, InsideEveryWayIsTheCurveItself) {
  const Keyframes keys = keyframes(posed_walk(74, 6, Spacing::uneven));
  const PoseCurve curve = make_pose_curve("auto", keys).value();
  for (const Word& how : words<Extrapolation>)
    for (const double t : sample_times(keys.times())) {
      const auto way = static_cast<Extrapolation>(how.value);
      EXPECT_TRUE(near(extrapolated(curve.orientation, t, way), curve.orientation.motion(t), {0, 0, 0, 0})) << how.word;
      EXPECT_EQ(extrapolated(*curve.position, t, way).velocity, curve.position->linear_motion(t).velocity) << how.word;
    }
}

TEST(Extrapolation, HoldsTheEndOrGivesNotANumber) {
  const Keyframes keys = keyframes(posed_walk(75, 4, Spacing::uneven));
  const PoseCurve curve = make_pose_curve("timed-c2", keys).value();
  const double later = keys.times().back() + 2.0;
  EXPECT_TRUE(near(extrapolated(curve.orientation, later, Extrapolation::hold),
                   {.orientation = keys.orientations().back()}, {tolerance::algebra, 0, 0, 0}));
  for (const Extrapolation how : {Extrapolation::nan, Extrapolation::error}) {
    const Motion none = extrapolated(curve.orientation, later, how);
    EXPECT_TRUE(none.orientation.coeffs().array().isNaN().all() && none.angular_velocity.array().isNaN().all() &&
                none.angular_acceleration.array().isNaN().all() && none.angular_jerk.array().isNaN().all());
    const LinearMotion nowhere = extrapolated(*curve.position, later, how);
    EXPECT_TRUE(nowhere.position.array().isNaN().all() && nowhere.velocity.array().isNaN().all() &&
                nowhere.acceleration.array().isNaN().all() && nowhere.jerk.array().isNaN().all());
  }
}

TEST(Extrapolation, ThroughOneKeyNothingMovesAndNotANumberStaysOne) {
  const PoseCurve curve = make_pose_curve("auto", keyframes(posed_walk(76, 1, Spacing::even))).value();
  const Eigen::Vector3d place = curve.position->linear_motion(0.0).position;
  for (const Extrapolation how : {Extrapolation::hold, Extrapolation::rate, Extrapolation::segment}) {
    EXPECT_TRUE(near(extrapolated(curve.orientation, 9.0, how), curve.orientation.motion(9.0), {0, 0, 0, 0}));
    EXPECT_EQ(extrapolated(*curve.position, -9.0, how).position, place);
    EXPECT_TRUE(extrapolated(curve.orientation, nan, how).orientation.coeffs().hasNaN());
    EXPECT_TRUE(extrapolated(*curve.position, nan, how).position.hasNaN());
  }
}

}}  // namespace orispline
