// SPDX-License-Identifier: Apache-2.0
// Shoemake's Bézier curve: Double and Bisect as published, and the same in time.
#include <gtest/gtest.h>

#include <families/same_curve.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/geodesic.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

CurveOptions timing(const char* word) { return {.choices = {{"timing", word}}}; }

/// 2 (p·q) q - p: as far beyond q as p is before it.
Eigen::Vector4d doubled(const Eigen::Vector4d& p, const Eigen::Vector4d& q) { return 2.0 * p.dot(q) * q - p; }

Eigen::Vector4d bisected(const Eigen::Vector4d& p, const Eigen::Vector4d& q) { return (p + q).normalized(); }

/// De Casteljau's algorithm.
Eigen::Quaterniond bezier(std::vector<Eigen::Quaterniond> points, double u) {
  for (; points.size() > 1; points.pop_back())
    for (std::size_t k = 0; k + 1 < points.size(); ++k) points[k] = slerp<double>(points[k], points[k + 1], u);
  return points.front();
}

Keyframes keys_with_positions(std::uint64_t seed) {
  KeyframeData data = random_walk(seed, 6, Spacing::uneven, 0.6);
  Dice dice(seed + 1);
  for (std::size_t i = 0; i < 6; ++i) data.positions.push_back(3.0 * dice.vector());
  return keyframes(data);
}

TEST(Shoemake, AsPublishedIsTheBezierCurveOfDoubleAndBisect) {
  for (const Spacing spacing : {Spacing::even, Spacing::uneven}) {
    const Keyframes keys = keyframes(random_walk(401, 5, spacing));
    const auto q = keys.orientations();
    const auto target = [&q](std::size_t n) {
      return Eigen::Quaterniond(bisected(doubled(q[n - 1].coeffs(), q[n].coeffs()), q[n + 1].coeffs()));
    };
    const Eigen::Quaterniond behind(doubled(target(3).coeffs(), q[3].coeffs()));
    const AnyCurve curve = make_curve({"shoemake", timing("published")}, keys).value();
    for (const double u : {0.1, 0.5, 0.7}) {
      const double t = keys.times()[2] + u * (keys.times()[3] - keys.times()[2]);
      const auto wanted =
          bezier({q[2], slerp<double>(q[2], target(2), 1.0 / 3.0), slerp<double>(q[3], behind, 1.0 / 3.0), q[3]}, u);
      EXPECT_TRUE(near(curve(t), wanted, tolerance::algebra)) << u;
    }
  }
}

TEST(Shoemake, InTimeIsThePublishedCurveOnEvenTimes) {
  const Keyframes keys = keyframes(random_walk(402, 7, Spacing::even));
  const AnyCurve in_time = make_curve("shoemake", keys).value();
  const AnyCurve published = make_curve({"shoemake", timing("published")}, keys).value();
  for (const double t : sample_times(keys.times()))
    EXPECT_TRUE(near(in_time.motion(t), published.motion(t), same_curve)) << t;
}

TEST(Shoemake, AsPublishedKeepsOnlyTheDirectionOfTheRateAcrossUnevenTimes) {
  const Keyframes keys = keyframes(random_walk(403, 6, Spacing::uneven, 0.6));
  const AnyCurve curve = make_curve({"shoemake", timing("published")}, keys).value();
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const double before = keys.times()[i] - keys.times()[i - 1], after = keys.times()[i + 1] - keys.times()[i];
    const Eigen::Vector3d left = curve.motion(keys.times()[i], Side::left).angular_velocity;
    const Eigen::Vector3d right = curve.motion(keys.times()[i], Side::right).angular_velocity;
    EXPECT_TRUE(near(left * before, right * after, tolerance::rates)) << "key " << i;
  }
}

TEST(Shoemake, LeavesInTimeForThePointBetweenTheStepContinuedAndTheNextKey) {
  const Keyframes keys = keyframes(random_walk(404, 4, Spacing::uneven, 0.3));
  const auto q = keys.orientations();
  const double before = keys.times()[2] - keys.times()[1], after = keys.times()[3] - keys.times()[2];
  const auto continued = slerp<double>(q[1], q[2], 1.0 + after / before);
  const auto target = slerp<double>(continued, q[3], before / (before + after));
  const AnyCurve curve = make_curve("shoemake", keys).value();
  for (const Side side : {Side::left, Side::right})
    EXPECT_TRUE(near(curve.motion(keys.times()[2], side).angular_velocity, increment<double>(q[2], target) / after,
                     tolerance::rates));
}

TEST(Shoemake, PositionsInTimePassAKeyWithTheVelocityOfTheParabolaThroughItsNeighbours) {
  const Keyframes keys = keys_with_positions(405);
  const auto p = keys.positions();
  const auto t = keys.times();
  const PoseCurve pose = make_pose_curve("shoemake", keys).value();
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const double before = t[i] - t[i - 1], after = t[i + 1] - t[i];
    const Eigen::Vector3d wanted =
        (after / before * (p[i] - p[i - 1]) + before / after * (p[i + 1] - p[i])) / (before + after);
    for (const Side side : {Side::left, Side::right})
      EXPECT_TRUE(near(pose.position->linear_motion(t[i], side).velocity, wanted, tolerance::rates)) << "key " << i;
  }
}

TEST(Shoemake, PositionsAsPublishedLeaveAlongTheChordOfTheNeighbours) {
  const Keyframes keys = keys_with_positions(406);
  const auto p = keys.positions();
  const double after = keys.times()[3] - keys.times()[2];
  const PoseCurve pose = make_pose_curve({"shoemake", timing("published")}, keys).value();
  EXPECT_TRUE(
      near(pose.position->linear_motion(keys.times()[2]).velocity, 0.5 * (p[3] - p[1]) / after, tolerance::rates));
}

TEST(Shoemake, RefusesAnotherTiming) {
  const auto curve = make_curve({"shoemake", timing("uniform")}, keyframes(random_walk(407, 3, Spacing::even)));
  ASSERT_FALSE(curve);
  EXPECT_EQ(curve.error().message, "shoemake: timing is 'uniform', wanted one of time, published");
}

TEST(Shoemake, LosesC1WhereAHandleIsLongerThanAFullTurn) {
  // Known limit of the method: key 1 turns at 22.7 rad/s, a third of which is the handle of the slow segment before it,
  // and de Casteljau's algorithm takes its logarithm.
  KeyframeData data{.times = {0.0, 1.0, 1.1, 2.1}};
  for (const double angle : {0.0, 0.0, 2.5, 2.5})
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0, 0, angle)));
  const AnyCurve curve = make_curve("shoemake", keyframes(data)).value();
  const Motion left = curve.motion(1.0, Side::left), right = curve.motion(1.0, Side::right);
  EXPECT_NEAR(right.angular_velocity.z(), 250.0 / 11.0, tolerance::series);
  EXPECT_GT((left.angular_velocity - right.angular_velocity).norm(), 1.0);
}

}}  // namespace orispline
