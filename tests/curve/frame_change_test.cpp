// SPDX-License-Identifier: Apache-2.0
// Other axes and frames for keys: docs/frames.md.
#include <orispline/axes.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/curve/motion.hpp>
#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/tracks.hpp>

namespace orispline { namespace {

using testing_support::near;

AxisChange axes(std::string_view text, AxesOf whose) {
  const auto change = axis_change_of(text, whose);
  EXPECT_TRUE(change) << describe(change.error());
  return change.value_or(AxisChange());
}

FrameChange changed(std::string_view world, std::string_view body) {
  FrameChange change;
  if (!world.empty()) change.world.axes = axes(world, AxesOf::world);
  if (!body.empty()) change.body.axes = axes(body, AxesOf::body);
  return change;
}

/// The same orientation, whatever the sign.
void expect_same(const Eigen::Quaterniond& found, const Eigen::Quaterniond& wanted, double tolerance) {
  const double sign = found.dot(wanted) < 0.0 ? -1.0 : 1.0;
  EXPECT_LE((sign * found.coeffs() - wanted.coeffs()).cwiseAbs().maxCoeff(), tolerance)
      << found.coeffs().transpose() << " (x y z w)";
}

struct AxesCase {
  std::string_view world, body;
  Eigen::Quaterniond q;
  Eigen::Vector3d p, w;
};

// The values were computed from the matrices W R Bᵀ.
const std::array table{AxesCase{"NED:ENU",
                                "FRD:FLU",
                                {0.565685424949238, 0.593969696196700, -0.084852813742386, 0.565685424949238},
                                {2, 1, -3},
                                {0.1, -0.2, -0.3}},
                       AxesCase{"", "RDF:RUB", {0.36, -0.8, 0, 0.48}, {1, 2, 3}, {0.1, -0.2, -0.3}},
                       AxesCase{"RUB:RFU",
                                "",
                                {0.311126983722081, 0.820243866176395, 0.339411254969543, 0.339411254969543},
                                {1, -3, 2},
                                {0.1, 0.2, 0.3}},
                       AxesCase{"RUF:FLU", "RUF:FLU", {0.8, 0, 0.36, -0.48}, {3, -1, 2}, {-0.3, 0.1, -0.2}}};

TEST(FrameChange, GivesWhatPeopleOfThatFrameWrite) {
  const Eigen::Quaterniond q(0.8, 0.36, 0.48, 0.0);
  for (const AxesCase& wanted : table) {
    SCOPED_TRACE(std::string(wanted.world) + " " + std::string(wanted.body));
    const NewFrames frames(changed(wanted.world, wanted.body));
    expect_same(frames.orientation(q), wanted.q, 1e-15);
    EXPECT_EQ(frames.in_world<double>({1, 2, 3}), wanted.p);  // no digit changes
    EXPECT_EQ(frames.body_rate({0.1, 0.2, 0.3}), wanted.w);
  }
}

/// All systems of three letters of bodies.
std::vector<std::string> all_systems() {
  const std::array<std::string_view, 3> lines{"RL", "FB", "UD"};
  std::vector<std::string> systems;
  std::array<std::size_t, 3> order{0, 1, 2};
  do
    for (unsigned ways = 0; ways < 8; ++ways) {
      std::string letters;
      for (std::size_t k = 0; k < 3; ++k) letters += lines[order[k]][ways >> k & 1U];
      systems.push_back(letters);
    }
  while (std::ranges::next_permutation(order).found);
  return systems;
}

TEST(FrameChange, IsTheProductOfItsMatricesForAllAxes) {
  const Eigen::Quaterniond q(0.1, 0.7, -0.5, 0.5);
  const auto systems = all_systems();
  ASSERT_EQ(systems.size(), 48u);
  for (const std::string& world : systems)
    for (const std::string& body : systems) {
      const FrameChange change = changed("RFU:" + world, "FLU:" + body);
      if (change.world.axes.determinant() != change.body.axes.determinant()) {
        EXPECT_FALSE(check(change));
        continue;
      }
      const Eigen::Matrix3d wanted =
          change.world.axes.matrix() * q.normalized().toRotationMatrix() * change.body.axes.matrix().transpose();
      const Eigen::Quaterniond found = NewFrames(change).orientation(q.normalized());
      EXPECT_NEAR(found.norm(), 1.0, 1e-15);
      EXPECT_TRUE(near(found.toRotationMatrix(), wanted, 1e-15));
    }
}

TEST(FrameChange, ComesBackToTheSameDigitsOfVectors) {
  const Eigen::Vector3d v(0.1, -1e-300, 12345.678901234567);
  for (const std::string& system : all_systems()) {
    const AxisChange there = axes("FLU:" + system, AxesOf::body), back = axes(system + ":FLU", AxesOf::body);
    EXPECT_EQ(back(there(v)), v) << system;
    EXPECT_FALSE(std::signbit(there(Eigen::Vector3d(0, 0, 0)).minCoeff()));
  }
}

TEST(FrameChange, TurnsAfterTheAxes) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(0.3, -0.2, 0.9, 0.1).normalized();
  const Eigen::Quaterniond w = Eigen::Quaterniond(0.5, 0.1, 0.2, -0.7).normalized();
  const Eigen::Quaterniond b = Eigen::Quaterniond(0.2, 0.9, -0.3, 0.1).normalized();
  FrameChange change = changed("NED:ENU", "FRD:FLU");
  const NewFrames axes_only(change);
  change.world.rotation = w;
  change.body.rotation = b;
  const NewFrames frames(change);
  const Eigen::Vector3d v(1, 2, 3);
  expect_same(frames.orientation(q), w * axes_only.orientation(q) * b.conjugate(), 1e-15);
  EXPECT_TRUE(near(frames.in_world<double>(v), w * axes_only.in_world<double>(v), 1e-15));
  EXPECT_TRUE(near(frames.body_rate(v), b * axes_only.body_rate(v), 1e-15));
}

TEST(FrameChange, TurnsRatesAsTheDerivativesOfWhatTurned) {
  const auto path = [](const NewFrames& frames, double t) {
    using J = Jet<double, 3>;
    const J s = J::variable(t);
    const auto part = [&](const Eigen::Vector3d& v) { return exp<J>(Vector3<J>(v.cast<J>() * s)); };
    return motion_from_jet(
        frames.orientation<J>(part(Eigen::Vector3d(0.3, -0.2, 0.5)) * part(Eigen::Vector3d(-0.4, 0.8, 0.1))));
  };
  FrameChange change = changed("RUF:FLU", "RUF:FLU");
  change.body.rotation = Eigen::Quaterniond(0.2, 0.9, -0.3, 0.1).normalized();
  const NewFrames frames(change);
  const Motion old = path(NewFrames(), 0.7), turned = path(frames, 0.7);
  EXPECT_TRUE(near(turned.angular_velocity, frames.body_rate(old.angular_velocity), 1e-14));
  EXPECT_TRUE(near(turned.angular_acceleration, frames.body_rate(old.angular_acceleration), 1e-14));
  EXPECT_TRUE(near(turned.angular_jerk, frames.body_rate(old.angular_jerk), 1e-14));
}

TEST(FrameChange, NoneChangesNoBit) {
  const NewFrames none;
  const Eigen::Quaterniond q(0.1, 0.2, 0.3, 0.4);
  EXPECT_TRUE(none.change_nothing());
  EXPECT_EQ(none.orientation(q).coeffs(), q.coeffs());
  EXPECT_TRUE(NewFrames(changed("NED:NED", "FRD:FRD")).change_nothing());
}

std::string refused(std::string_view text, AxesOf whose) {
  const auto change = axis_change_of(text, whose);
  EXPECT_FALSE(change) << text;
  if (change) return "";
  EXPECT_EQ(change.error().code, ErrorCode::bad_argument);
  EXPECT_EQ(change.error().option, whose == AxesOf::world ? "world_axes" : "body_axes");
  return change.error().message;
}

TEST(AxisChange, SaysWhatIsWrongWithLetters) {
  EXPECT_EQ(refused("NED", AxesOf::world),
            "found 'NED', wanted two systems of axes with a colon between them, such as NED:ENU");
  EXPECT_EQ(refused("", AxesOf::body),
            "found '', wanted two systems of axes with a colon between them, such as FRD:FLU");
  EXPECT_EQ(refused("NED:ENU:FLU", AxesOf::world),
            "found 'NED:ENU:FLU', wanted two systems of axes with a colon between them, such as NED:ENU");
  EXPECT_EQ(refused("NEX:ENU", AxesOf::world),
            "found 'NEX', wanted N or S, E or W, U or D with a compass, such as NED, or R or L, F or B, U or D "
            "without one, such as RFU");
  EXPECT_EQ(refused("NRD:ENU", AxesOf::world),
            "found 'NRD', wanted N or S, E or W, U or D with a compass, such as NED, or R or L, F or B, U or D "
            "without one, such as RFU");
  EXPECT_EQ(refused("NED:EN", AxesOf::world),
            "found 'EN', wanted three letters that say where +x, +y and +z point: N or S, E or W, U or D with a "
            "compass, such as NED, or R or L, F or B, U or D without one, such as RFU");
  EXPECT_EQ(refused("NED:FLU", AxesOf::body),
            "found 'NED', wanted R or L, F or B, U or D for the axes of a body, such as FRD");
  EXPECT_EQ(refused("FFD:FLU", AxesOf::body),
            "found 'FFD', wanted no two letters along one line, as 'F' and 'F' are: R or L, F or B, U or D");
  EXPECT_EQ(refused("NED:ENS", AxesOf::world),
            "found 'ENS', wanted no two letters along one line, as 'N' and 'S' are: N or S, E or W, U or D");
  EXPECT_EQ(refused("NED:FLU", AxesOf::world),
            "found 'NED:FLU', wanted both with a compass, such as NED:ENU, or both without one, such as RUB:RFU; "
            "`world_rotation` says how a room lies beside the compass");
  EXPECT_EQ(refused("frd:flu", AxesOf::body),
            "found 'frd', wanted R or L, F or B, U or D for the axes of a body, such as FRD");
}

TEST(FrameChange, IsRefusedWhereOneSideAloneChangesHands) {
  const auto world = check(changed("NED:NEU", "FRD:FLU")), body = check(changed("", "RUF:FLU"));
  ASSERT_FALSE(world || body);
  EXPECT_EQ(world.error().message,
            "found axes of the world of which one system is right-handed and the other left-handed, and axes of the "
            "body that keep their hand, wanted a change on both sides or on none");
  EXPECT_EQ(world.error().option, "world_axes");
  EXPECT_EQ(world.error().remedy, "body_axes");
  EXPECT_EQ(body.error().option, "body_axes");
  EXPECT_TRUE(check(changed("RUF:FLU", "RUF:FLU")));
}

TEST(FrameChange, WantsRotationsOfNormOne) {
  FrameChange change;
  change.body.rotation = Eigen::Quaterniond(1, 1, 0, 0);
  EXPECT_EQ(check(change).error().message, "found a quaternion of norm 1.41421, wanted 1");
  EXPECT_EQ(check(change).error().option, "body_rotation");
  change.body.rotation = Eigen::Quaterniond(std::numeric_limits<double>::quiet_NaN(), 0, 0, 0);
  EXPECT_FALSE(check(change));
  change.body.rotation = Eigen::Quaterniond(0, 0, 0, 1);
  EXPECT_TRUE(check(change));
}

TEST(FrameChange, TakesAllThatATrackCarriesAlong) {
  KeyframeData data{.times = {0.0, 1.0},
                    .orientations = {{0.8, 0.36, 0.48, 0.0}, {0.8, 0.0, 0.36, 0.48}},
                    .positions = {{1, 2, 3}, {4, 5, 6}},
                    .angular_velocities = {{0.1, 0.2, 0.3}, free_rate()},
                    .angular_accelerations = {{1, 2, 3}, {4, 5, 6}},
                    .angular_jerks = {{7, 8, 9}, {1, 2, 3}}};
  Track track(Keyframes::make(data).value());
  track.as_read = data.orientations;
  track.table.names = {"t"};
  track.table.rows = {{"0"}, {"1"}};
  track.recipe = {.method = "rotation-spline:ends=clamped:start_rate=0.1,0.2,0.3:end_rate=-1,0,0", .line = 1};
  const auto turned = in_frames(track, changed("RUF:FLU", "RUF:FLU"));
  ASSERT_TRUE(turned) << describe(turned.error());
  const Keyframes& keys = turned->keys;
  expect_same(keys.orientations()[0], {0.8, 0, 0.36, -0.48}, 0.0);
  EXPECT_EQ(keys.positions()[0], Eigen::Vector3d(3, -1, 2));
  EXPECT_EQ(keys.angular_velocities()[0], Eigen::Vector3d(-0.3, 0.1, -0.2));
  EXPECT_TRUE(is_free(keys.angular_velocities()[1]));
  EXPECT_EQ(keys.angular_accelerations()[0], Eigen::Vector3d(-3, 1, -2));
  EXPECT_EQ(keys.angular_jerks()[0], Eigen::Vector3d(-9, 7, -8));
  EXPECT_EQ(turned->as_read[0].coeffs(), keys.orientations()[0].coeffs());
  EXPECT_TRUE(turned->table.rows.empty());
  EXPECT_EQ(turned->recipe.method, "rotation-spline:ends=clamped:start_rate=-0.3,0.1,-0.2:end_rate=0,-1,0");
  EXPECT_FALSE(in_frames(track, changed("RUF:FLU", "")));
}

TEST(FrameChange, TurnsInnerQuaternionsAsItTurnsTheCurve) {
  const Eigen::Quaterniond given = Eigen::Quaterniond(0.9, 0.1, 0.3, 0.2).normalized();
  const Keyframes keys = Keyframes::make({.times = {0.0, 1.0, 2.5},
                                          .orientations = {{1, 0, 0, 0}, {0.8, 0.36, 0.48, 0.0}, {0.5, 0.5, -0.5, 0.5}},
                                          .inner_leaving = {given, free_inner(), free_inner()},
                                          .inner_arriving = {free_inner(), given, free_inner()}})
                             .value();
  const FrameChange change = changed("NED:ENU", "FRD:FLU");
  const NewFrames frames(change);
  const Keyframes turned = in_frames(Track(keys), change).value().keys;
  EXPECT_TRUE(is_free_inner(turned.inner_leaving()[1]));
  expect_same(turned.inner_arriving()[1], frames.orientation(given), 1e-15);
  const auto before = make_curve("squad", keys), after = make_curve("squad", turned);
  ASSERT_TRUE(before && after);
  for (const double t : {0.3, 1.0, 2.2}) expect_same((*after)(t), frames.orientation((*before)(t)), 1e-14);
}

TEST(TurnedBack, PosesThatTakeTheWorldIntoTheBodyBecomeThoseOfTheBody) {
  const Eigen::Quaterniond world_to_body(0.8, 0.36, 0.48, 0.0);
  const Eigen::Vector3d centre(3.0, 0.0, 1.0), rate(0.1, 0.2, 0.3);
  const KeyframeData stated{.times = {0.0},
                            .orientations = {world_to_body},
                            .positions = {-(world_to_body * centre)},
                            .angular_velocities = {rate},
                            .inner_leaving = {world_to_body}};
  const KeyframeData keys = inverted(stated);
  EXPECT_EQ(keys.orientations[0].coeffs(), world_to_body.conjugate().coeffs());
  EXPECT_EQ(keys.inner_leaving[0].coeffs(), world_to_body.conjugate().coeffs());
  EXPECT_TRUE(near(keys.positions[0], centre, 1e-15));
  EXPECT_EQ(keys.angular_velocities[0], rate);
  EXPECT_EQ(conjugated(stated).orientations[0].coeffs(), keys.orientations[0].coeffs());
  EXPECT_EQ(conjugated(stated).positions[0], stated.positions[0]);
}

TEST(FrameChange, CommutesWithTheCurve) {
  Track track(
      Keyframes::make({.times = {0.0, 1.0, 2.5, 3.0},
                       .orientations = {{1, 0, 0, 0}, {0.8, 0.36, 0.48, 0.0}, {0.5, 0.5, -0.5, 0.5}, {0, 1, 0, 0}},
                       .positions = {{1, 2, 3}, {4, 5, 6}, {0, 1, 0}, {2, 2, 2}}})
          .value());
  const FrameChange change = changed("NED:ENU", "FRD:FLU");
  const NewFrames frames(change);
  const Track turned = in_frames(track, change).value();
  const auto before = make_pose_curve("timed-c2", track.keys), after = make_pose_curve("timed-c2", turned.keys);
  ASSERT_TRUE(before && after);
  for (const double t : {0.3, 1.0, 2.2}) {
    expect_same(after->orientation(t), frames.orientation(before->orientation(t)), 1e-14);
    EXPECT_TRUE(near(after->orientation.motion(t).angular_velocity,
                     frames.body_rate(before->orientation.motion(t).angular_velocity), 1e-13));
    EXPECT_TRUE(near(after->position->linear_motion(t).velocity,
                     frames.in_world<double>(before->position->linear_motion(t).velocity), 1e-13));
  }
}

}}  // namespace orispline
