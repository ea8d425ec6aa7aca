// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/analysis/curve_in_stretches.hpp>
#include <orispline/analysis/curve_measures.hpp>
#include <orispline/analysis/distance.hpp>
#include <orispline/curve/stretched_curve.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { namespace {

Keyframes keys_with_gaps() {
  KeyframeData data;
  for (const double t : {0.0, 0.5, 1.0, 1.5, 4.0, 7.0, 7.5, 8.0}) {
    data.times.push_back(t);
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0.3 * std::sin(t), 0.1 * t, 0.2 * std::cos(2.0 * t))));
    data.positions.emplace_back(t, t * t, 1.0);
  }
  return Keyframes::make(std::move(data), Signs::shortest).value();
}

std::vector<Stretch> stretches() { return stretches_between_gaps(keys_with_gaps().times(), 1.0).value(); }

PoseCurve curve_of(const Method& method) { return curve_in_stretches(method, keys_with_gaps(), stretches()).value(); }

TEST(Stretches, AreCutWhereAnIntervalIsLongerThanTheGap) {
  ASSERT_EQ(stretches().size(), 3u);
  EXPECT_EQ(stretches()[1].first, 4u);
  EXPECT_EQ(stretches()[1].count, 1u);
  EXPECT_EQ(stretches_between_gaps(keys_with_gaps().times(), 0.5).error().option, "gap");
}

TEST(CurveInStretches, IsEachStretchsOwnAndNothingBetween) {
  const Keyframes keys = keys_with_gaps();
  for (const FamilyInfo& family : families_info()) {
    if (family.min_keys > 3 || family.key_use.first > 0 || family.key_use.stride > 1) continue;
    const Method method{family.name};
    const auto joined = curve_in_stretches(method, keys, stretches());
    ASSERT_TRUE(joined) << family.name << ": " << describe(joined.error());
    const PoseCurve first = make_pose_curve(method, keys_of_stretch(keys, stretches()[0]).value()).value();
    for (const double t : {0.0, 0.3, 1.0, 1.5}) {
      EXPECT_EQ(joined->orientation(t).coeffs(), first.orientation(t).coeffs()) << family.name << " " << t;
      EXPECT_EQ(joined->orientation.motion(t).angular_velocity, first.orientation.motion(t).angular_velocity);
      EXPECT_EQ(joined->position->linear_motion(t).position, first.position->linear_motion(t).position);
    }
    EXPECT_LE(angular_distance(joined->orientation(4.0), keys.orientations()[4]), 1e-12);
    for (const double t : {1.6, 3.9, 4.1, 6.9}) {
      EXPECT_TRUE(joined->orientation(t).coeffs().hasNaN()) << family.name << " " << t;
      EXPECT_TRUE(joined->position->linear_motion(t).position.hasNaN());
    }
  }
}

TEST(CurveInStretches, IsMeasuredWithoutItsGaps) {
  const PoseCurve joined = curve_of("global-c2");
  double energy = 0.0;
  for (const Stretch& stretch : stretches()) {
    if (stretch.count == 1) continue;
    energy +=
        energies(make_curve("global-c2", keys_of_stretch(keys_with_gaps(), stretch).value()).value()).acceleration;
  }
  EXPECT_NEAR(energies(joined.orientation).acceleration, energy, 1e-12 * energy);
  EXPECT_TRUE(is_gap(joined.orientation, 3));
  EXPECT_FALSE(is_gap(joined.orientation, 2));
  const std::vector<double> times{1.0, 3.0, 7.5};
  const std::vector<Eigen::Quaterniond> truth(3, Eigen::Quaterniond::Identity());
  EXPECT_EQ(distance_to_reference(joined.orientation, {times, truth}).count, 2u);
}

/// The keys above, but for a jump at 1.5 s in place of the first gap and one at the end.
Keyframes keys_that_jump() {
  KeyframeData data = keys_with_gaps().data();
  data.times = {0.0, 0.5, 1.0, 1.5, 1.5, 7.0, 7.5, 7.5};
  data.jumps = true;
  return Keyframes::make(std::move(data)).value();
}

TEST(CurveInStretches, HasTheLaterStretchWhereTheMotionJumps) {
  const Keyframes keys = keys_that_jump();
  const PoseCurve joined = curve_beside_gaps("auto", keys, std::nullopt).value();
  for (const auto& [t, before] : {std::pair{1.5, 3u}, {7.5, 6u}}) {
    const auto is_key = [&](const AnyCurve& curve, Side side, std::size_t key) {
      return angular_distance(curve.motion(t, side).orientation, keys.orientations()[key]) <= 1e-12;
    };
    EXPECT_TRUE(is_key(joined.orientation, Side::left, before) && is_key(joined.orientation, Side::right, before + 1));
    EXPECT_LE((joined.position->linear_motion(t).position - keys.positions()[before + 1]).norm(), 1e-12);
    EXPECT_TRUE(is_gap(joined.orientation, before) && is_gap(*joined.position, before));
  }
  EXPECT_FALSE(joined.orientation(4.0).coeffs().hasNaN());
  EXPECT_EQ(curve_beside_gaps("auto", keys, 3.0).value().orientation(4.0).coeffs().hasNaN(), true);
  const DistanceStatistics distance = distance_to_reference(joined.orientation, {keys.times(), keys.orientations()});
  EXPECT_EQ(distance.count, keys.size());
  EXPECT_LE(distance.largest, 1e-12);
  EXPECT_TRUE(std::isfinite(energies(joined.orientation).acceleration));
  EXPECT_EQ(make_pose_curve("auto", keys).error().option, "jumps");
}

TEST(CurveInStretches, HasTheTaylorSeriesOfItsMotion) {
  const PoseCurve pose = curve_of("timed-c2");
  const StretchedCurve<Eigen::Quaterniond> joined({pose.orientation});
  const Motion wanted = pose.orientation.motion(0.7);
  const Motion found = motion_from_jet(joined.point(Jet<double, 3>::variable(0.7), 1));
  EXPECT_LE((found.angular_velocity - wanted.angular_velocity).norm(), 1e-12);
  EXPECT_LE((found.angular_acceleration - wanted.angular_acceleration).norm(), 1e-11);
  EXPECT_LE((found.angular_jerk - wanted.angular_jerk).norm(), 1e-9);
}

}}  // namespace orispline
