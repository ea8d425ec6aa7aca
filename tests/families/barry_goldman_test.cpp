// SPDX-License-Identifier: Apache-2.0
// Barry and Goldman's pyramid: Catmull–Rom in every plane, its rates at the keys, its symmetry.
#include <gtest/gtest.h>

#include <families/winding_keys.hpp>
#include <orispline/curve/catmull_rom_path.hpp>
#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/relative_jumps.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

TEST(BarryGoldman, PassesAKeyWithTheRateOfTheParabolaThroughItsNeighbours) {
  const Keyframes keys = keyframes(random_walk(431, 7, Spacing::uneven, 0.8));
  const auto q = keys.orientations();
  const AnyCurve curve = make_curve("barry-goldman", keys).value();
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const double before = keys.times()[i] - keys.times()[i - 1], after = keys.times()[i + 1] - keys.times()[i];
    const Eigen::Vector3d wanted =
        (after / before * increment<double>(q[i - 1], q[i]) + before / after * increment<double>(q[i], q[i + 1])) /
        (before + after);
    for (const Side side : {Side::left, Side::right})
      EXPECT_TRUE(near(curve.motion(keys.times()[i], side).angular_velocity, wanted, tolerance::rates)) << "key " << i;
  }
}

TEST(BarryGoldman, OfPositionsIsCatmullRomInTime) {
  KeyframeData data = random_walk(432, 7, Spacing::uneven);
  Dice dice(433);
  for (std::size_t i = 0; i < 7; ++i) data.positions.push_back(3.0 * dice.vector());
  const Keyframes keys = keyframes(data);
  const CatmullRomPath wanted(keys);
  const AnyPath path = make_pose_curve("barry-goldman", keys)->position.value();
  for (const double t : sample_times(keys.times()))
    EXPECT_TRUE(near(path.linear_motion(t).position, wanted.point(t, wanted.knots().segment_at(t)), tolerance::series));
}

TEST(BarryGoldman, AboutOneAxisTurnsByTheAngleOfItsOwnPath) {
  KeyframeData data{.times = {0.0, 0.3, 1.0, 1.4, 2.5}};
  const Eigen::Vector3d axis(0.48, -0.6, 0.64);
  for (const double angle : {0.0, 0.5, 0.2, 0.9, 0.7}) {
    data.orientations.push_back(exp<double>(angle * axis));
    data.positions.push_back(angle * axis);
  }
  const PoseCurve pose = make_pose_curve("barry-goldman", keyframes(data)).value();
  for (const double t : sample_times(data.times)) {
    const LinearMotion linear_motion = pose.position->linear_motion(t);
    const Motion motion = pose.orientation.motion(t);
    EXPECT_TRUE(near(motion.orientation, exp<double>(linear_motion.position), tolerance::algebra));
    EXPECT_TRUE(near(motion.angular_velocity, linear_motion.velocity, tolerance::series));
    EXPECT_TRUE(near(motion.angular_acceleration, linear_motion.acceleration, tolerance::rates));
  }
}

TEST(BarryGoldman, TurnsByTheAngleOfItsOwnPathHoweverFarItWinds) {
  expect_the_turn_of_its_path("barry-goldman", winding_keys_about_one_axis());
}

TEST(BarryGoldman, IsAsSmoothWhereItWinds) {
  for (const double aside : {0.0, 1e-12, 1e-8}) {
    const AnyCurve curve = make_curve("barry-goldman", winding_keys_about_one_axis(aside)).value();
    const auto jumps = relative_jumps(curve);
    for (std::size_t k = 0; k <= 1; ++k) EXPECT_LE(jumps[k], tolerance::continuity) << "order " << k;
  }
}

TEST(BarryGoldman, IsTheSameCurveWhenKeysAndTimeAreReversed) {
  const KeyframeData data = random_walk(434, 6, Spacing::uneven, 0.8);
  KeyframeData reversed;
  for (std::size_t i = 6; i-- > 0;) {
    reversed.times.push_back(-data.times[i]);
    reversed.orientations.push_back(data.orientations[i]);
  }
  const AnyCurve forth = make_curve("barry-goldman", keyframes(data)).value();
  const AnyCurve back = make_curve("barry-goldman", keyframes(reversed)).value();
  for (const double t : sample_times(data.times)) EXPECT_TRUE(near(back(-t), forth(t), tolerance::series)) << t;
}

}}  // namespace orispline
