// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/edit/cut.hpp>
#include <orispline/edit/loop.hpp>
#include <orispline/edit/seam.hpp>

#include "edit/moving_clips.hpp"

namespace orispline { namespace {

using namespace testing_support;

const LoopRoot hips{.joint = 0};

/// The steps of a channel of rotations from key to key over a seam [rad/s]: the mean rates of the intervals.
std::vector<Eigen::Vector3d> rates_of(const RotationChannel& channel) {
  std::vector<Eigen::Vector3d> rates;
  for (std::size_t i = 0; i + 1 < channel.size(); ++i) {
    Eigen::Quaterniond step = channel.values[i].conjugate() * channel.values[i + 1];
    if (step.w() < 0.0) step.coeffs() *= -1.0;
    rates.push_back(log<double>(step) / (channel.times[i + 1] - channel.times[i]));
  }
  return rates;
}

/// The jump of the rate at the seam, and the largest one inside.
std::pair<double, double> jumps_of(const RotationChannel& channel) {
  const auto rates = rates_of(channel);
  double inside = 0.0;
  for (std::size_t i = 0; i + 1 < rates.size(); ++i) inside = std::max(inside, (rates[i + 1] - rates[i]).norm());
  return {(rates.front() - rates.back()).norm(), inside};
}

TEST(Looped, BendsAnOpenClipSoThatNoStepAtTheSeamExceedsOthers) {
  for (const double drift : {0.1, 0.3, -0.2}) {
    const Clip open = walk(1.0, drift, 0.0);
    const ClipLoop loop = looped(two_joints(), open, hips).value();
    EXPECT_EQ(loop.closing, LoopClosing::bent);
    const RotationChannel& leg = loop.clip.rotations[1];
    EXPECT_EQ(leg.times, open.rotations[1].times);
    EXPECT_LE(angular_distance(leg.values.front(), leg.values.back()), 1e-12);
    const auto [seam, inside] = jumps_of(leg);
    EXPECT_LE(seam, inside);
    EXPECT_EQ(loop.rotation.joint, 1u);
    const double gap = angular_distance(open.rotations[1].values.front(), open.rotations[1].values.back());
    EXPECT_GE(loop.rotation.largest.value, 0.49 * gap);
    EXPECT_LE(loop.rotation.largest.value, 1.5 * gap);
  }
}

TEST(Looped, SaysTheLargestChangeOfAnyJoint) {
  const Clip open = walk(1.0, 0.3, 0.2);
  const ClipLoop loop = looped(two_joints(), open, hips).value();
  double largest = 0.0;
  for (const std::size_t joint : {0u, 1u})
    for (std::size_t i = 0; i < open.rotations[joint].size(); ++i)
      largest =
          std::max(largest, angular_distance(open.rotations[joint].values[i], loop.clip.rotations[joint].values[i]));
  EXPECT_NEAR(loop.rotation.largest.value, largest, 1e-9);
}

TEST(BentCurve, HasOnePoseRateAndAccelerationAtBothEnds) {
  for (unsigned seed = 0; seed < 10; ++seed)
    for (const ChannelInterpolation interpolation : {ChannelInterpolation::linear, ChannelInterpolation::cubicspline}) {
      const RotationChannel channel = random_rotations(seed, interpolation, 0.8);
      const Domain domain{channel.times.front() + 0.05, channel.times.back() - 0.04};
      const LoopStep step{.turn = turned(0.0, 0.4, 0.0)};
      const AnyCurve curve = bent_curve(channel, domain, step).value();
      const Motion start = curve.motion(domain.start), end = curve.motion(domain.end);
      EXPECT_LE(angular_distance(step.turn * start.orientation, end.orientation), 1e-12);
      EXPECT_LE((start.angular_velocity - end.angular_velocity).norm(), 1e-9);
      EXPECT_LE((start.angular_acceleration - end.angular_acceleration).norm(), 1e-6);
    }
}

TEST(BentCurve, OfAPathTurnsItsVelocityWithTheHeading) {
  const VectorChannel channel = random_vectors(3, ChannelInterpolation::cubicspline);
  const Domain domain{channel.times.front(), channel.times.back()};
  const Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  const LoopStep step{.turn = turned(0.0, 0.4, 0.0), .up = up};
  const AnyPath path = bent_curve(channel, domain, step).value();
  const LinearMotion start = path.linear_motion(domain.start), end = path.linear_motion(domain.end);
  EXPECT_NEAR(up.dot(start.position), up.dot(end.position), 1e-12);
  EXPECT_LE((step.turn * start.velocity - end.velocity).norm(), 1e-10);
  EXPECT_LE((step.turn * start.acceleration - end.acceleration).norm(), 1e-8);
}

TEST(BentCurve, IsSmoothInside) {
  const RotationChannel channel = random_rotations(4, ChannelInterpolation::linear, 0.5);
  const AnyCurve curve = bent_curve(channel, {channel.times.front(), channel.times.back()}).value();
  for (const double t : curve.knots().times().subspan(1, curve.knots().segments() - 1)) {
    const Motion left = curve.motion(t, Side::left), right = curve.motion(t, Side::right);
    EXPECT_LE((left.angular_velocity - right.angular_velocity).norm(), 1e-9);
    EXPECT_LE((left.angular_acceleration - right.angular_acceleration).norm(), 1e-7);
  }
}

TEST(Looped, KeepsWhereARootGoesAndWhereItHeads) {
  const ClipLoop loop = looped(two_joints(), walk(1.0, 0.3, 0.2), hips).value();
  EXPECT_NEAR(loop.turn, 0.2, 1e-9);
  EXPECT_NEAR(loop.travel, 1.2, 0.05);
  const VectorChannel& path = loop.clip.translations[0];
  EXPECT_NEAR(path.values.front().y(), path.values.back().y(), 1e-12);
  const RotationChannel& turns = loop.clip.rotations[0];
  EXPECT_LE(angular_distance(turned(0.0, loop.turn, 0.0) * turns.values.front(), turns.values.back()), 1e-12);
}

TEST(Looped, WithoutARootBringsAllBack) {
  const ClipLoop loop = looped(two_joints(), walk(1.0, 0.3, 0.2)).value();
  EXPECT_LE((loop.clip.translations[0].values.front() - loop.clip.translations[0].values.back()).norm(), 1e-12);
  EXPECT_LE(angular_distance(loop.clip.rotations[0].values.front(), loop.clip.rotations[0].values.back()), 1e-12);
  EXPECT_EQ(loop.translation.joint, 0u);
}

TEST(Looped, LeavesWhatGoesRoundAlready) {
  const Clip closed = walk(1.0, 0.0, 0.3);
  const ClipLoop loop = looped(two_joints(), closed, hips).value();
  EXPECT_EQ(loop.closing, LoopClosing::none);
  for (std::size_t i = 0; i < closed.rotations[1].size(); ++i)
    EXPECT_EQ(loop.clip.rotations[1].values[i].coeffs(), closed.rotations[1].values[i].coeffs());
  EXPECT_EQ(loop.rotation.joint, no_parent);
}

TEST(Looped, GivesAClosingKeyToAClipThatLacksIt) {
  const Clip whole = walk(1.0, 0.0, 0.3);
  Clip open = whole;
  for (RotationChannel& channel : open.rotations) channel.times.pop_back(), channel.values.pop_back();
  open.translations[0].times.pop_back(), open.translations[0].values.pop_back();
  const ClipLoop loop = looped(two_joints(), open, hips).value();
  EXPECT_EQ(loop.closing, LoopClosing::frame);
  ASSERT_EQ(loop.clip.rotations[1].size(), whole.rotations[1].size());
  for (std::size_t joint : {0u, 1u})
    for (std::size_t i = 0; i < open.rotations[joint].size(); ++i)
      EXPECT_EQ(loop.clip.rotations[joint].values[i].coeffs(), open.rotations[joint].values[i].coeffs());
  EXPECT_LE(angular_distance(loop.clip.rotations[1].values.back(), whole.rotations[1].values.back()), 1e-12);
  EXPECT_LE(angular_distance(loop.clip.rotations[0].values.back(), whole.rotations[0].values.back()), 2e-3);
  EXPECT_LE((loop.clip.translations[0].values.back() - whole.translations[0].values.back()).norm(), 5e-3);
}

TEST(Looped, ClosesCubicsWithOneRateAtBothEnds) {
  Clip clip{.name = "cubic",
            .rotations = {random_rotations(6, ChannelInterpolation::cubicspline, 0.5)},
            .translations = {random_vectors(6, ChannelInterpolation::cubicspline)}};
  clip = {.name = "cubic", .rotations = clip.rotations};
  const ClipLoop loop = looped(two_joints(), clip).value();
  const ClipSeam seam = seam_of(loop.clip);
  EXPECT_LE(seam.pose.value, 1e-12);
  EXPECT_LE(seam.rate.value, 1e-6);
}

/// The farthest that a loop is from its clip at a thousand times, of a joint below a root that is not moved.
double farthest(const Clip& before, const ClipLoop& loop, std::size_t joint) {
  const ChannelCurve<Eigen::Quaterniond> was(*channel_of(before.rotations, joint)),
      is(*channel_of(loop.clip.rotations, joint));
  const Domain domain = before.domain();
  double most = 0.0;
  for (int k = 0; k <= 1000; ++k) {
    const double t = domain.start + (domain.end - domain.start) * k / 1000.0;
    most = std::max(most, angular_distance(was.at(t), is.at(t)));
  }
  return most;
}

TEST(Looped, SaysTheLargestChangeBetweenKeysToo) {
  for (unsigned seed = 0; seed < 20; ++seed)
    for (const ChannelInterpolation interpolation : {ChannelInterpolation::linear, ChannelInterpolation::cubicspline}) {
      const double widest = interpolation == ChannelInterpolation::linear ? 1.7 : 0.4;
      const Clip clip{.name = "any", .rotations = {random_rotations(seed, interpolation, widest)}};
      const ClipLoop loop = looped(two_joints(), clip).value();
      const double sampled = farthest(clip, loop, 1);
      EXPECT_GE(loop.rotation.largest.value, sampled - 1e-6) << seed;
      EXPECT_LE(loop.rotation.largest.value, sampled + 0.01) << seed;
    }
}

TEST(Looped, GoesTheWayOfTheClipWhereAStepExceedsAHalfTurn) {
  RotationChannel pan{.joint = 1, .times = {0.0, 2.0, 4.0, 6.0}};
  for (const double degrees : {0.0, 175.0, 350.0, 300.0}) pan.values.push_back(turned(0.0, 0.0, degrees / 57.29577951));
  // The second one has so many keys that it gets others for its turns alone.
  RotationChannel spin{.joint = 1};
  for (int i = 0; i <= 20; ++i) {
    spin.times.push_back(0.1 * i);
    spin.values.push_back(turned(0.0, 0.0, 3.1 * i));
  }
  for (const RotationChannel& channel : {pan, spin}) {
    const Clip clip{.name = "turns", .rotations = {channel}};
    const ClipLoop loop = looped(two_joints(), clip).value();
    EXPECT_LE(farthest(clip, loop, 1), 2.0) << "a step went the other way round";
    EXPECT_LE(seam_of(loop.clip).pose.value, 1e-9);
  }
}

TEST(Looped, KeepsTheMotionOfAChannelOfTwoKeys) {
  Clip clip = walk(1.0, 0.2, 0.0);
  clip.rotations[1] = {.joint = 1, .times = {0.0, 1.0}, .values = {turned(0.0, 0.0, 0.0), turned(1.0, 0.0, 0.0)}};
  const ClipLoop loop = looped(two_joints(), clip, hips).value();
  const RotationChannel& leg = loop.clip.rotations[1];
  double most = 0.0;
  for (const Eigen::Quaterniond& q : leg.values) most = std::max(most, angular_distance(q, leg.values.front()));
  EXPECT_GE(most, 0.1);
  EXPECT_LE(angular_distance(leg.values.front(), leg.values.back()), 1e-12);
}

TEST(Looped, LetsStepsEndOnTheirFirstValue) {
  for (const double drift : {0.0, 0.3}) {  // of what goes round already, and of what is bent
    Clip clip = walk(1.0, drift, 0.0);
    const RotationChannel steps{.joint = 1,
                                .interpolation = ChannelInterpolation::step,
                                .times = {0.0, 0.5, 0.8},
                                .values = {turned(0.0, 0.0, 0.0), turned(0.3, 0.0, 0.0), turned(0.6, 0.0, 0.0)}};
    clip.rotations[1] = steps;
    const ClipLoop loop = looped(two_joints(), clip, hips).value();
    EXPECT_EQ(loop.closing, drift == 0.0 ? LoopClosing::frame : LoopClosing::bent);
    EXPECT_EQ(loop.rotation.joint, no_parent);
    const RotationChannel& made = loop.clip.rotations[1];
    EXPECT_EQ(made.times.back(), 1.0);
    EXPECT_LE(angular_distance(made.values.back(), made.values.front()), 0.0);
    const ChannelCurve<Eigen::Quaterniond> was(steps), is(made);
    for (const double t : {0.1, 0.6, 0.9, 0.99}) EXPECT_LE(angular_distance(was.at(t), is.at(t)), 0.0);
  }
}

TEST(Looped, GivesItsClosingKeyToOneTrackThatLacksIt) {
  for (const double drift : {0.0, 0.3}) {
    Clip clip = walk(1.0, 0.0, 0.3);
    const RotationChannel whole = clip.rotations[1];
    clip.rotations[1].times.pop_back(), clip.rotations[1].values.pop_back();
    for (Eigen::Vector3d& v : clip.translations[0].values) v.y() += drift * v.x();
    const ClipLoop loop = looped(two_joints(), clip, hips).value();
    EXPECT_EQ(loop.closing, drift == 0.0 ? LoopClosing::frame : LoopClosing::bent);
    EXPECT_EQ(loop.rotation.joint, no_parent);
    const RotationChannel& leg = loop.clip.rotations[1];
    EXPECT_EQ(leg.times, whole.times);
    for (std::size_t i = 0; i < leg.size(); ++i)
      EXPECT_LE(angular_distance(leg.values[i], whole.values[i]), 1e-12) << i;
  }
}

TEST(Looped, KeepsTheWayThatANodeAboveTheRootGoes) {
  const Clip open = walk_of_node(0.2);
  const ClipLoop loop = looped(below_node(), open, {.joint = 1}).value();
  EXPECT_NEAR(loop.turn, 0.2, 1e-9);
  EXPECT_NEAR(loop.travel, 1.2, 0.05);
  EXPECT_LE(seam_of(loop.clip, loop.turns).pose.value, 1e-9);
  EXPECT_GT(seam_of(loop.clip).pose.value, 0.1);
}

TEST(Looped, StatesLengthsOfTheWorld) {
  const JointPose small{.rotation = turned(-1.5707963267948966, 0.0, 0.0), .scale = {0.01, 0.01, 0.01}};
  Clip clip = walk(1.0, 0.3, 0.2);
  const Eigen::Quaterniond back = turned(1.5707963267948966, 0.0, 0.0);
  for (Eigen::Quaterniond& q : clip.rotations[0].values) q = back * q;
  for (Eigen::Vector3d& v : clip.translations[0].values) v = 100.0 * (back * v);
  for (RotationChannel& channel : clip.rotations) ++channel.joint;
  clip.translations[0].joint = 1;
  const ClipLoop loop = looped(below_node(small), clip, {.joint = 1}).value(),
                 large = looped(two_joints(), walk(1.0, 0.3, 0.2), hips).value();
  EXPECT_NEAR(loop.travel, large.travel, 1e-9);
  EXPECT_NEAR(loop.turn, large.turn, 1e-9);
  EXPECT_NEAR(loop.translation.largest.value, large.translation.largest.value, 1e-9);
}

TEST(Looped, TellsChangesOfScalesFromThoseOfPlaces) {
  Clip clip = walk(1.0, 0.0, 0.0);
  const std::vector<Eigen::Vector3d> sizes{{1.0, 1.0, 1.0}, {2.0, 1.0, 1.0}, {1.5, 1.0, 1.0}};
  clip.scales.push_back({.joint = 1, .times = {0.0, 0.5, 1.0}, .values = sizes});
  const ClipLoop loop = looped(two_joints(), clip, hips).value();
  EXPECT_EQ(loop.translation.joint, no_parent);
  EXPECT_EQ(loop.scale.joint, 1u);
  EXPECT_GE(loop.scale.largest.value, 0.25);
}

TEST(Looped, CountsTheRoundsOfARoot) {
  const ClipLoop loop = looped(two_joints(), walk(1.0, 0.3, 11.0), hips).value();
  EXPECT_NEAR(loop.turn, 11.0, 1e-8);
}

TEST(Looped, RefusesFewerThanThreeKeys) {
  const RotationChannel two{
      .joint = 1, .times = {0.0, 1.0}, .values = {Eigen::Quaterniond::Identity(), turned(0.1, 0.0, 0.0)}};
  const auto loop = looped(two_joints(), {.name = "nod", .rotations = {two}});
  ASSERT_FALSE(loop);
  EXPECT_EQ(loop.error().message, "clip 'nod': found keys at 2 times, wanted 3 at least for a loop");
}

TEST(BestPeriod, IsThatOfAMotionThatRepeats) {
  const Clip clip = walk(3.4, 0.0, 0.25);
  const Domain best = best_period(two_joints(), clip, {0.7, 1.3}, hips).value();
  EXPECT_NEAR(best.end - best.start, 1.0, 1e-9);
}

TEST(BestPeriod, FindsTheRoundThatIsMostAlikeAtItsEnds) {
  Clip clip = walk(4.0, 0.0, 0.0);
  // All rounds but that from 2 s to 3 s drift away.
  RotationChannel& leg = clip.rotations[1];
  for (std::size_t i = 0; i < leg.size(); ++i) {
    const double t = leg.times[i], away = t < 2.0 ? 2.0 - t : t > 3.0 ? t - 3.0 : 0.0;
    leg.values[i] = leg.values[i] * turned(0.0, 0.0, 0.3 * away);
  }
  const Domain best = best_period(two_joints(), clip, {0.7, 1.3}).value();
  EXPECT_NEAR(best.start, 2.0, 0.04);
  EXPECT_NEAR(best.end, 3.0, 0.04);
}

}}  // namespace orispline
