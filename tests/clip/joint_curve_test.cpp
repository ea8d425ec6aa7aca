// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <orispline/clip/clip_motion.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

Eigen::Quaterniond turn(double x, double y, double z) { return exp<double>(Eigen::Vector3d(x, y, z)); }
Eigen::Quaterniond rate(double w, double x, double y, double z) { return {w, x, y, z}; }

/// Four joints in a chain; the first is larger by 2, the second turned at rest.
Skeleton chain() {
  JointPose root, shoulder, elbow, hand;
  root.scale = Eigen::Vector3d::Constant(2.0);
  shoulder.translation = {0.0, 1.5, 0.0};
  shoulder.rotation = turn(0.2, -0.4, 0.3);
  elbow.translation = {0.4, 0.1, 0.0};
  hand.translation = {0.3, 0.0, -0.1};
  return Skeleton::make({{.name = "root", .rest = root},
                         {.name = "shoulder", .parent = 0, .rest = shoulder},
                         {.name = "elbow", .parent = 1, .rest = elbow},
                         {.name = "hand", .parent = 2, .rest = hand}})
      .value();
}

constexpr std::size_t root_joint = 0, shoulder_joint = 1, elbow_joint = 2, hand_joint = 3;

/// Every interpolation, over times that begin and end differently.
Clip clip() {
  return {.name = "reach",
          .rotations = {{.joint = root_joint,
                         .interpolation = ChannelInterpolation::linear,
                         .times = {0.0, 0.7, 2.0},
                         .values = {turn(0, 0, 0), turn(0.9, 0.2, 0), turn(0.1, -0.8, 0.4)}},
                        {.joint = shoulder_joint,
                         .interpolation = ChannelInterpolation::step,
                         .times = {0.25, 1.0, 1.6},
                         .values = {turn(0.3, 0, 0), turn(0, 0.5, 0), turn(0, 0, 0.7)}},
                        {.joint = elbow_joint,
                         .interpolation = ChannelInterpolation::cubicspline,
                         .times = {0.1, 0.9, 1.8},
                         .values = {turn(0, 0, 0), turn(0, 0, 1.1), turn(0.6, 0, 0.3)},
                         .in_tangents = {rate(0, 0, 0, 0), rate(-0.1, 0.2, 0, 0.5), rate(0, 0.3, 0, 0)},
                         .out_tangents = {rate(0, 0.1, 0.4, 0), rate(0.2, 0, -0.3, 0.1), rate(0, 0, 0, 0)}}},
          .translations = {{.joint = elbow_joint,
                            .interpolation = ChannelInterpolation::linear,
                            .times = {0.5, 1.5},
                            .values = {{0.4, 0.1, 0.0}, {0.6, -0.2, 0.1}}},
                           {.joint = root_joint,
                            .interpolation = ChannelInterpolation::cubicspline,
                            .times = {0.0, 2.2},
                            .values = {{0, 0, 0}, {3, 0, 1}},
                            .in_tangents = {{0, 0, 0}, {1, 0, 2}},
                            .out_tangents = {{1, 0.5, 0}, {0, 0, 0}}}}};
}

/// Inside of segments, where the rates do not jump.
constexpr std::array inner_times{0.05, 0.18, 0.3, 0.45, 0.6, 0.8, 0.95, 1.2, 1.55, 1.7, 1.9, 2.1};

Eigen::Quaterniond orientation_of(const Eigen::Affine3d& pose) {
  return Eigen::Quaterniond(Eigen::Matrix3d(pose.linear().colwise().normalized()));
}

struct Differences {
  Eigen::Vector3d angular_velocity, angular_acceleration, velocity, acceleration;
};

/// Central differences of the poses in the world.
Differences differences_at(const ClipMotion& motion, std::size_t joint, double t) {
  constexpr double h = 1e-4;
  std::array<Eigen::Quaterniond, 3> q;
  std::array<Eigen::Vector3d, 3> p;
  std::vector<Eigen::Affine3d> poses(motion.skeleton().size());
  for (std::size_t k = 0; k < 3; ++k) {
    motion.world_poses(t + h * (static_cast<double>(k) - 1.0), poses);
    q[k] = orientation_of(poses[joint]);
    p[k] = poses[joint].translation();
  }
  const Eigen::Vector3d before = log<double>(q[0].conjugate() * q[1]) / h,
                        after = log<double>(q[1].conjugate() * q[2]) / h;
  return {0.5 * (before + after), (after - before) / h, (p[2] - p[0]) / (2 * h), (p[2] - 2 * p[1] + p[0]) / (h * h)};
}

