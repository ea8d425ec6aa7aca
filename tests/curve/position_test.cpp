// SPDX-License-Identifier: Apache-2.0
// Positions ride along: by the same blending functions, linear for slerp, Catmull–Rom in time for the squads.
#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

KeyframeData walk_with_positions(std::uint64_t seed, Spacing spacing = Spacing::uneven) {
  KeyframeData data = random_walk(seed, 7, spacing, 0.8);
  Dice dice(seed + 1);
  for (std::size_t i = 0; i < 7; ++i) data.positions.push_back(3.0 * dice.vector());
  return data;
}

AnyPath path(std::string_view family, const Keyframes& keys, const CurveOptions& options = {}) {
  return make_pose_curve({family, options}, keys)->position.value();
}

TEST(Position, IsAbsentWhereTheKeysHaveNone) {
  const PoseCurve pose = make_pose_curve("slerp", keyframes(random_walk(251, 4, Spacing::even))).value();
  EXPECT_FALSE(pose.position.has_value());
}

TEST(Position, PassesThroughTheKeysThatTheOrientationTouches) {
  const Keyframes keys = keyframes(walk_with_positions(252));
  for (const FamilyInfo& family : families_info()) {
    const AnyPath p = path(family.name, keys);
    for (std::size_t i = 0; i < keys.size(); ++i)
      for (const Side side : {Side::left, Side::right}) {
        const Eigen::Vector3d found = p.linear_motion(keys.times()[i], side).position;
        if (family.passes_through(i)) {
          EXPECT_TRUE(near(found, keys.positions()[i], tolerance::algebra)) << family.name;
        } else {
          EXPECT_GE((found - keys.positions()[i]).norm(), tolerance::visible_jump) << family.name;
        }
      }
  }
}

TEST(Position, HoldsTheEndsAtRestOutside) {
  const Keyframes keys = keyframes(walk_with_positions(253));
  for (const FamilyInfo& family : families_info()) {
    const PoseCurve pose = make_pose_curve(family.name, keys).value();
    const AnyPath& p = *pose.position;
    const Domain domain = pose.orientation.domain();
    EXPECT_EQ(p.linear_motion(-100.0).position, p.linear_motion(domain.start).position) << family.name;
    EXPECT_EQ(p.linear_motion(100.0).position, p.linear_motion(domain.end).position) << family.name;
    EXPECT_EQ(p.linear_motion(100.0).velocity, Eigen::Vector3d::Zero());
    EXPECT_EQ(p.linear_motion(-100.0).acceleration, Eigen::Vector3d::Zero());
    EXPECT_EQ(p.linear_motion(100.0).jerk, Eigen::Vector3d::Zero());
  }
}

TEST(Position, OfOneKeyStaysThere) {
  KeyframeData data = random_walk(254, 1, Spacing::even);
  data.positions = {{1, 2, 3}};
  for (const FamilyInfo& family : families_info()) {
    const AnyPath p = path(family.name, keyframes(data));
    for (const double t : {-1.0, data.times[0], 5.0}) {
      EXPECT_EQ(p.linear_motion(t).position, Eigen::Vector3d(1, 2, 3));
      EXPECT_EQ(p.linear_motion(t).velocity, Eigen::Vector3d::Zero());
    }
  }
}

TEST(Position, IsLinearForSlerp) {
  const Keyframes keys = keyframes(walk_with_positions(255));
  const AnyPath p = path("slerp", keys);
  const double h = keys.times()[3] - keys.times()[2];
  const Eigen::Vector3d chord = keys.positions()[3] - keys.positions()[2];
  const LinearMotion linear_motion = p.linear_motion(keys.times()[2] + 0.3 * h);
  EXPECT_TRUE(near(linear_motion.position, keys.positions()[2] + 0.3 * chord, tolerance::algebra));
  EXPECT_TRUE(near(linear_motion.velocity, chord / h, tolerance::series));
  EXPECT_TRUE(near(linear_motion.acceleration, Eigen::Vector3d::Zero(), tolerance::series));
}

TEST(Position, HasTheDerivativesOfItself) {
  const Keyframes keys = keyframes(walk_with_positions(256));
  for (const FamilyInfo& family : families_info()) {
    const PoseCurve pose = make_pose_curve(family.name, keys).value();
    const AnyPath& p = *pose.position;
    for (std::size_t i = 0; i < pose.orientation.knots().segments(); ++i) {
      const KnotSpan span = pose.orientation.knots().span(i);
      const double h = tolerance::difference_step * span.step(), t = span.start() + 0.4 * span.step();
      const LinearMotion before = p.linear_motion(t - h), here = p.linear_motion(t), after = p.linear_motion(t + h);
      EXPECT_TRUE(near((after.position - before.position) / (2 * h), here.velocity, tolerance::difference));
      EXPECT_TRUE(near((after.velocity - before.velocity) / (2 * h), here.acceleration, tolerance::difference));
      EXPECT_TRUE(near((after.acceleration - before.acceleration) / (2 * h), here.jerk, tolerance::difference));
    }
  }
}

/// Largest deviation from a straight line at constant speed, with natural ends where the family has them.
double deviation_from_constant_velocity(const FamilyInfo& family, Spacing spacing) {
  const Eigen::Vector3d velocity(1.0, -2.0, 0.5);
  KeyframeData data = random_walk(257, 7, spacing, 0.8);
  for (const double t : data.times) data.positions.push_back(velocity * t);
  CurveOptions options;
  if (std::ranges::count(family.ends, EndRule::natural) > 0) options.start.rule = options.end.rule = EndRule::natural;
  const PoseCurve pose = make_pose_curve({family.name, options}, keyframes(data)).value();
  double deviation = 0.0;
  for (const double t : sample_times(pose.orientation.knots().times())) {
    const LinearMotion linear_motion = pose.position->linear_motion(t);
    deviation = std::max({deviation, relative_error(linear_motion.position, velocity * t),
                          relative_error(linear_motion.velocity, velocity), linear_motion.acceleration.norm()});
  }
  return deviation;
}

