// SPDX-License-Identifier: Apache-2.0
// biarcs: the construction of Wang and Joe, the law of time, the stops, and the cases without a formula.
#include <gtest/gtest.h>

#include <orispline/families/families.hpp>
#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/tolerance.hpp>
#include <support/tracks.hpp>

namespace orispline { namespace {

using namespace testing_support;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::Vector4d;

AnyCurve biarcs_curve(const KeyframeData& data, const CurveOptions& options = {}, Signs signs = Signs::shortest) {
  return make_curve({"biarcs", options}, keyframes(data, signs)).value();
}

/// A unit tangent of S³ at a point.
Vector4d tangent_at(const Vector4d& point, Dice& dice) {
  const Quaterniond q(point);
  const Vector3d v = dice.vector().normalized();
  return (q * Quaterniond(0.0, v.x(), v.y(), v.z())).coeffs();
}

TEST(Biarcs, MeetOnTheSphereWithOneTangentForAnyTangentsThatLeadOn) {
  Dice dice(701);
  int seen = 0;
  while (seen < 200) {
    const Vector4d p = exp<double>(2.0 * dice.vector()).coeffs(), q = exp<double>(2.0 * dice.vector()).coeffs();
    const Vector4d t = tangent_at(p, dice), u = tangent_at(q, dice);
    if ((q - p).dot(t) < 0.0 || (q - p).dot(u) < 0.0) continue;
    ++seen;
    const auto biarc = Biarc<Vector4d>::between(p, t, q, u, q - p);
    const double a = (t - u).squaredNorm(), b = 2.0 * (q - p).dot(t + u), c = -(q - p).squaredNorm();
    const double reach = (-b + std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
    const Vector4d joint = 0.5 * ((p + reach * t) + (q - reach * u));
    EXPECT_NEAR(joint.norm(), 1.0, tolerance::series);
    EXPECT_LE((biarc.first.at(biarc.first.length) - joint).norm(), tolerance::series);
    EXPECT_LE((biarc.last.at(biarc.last.length) - joint).norm(), tolerance::series);
    for (const Arc<Vector4d>& arc : {biarc.first, biarc.last})
      for (const double share : {0.2, 0.5, 0.9})
        EXPECT_NEAR(arc.at(share * arc.length).norm(), 1.0, tolerance::algebra);
    // The tangents at the joint: forwards on the first arc, backwards on the last one.
    const auto slope = [](const Arc<Vector4d>& arc) -> Vector4d {
      const auto point = arc.at(Jet<double, 1>::variable(arc.length));
      return {point[0].c[1], point[1].c[1], point[2].c[1], point[3].c[1]};
    };
    EXPECT_LE((slope(biarc.first) + slope(biarc.last)).norm(), tolerance::series);
    EXPECT_NEAR(slope(biarc.first).norm(), 1.0, tolerance::series);
  }
}

TEST(Biarcs, GoStraightWhereTheQuadraticIsLinear) {
  const Vector3d p(1.0, 2.0, 3.0), along = Vector3d(2.0, -1.0, 2.0) / 3.0;
  const auto biarc = Biarc<Vector3d>::between(p, along, p + 6.0 * along, along, 6.0 * along);
  EXPECT_NEAR(biarc.first.length, 3.0, tolerance::algebra);
  EXPECT_NEAR(biarc.last.length, 3.0, tolerance::algebra);
  for (const double way : {0.0, 1.0, 2.5})
    EXPECT_LE((biarc.first.at(way) - (p + way * along)).norm(), tolerance::algebra);
}

/// Keys that a steady precession passes: on a circle of S³.
KeyframeData on_a_circle(std::span<const double> times) {
  KeyframeData data;
  for (const double t : times) {
    data.times.push_back(t);
    data.orientations.push_back(exp<double>(Vector3d(0.0, 0.0, 0.7 * t)) * exp<double>(Vector3d(0.9, 0.0, 0.0)) *
                                exp<double>(Vector3d(0.0, 0.0, 0.7 * t)));
  }
  return data;
}

TEST(Biarcs, ThroughEvenKeysOfASteadyPrecessionAreThatPrecession) {
  const std::array times{0.0, 1.0, 2.0, 3.0, 4.0, 5.0};
  const AnyCurve c = biarcs_curve(on_a_circle(times));
  std::vector<double> between;
  for (double t = 0.0; t <= 5.0; t += 0.13) between.push_back(t);
  const KeyframeData truth = on_a_circle(between);
  for (std::size_t i = 0; i < between.size(); ++i)
    EXPECT_LE(angular_distance(c(between[i]), truth.orientations[i]), tolerance::series) << between[i];
}

TEST(Biarcs, NeverTurnBackOnTheirWay) {
  // About one axis, with a rest, a fast turn and a turn back: the angle is monotone between the keys.
  const std::array angles{0.0, 0.1, 2.0, 2.1, 2.1, 2.2, 1.0, 0.9};
  const std::array times{0.0, 1.0, 1.2, 4.0, 5.0, 5.5, 6.0, 9.0};
  KeyframeData data;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    data.times.push_back(times.at(i));
    data.orientations.push_back(exp<double>(Vector3d(angles.at(i), 0.0, 0.0)));
  }
  for (const EndRule rule : {EndRule::natural, EndRule::rest}) {
    const AnyCurve c = biarcs_curve(data, {.start = {.rule = rule}, .end = {.rule = rule}});
    for (std::size_t i = 0; i + 1 < angles.size(); ++i)
      for (double u = 0.0; u <= 1.0; u += 0.05) {
        const Motion m = c.motion(data.times[i] + u * (data.times[i + 1] - data.times[i]));
        EXPECT_GE(m.angular_velocity.x() * (angles.at(i + 1) - angles.at(i)), -tolerance::algebra) << i << ", " << u;
        EXPECT_LE(m.angular_velocity.tail<2>().norm(), tolerance::algebra);
      }
    EXPECT_LE(c.motion(times[5]).angular_velocity.norm(), tolerance::algebra) << "where it turns back";
    EXPECT_LE(c.motion(4.4).angular_velocity.norm(), tolerance::algebra) << "where it rests";
    EXPECT_GT(c.motion(1.1).angular_velocity.norm(), 1.0);
  }
}

TEST(Biarcs, StopWhereTheBodyIsAThousandTimesSlowerOnOneSide) {
  KeyframeData data = random_walk(702, 5, Spacing::even, 0.8);
  data.orientations[2] = data.orientations[1] * exp<double>(Vector3d(0.0, 1e-7, 0.0));  // noise of an encoder
  const AnyCurve c = biarcs_curve(data);
  for (const std::size_t key : {1u, 2u}) EXPECT_EQ(c.motion(data.times[key]).angular_velocity, Vector3d::Zero());
  // The way on does not begin in the direction of the noise: two stops would be joined by the shortest arc, and this
  // arc has the tangent of key 3 only.
  const Vector3d step = increment<double>(data.orientations[2], data.orientations[3]);
  double farthest = 0.0;
  for (const double t : sample_times(std::span(data.times).subspan(2, 2), 20))
    farthest = std::max(farthest, increment<double>(data.orientations[2], c(t)).norm());
  EXPECT_LE(farthest, 1.01 * step.norm());
}

TEST(Biarcs, OfTwoKeysAreTheGreatArcAtConstantRateWhateverTheirStep) {
  for (const double angle : {1e-9, 0.5, pi - 1e-9, pi, pi + 1e-9, 5.0, 2.0 * pi}) {
    const Vector3d axis(0.48, -0.6, 0.64);
    const KeyframeData data{.times = {0.0, 2.0},
                            .orientations = {Quaterniond::Identity(), exp<double>(Vector3d(angle * axis))}};
    const AnyCurve c = biarcs_curve(data, {}, Signs::as_given);
    const Vector3d rate = 0.5 * increment<double>(data.orientations[0], data.orientations[1]);
    for (const double t : {0.0, 0.3, 1.0, 1.7, 2.0}) {
      EXPECT_TRUE(near(c.motion(t).angular_velocity, rate, tolerance::series)) << angle << ", " << t;
      EXPECT_LE(c.motion(t).angular_acceleration.norm(), tolerance::rates) << angle;
    }
  }
}

TEST(Biarcs, AreTheSameBackwardsInTime) {
  const KeyframeData data = random_walk(703, 10, Spacing::uneven);
  EXPECT_LE(largest_distance_from_backwards(biarcs_curve(data), biarcs_curve(reversed(data))), tolerance::series);
}

TEST(Biarcs, RunThroughTheSamePathWhateverTheSpeedOfEvenKeys) {
  const KeyframeData data = random_walk(704, 7, Spacing::even);
  const AnyCurve moving = biarcs_curve(data);
  const AnyCurve resting = biarcs_curve(data, {.start = {.rule = EndRule::rest}, .end = {.rule = EndRule::rest}});
  EXPECT_LE(resting.motion(data.times.front()).angular_velocity.norm(), tolerance::algebra);
  EXPECT_LE(resting.motion(data.times.back()).angular_velocity.norm(), tolerance::algebra);
  for (const double t : sample_times(std::span(data.times).subspan(0, 2), 9)) {
    double nearest = 10.0;
    for (const double s : sample_times(std::span(data.times).subspan(0, 2), 2000))
      nearest = std::min(nearest, angular_distance(resting(t), moving(s)));
    EXPECT_LE(nearest, 1e-3) << t;
  }
}

TEST(Biarcs, MovePositionsOnCirclesAndStraightLines) {
  KeyframeData data = random_walk(705, 6, Spacing::even, 0.5);
  for (std::size_t i = 0; i < 6; ++i) {
    const double angle = 0.4 * static_cast<double>(i);
    data.positions.emplace_back(3.0 * std::cos(angle), 3.0 * std::sin(angle), 1.0);
  }
  const PoseCurve round = make_pose_curve("biarcs", keyframes(data)).value();
  for (const double t : sample_times(data.times, 8)) {
    const Vector3d p = round.position->linear_motion(t).position;
    EXPECT_NEAR(p.head<2>().norm(), 3.0, tolerance::series) << t;
    EXPECT_NEAR(p.z(), 1.0, tolerance::algebra);
  }
  const Vector3d velocity(0.3, -2.0, 0.7);
  for (std::size_t i = 0; i < 6; ++i) data.positions[i] = data.times[i] * velocity;
  const PoseCurve straight = make_pose_curve("biarcs", keyframes(data)).value();
  for (const double t : sample_times(data.times, 8)) {
    EXPECT_TRUE(near(straight.position->linear_motion(t).position, Vector3d(t * velocity), tolerance::series));
    EXPECT_TRUE(near(straight.position->linear_motion(t).velocity, velocity, tolerance::series));
  }
}

TEST(Biarcs, RestBetweenKeysThatDifferInTheirLastBits) {
  KeyframeData data{.times = {0.0, 1.0, 2.0, 3.0}, .orientations = {Quaterniond::Identity()}};
  data.orientations.emplace_back(0.95505481964979899, 0.090795329299302174, 0.24544143289892026, -0.13923003504145903);
  data.orientations.emplace_back(0.9550548196497991, 0.090795329299302188, 0.24544143289892029, -0.13923003504145906);
  data.orientations.push_back(Quaterniond::Identity());
  const AnyCurve curve = make_curve("biarcs", keyframes(data)).value();
  for (const double t : {1.0, 1.25, 1.5, 1.75, 2.0}) {
    EXPECT_TRUE(near(curve(t), data.orientations[1], tolerance::algebra)) << t;
    EXPECT_LE(curve.motion(t).angular_velocity.norm(), tolerance::algebra) << t;
  }
}

}}  // namespace orispline