TEST(JointCurve, InTheFrameOfTheParentIsTheChannel) {
  const Skeleton skeleton = chain();
  const Clip reach = clip();
  const ClipMotion motion(skeleton, reach);
  for (const std::size_t joint : {root_joint, shoulder_joint, elbow_joint, hand_joint}) {
    const PoseCurve curve = joint_curve(skeleton, reach, joint, JointSpace::local).value();
    for (double t = -0.5; t < 2.6; t += 0.013) {
      const JointPose pose =
          motion.local_pose(joint, std::clamp(t, curve.orientation.domain().start, curve.orientation.domain().end));
      EXPECT_LT(angular_distance(curve.orientation(t), pose.rotation), 1e-14) << joint << " at " << t;
      EXPECT_LT((curve.position->linear_motion(t).position - pose.translation).norm(), 1e-14) << joint << " at " << t;
    }
  }
}

TEST(JointCurve, HasTheKeysOfItsChannelsAsKnots) {
  const Skeleton skeleton = chain();
  const auto knots = [&](std::size_t joint, JointSpace space) {
    const PoseCurve curve = joint_curve(skeleton, clip(), joint, space).value();
    const auto times = curve.orientation.knots().times();
    return std::vector<double>(times.begin(), times.end());
  };
  EXPECT_EQ(knots(shoulder_joint, JointSpace::local), (std::vector{0.25, 1.0, 1.6}));
  EXPECT_EQ(knots(elbow_joint, JointSpace::local), (std::vector{0.1, 0.5, 0.9, 1.5, 1.8}));
  EXPECT_EQ(knots(hand_joint, JointSpace::world),
            (std::vector{0.0, 0.1, 0.25, 0.5, 0.7, 0.9, 1.0, 1.5, 1.6, 1.8, 2.0, 2.2}));
  EXPECT_EQ(knots(hand_joint, JointSpace::local), (std::vector{0.0}));
}

TEST(JointCurve, InTheWorldIsThePoseOfTheChain) {
  const Skeleton skeleton = chain();
  const Clip reach = clip();
  const ClipMotion motion(skeleton, reach);
  std::vector<Eigen::Affine3d> poses(skeleton.size());
  for (const std::size_t joint : {root_joint, shoulder_joint, elbow_joint, hand_joint}) {
    const PoseCurve curve = joint_curve(skeleton, reach, joint, JointSpace::world).value();
    const Domain domain = curve.orientation.domain();
    for (double t = domain.start; t <= domain.end; t += 0.01) {
      motion.world_poses(t, poses);
      EXPECT_LT(angular_distance(curve.orientation(t), orientation_of(poses[joint])), 1e-14) << joint << " at " << t;
      EXPECT_LT((curve.position->linear_motion(t).position - poses[joint].translation()).norm(), 1e-14) << t;
    }
  }
}

TEST(JointCurve, HasTheRatesOfThePosesOfTheChain) {
  const Skeleton skeleton = chain();
  const Clip reach = clip();
  const ClipMotion motion(skeleton, reach);
  const PoseCurve curve = joint_curve(skeleton, reach, hand_joint, JointSpace::world).value();
  for (const double t : inner_times) {
    const Differences wanted = differences_at(motion, hand_joint, t);
    const Motion found = curve.orientation.motion(t);
    const LinearMotion path = curve.position->linear_motion(t);
    EXPECT_LT((found.angular_velocity - wanted.angular_velocity).norm(), 1e-6) << t;
    EXPECT_LT((found.angular_acceleration - wanted.angular_acceleration).norm(), 1e-5) << t;
    EXPECT_LT((path.velocity - wanted.velocity).norm(), 1e-6) << t;
    EXPECT_LT((path.acceleration - wanted.acceleration).norm(), 1e-5) << t;
    EXPECT_GT(found.angular_velocity.norm() + path.velocity.norm(), 0.1) << t;
  }
}

TEST(JointCurve, OfStepsJumpsAtTheirKeys) {
  const PoseCurve curve = joint_curve(chain(), clip(), shoulder_joint, JointSpace::local).value();
  EXPECT_LT(angular_distance(curve.orientation.motion(1.0, Side::left).orientation, turn(0.3, 0, 0)), 1e-15);
  EXPECT_LT(angular_distance(curve.orientation.motion(1.0).orientation, turn(0, 0.5, 0)), 1e-15);
  EXPECT_LT(angular_distance(curve.orientation(1.6), turn(0, 0, 0.7)), 1e-15);
  EXPECT_EQ(curve.orientation.motion(1.3).angular_velocity.norm(), 0.0);
}