TEST(Position, KeepsAConstantVelocityWhereTheFamilyKeepsAConstantRate) {
  for (const FamilyInfo& family : families_info())
    for (const Spacing spacing : {Spacing::even, Spacing::uneven}) {
      const double deviation = deviation_from_constant_velocity(family, spacing);
      // The orientations of squad run in the normalised parameter, its positions in time; those of rational are
      // directions in R⁴, its positions the cubic spline itself.
      const bool straight_in_space = family.name == "squad" || family.name == "rational";
      const bool kept =
          spacing == Spacing::even ? family.keeps_constant_rate_uniform : family.keeps_constant_rate_uneven;
      if (kept || straight_in_space) {
        EXPECT_LE(deviation, tolerance::rates) << family.name;
      } else {
        EXPECT_GE(deviation, tolerance::visible_jump) << family.name;
      }
    }
}

/// A value of its own at every key for every parameter that may have one.
CurveOptions differing_parameters(const FamilyInfo& family, std::size_t keys) {
  CurveOptions options;
  for (const Parameter& parameter : family.parameters)
    if (parameter.per_key)
      for (std::size_t i = 0; i < keys; ++i)
        options.parameters[std::string(parameter.name)].push_back(parameter.initial + 0.03 * static_cast<double>(i));
  return options;
}

TEST(Position, FollowsTheSameBlendingFunctionsAsTheOrientation) {
  // About one axis the angle is a Euclidean curve: positions equal to the angles must move as the angle does.
  const std::array angles{0.0, 0.9, 0.4, 1.5, 1.2, -0.3, 0.5};
  KeyframeData data{.times = {0.0, 0.4, 1.0, 1.9, 2.0, 2.7, 3.0}};
  for (const double angle : angles) {
    data.orientations.push_back(exp<double>(Eigen::Vector3d(angle, 0, 0)));
    data.positions.emplace_back(angle, 0, 0);
  }
  const Keyframes keys = keyframes(data);
  for (const FamilyInfo& family : families_info()) {
    if (family.name.starts_with("squad")) continue;
    // Their windows also shrink with the turns, which positions have not.
    if (family.name.starts_with("auto") || family.name == "measured") continue;
    if (family.name == "circular") continue;  // where keys turn back its circles go all round, no position does
    if (family.name == "rational") continue;  // its angle is that of a direction in R⁴, no spline of angles
    for (const EndRule rule :
         family.ends.empty() ? std::vector{EndRule::none} : std::vector(family.ends.begin(), family.ends.end())) {
      if (rule == EndRule::clamped) continue;  // an angular end rate says nothing about positions
      CurveOptions options = differing_parameters(family, keys.size());
      options.start.rule = options.end.rule = rule;
      const PoseCurve pose = make_pose_curve({family.name, options}, keys).value();
      for (const double t : sample_times(pose.orientation.knots().times())) {
        const Motion m = pose.orientation.motion(t);
        const LinearMotion p = pose.position->linear_motion(t);
        EXPECT_TRUE(near(exp<double>(p.position), m.orientation, tolerance::algebra)) << family.name;
        EXPECT_TRUE(near(p.velocity, m.angular_velocity, tolerance::series)) << family.name;
        EXPECT_TRUE(near(p.acceleration, m.angular_acceleration, tolerance::rates)) << family.name;
        EXPECT_TRUE(near(p.jerk, m.angular_jerk, tolerance::rates)) << family.name;
      }
    }
  }
}

TEST(Position, ContinuesNaturallyWhereTheOrientationIsClamped) {
  const Keyframes keys = keyframes(walk_with_positions(258));
  const End clamped{.rule = EndRule::clamped, .angular_velocity = {1, 2, 3}}, natural{.rule = EndRule::natural};
  const AnyPath found = path("timed-c2", keys, {.start = clamped, .end = clamped});
  const AnyPath wanted = path("timed-c2", keys, {.start = natural, .end = natural});
  for (const double t : sample_times(keys.times()))
    EXPECT_EQ(found.linear_motion(t).position, wanted.linear_motion(t).position);
}

TEST(Position, OfSquadsIsCatmullRomInTime) {
  const Keyframes keys = keyframes(walk_with_positions(259));
  for (const char* family : {"squad", "squad-timed"}) {
    const AnyPath p = path(family, keys);
    for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
      const double before = keys.times()[i] - keys.times()[i - 1], after = keys.times()[i + 1] - keys.times()[i];
      const Eigen::Vector3d a = keys.positions()[i] - keys.positions()[i - 1];
      const Eigen::Vector3d b = keys.positions()[i + 1] - keys.positions()[i];
      const Eigen::Vector3d tangent_of_the_parabola = (after / before * a + before / after * b) / (before + after);
      for (const Side side : {Side::left, Side::right})
        EXPECT_TRUE(near(p.linear_motion(keys.times()[i], side).velocity, tangent_of_the_parabola, tolerance::series));
    }
    const double h = keys.times()[1] - keys.times()[0];
    EXPECT_TRUE(near(p.linear_motion(keys.times()[0]).velocity, (keys.positions()[1] - keys.positions()[0]) / h,
                     tolerance::series));
  }
}

}}  // namespace orispline