std::string fault_in_world(const VectorChannel& scale) {
  Clip scaled = clip();
  scaled.scales.push_back(scale);
  const auto curve = joint_curve(chain(), scaled, hand_joint, JointSpace::world);
  return curve ? "" : describe(curve.error());
}

TEST(JointCurve, IsAnErrorBelowScalesThatLeaveNoOrientation) {
  const std::string uneven =
      "clip 'reach', joint 'elbow': found a scale that is zero, negative or not the same along all axes, wanted "
      "another "
      "one for the world";
  EXPECT_EQ(fault_in_world({.joint = elbow_joint, .times = {0.0, 1.0}, .values = {{1, 1, 1}, {1, 2, 1}}}), uneven);
  EXPECT_EQ(fault_in_world({.joint = elbow_joint, .times = {0.0}, .values = {{1, 1, -1}}}), uneven);
  EXPECT_EQ(fault_in_world({.joint = elbow_joint, .times = {0.0}, .values = {{1, 1.0001, 1}}}), uneven);
  EXPECT_EQ(fault_in_world({.joint = elbow_joint, .times = {0.0}, .values = {{1, 1.000009, 1}}}), "");
  EXPECT_EQ(fault_in_world({.joint = elbow_joint,
                            .interpolation = ChannelInterpolation::cubicspline,
                            .times = {0.0, 1.0},
                            .values = {{1, 1, 1}, {1, 1, 1}},
                            .in_tangents = {{0, 0, 0}, {0, 0, 0}},
                            .out_tangents = {{1, 0, 0}, {0, 0, 0}}}),
            uneven);
}

TEST(JointCurve, BearsEvenScalesAboveAndAnyOfItsOwn) {
  EXPECT_EQ(fault_in_world({.joint = hand_joint, .times = {0.0}, .values = {{1, -2, 3}}}), "");
  const Skeleton skeleton = chain();
  Clip grown = clip();
  grown.scales.push_back({.joint = shoulder_joint, .times = {0.0, 2.0}, .values = {{1, 1, 1}, {3, 3, 3}}});
  const ClipMotion motion(skeleton, grown);
  const PoseCurve curve = joint_curve(skeleton, grown, hand_joint, JointSpace::world).value();
  for (const double t : inner_times) {
    const Differences wanted = differences_at(motion, hand_joint, t);
    EXPECT_LT((curve.position->linear_motion(t).velocity - wanted.velocity).norm(), 1e-6) << t;
    EXPECT_LT((curve.position->linear_motion(t).acceleration - wanted.acceleration).norm(), 2e-5) << t;
  }
}

TEST(JointCurve, IsStatedInOtherFramesWithAllItsRates) {
  const Skeleton skeleton = chain();
  FrameChange change;
  change.world.axes = axis_change_of("RUF:FLU", AxesOf::world).value();
  change.body.axes = axis_change_of("RUF:FLU", AxesOf::body).value();
  change.world.rotation = turn(0.3, -0.4, 0.5);
  const NewFrames frames(change);
  for (const JointSpace space : {JointSpace::local, JointSpace::world}) {
    const PoseCurve old = joint_curve(skeleton, clip(), elbow_joint, space).value();
    const PoseCurve turned = joint_curve(skeleton, clip(), elbow_joint, space, change).value();
    for (const double t : inner_times) {
      const Motion before = old.orientation.motion(t), after = turned.orientation.motion(t);
      EXPECT_LT((after.orientation.coeffs() - frames.orientation(before.orientation).coeffs()).norm(), 1e-14) << t;
      EXPECT_LT((after.angular_velocity - frames.body_rate(before.angular_velocity)).norm(), 1e-12) << t;
      EXPECT_LT((after.angular_jerk - frames.body_rate(before.angular_jerk)).norm(), 1e-9) << t;
      const LinearMotion there = old.position->linear_motion(t), here = turned.position->linear_motion(t);
      EXPECT_LT((here.position - frames.in_world<double>(there.position)).norm(), 1e-14) << t;
      EXPECT_LT((here.acceleration - frames.in_world<double>(there.acceleration)).norm(), 1e-11) << t;
    }
  }
  change.body = {};
  EXPECT_EQ(joint_curve(skeleton, clip(), elbow_joint, JointSpace::world, change).error().option, "world_axes");
}

}}  // namespace orispline
