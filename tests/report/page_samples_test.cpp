// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/page_samples.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <orispline/curve/stretched_curve.hpp>
#include <orispline/families/registry.hpp>

namespace orispline::report { namespace {

constexpr double degree = std::numbers::pi / 180.0;

Eigen::Quaterniond about_z(double angle) { return exp<double>({0.0, 0.0, angle * degree}); }

/// 45° about z in 1 s, then 45° in 2 s; 1 m a second along x.
Keyframes turning_keys() {
  return *Keyframes::make({.times = {0.0, 1.0, 3.0},
                           .orientations = {about_z(0.0), about_z(45.0), about_z(90.0)},
                           .positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {3.0, 0.0, 0.0}}});
}

TEST(PageSamples, HaveBothSidesOfTheJumpAtAKey) {
  const PageSamples samples = sampled(*make_pose_curve("slerp", turning_keys()), 30);
  const auto at = std::ranges::find(samples.path.times, 1.0) - samples.path.times.begin();
  const auto left = static_cast<std::size_t>(at);
  ASSERT_EQ(samples.path.times[left + 1], 1.0);
  EXPECT_NEAR(samples.angular_velocities[left].z(), 45.0 * degree, 1e-13);
  EXPECT_NEAR(samples.angular_velocities[left + 1].z(), 22.5 * degree, 1e-13);
}

TEST(PageSamples, DrawNothingBetweenTheSidesOfAJumpOfTheMotion) {
  const auto turning = [](double start, double angle) {
    return *make_curve("slerp", *Keyframes::make({.times = {start, start + 1.0},
                                                  .orientations = {about_z(angle), about_z(angle + 30.0)}}));
  };
  const PoseCurve curve{StretchedCurve<Eigen::Quaterniond>({turning(0.0, 0.0), turning(1.0, 90.0)})};
  for (const PageSamples& samples : {sampled(curve, 30), drawn_samples(curve, {})}) {
    const auto& q = samples.path.orientations;
    const auto gap = std::ranges::find_if(q, [](const Eigen::Quaterniond& one) { return one.coeffs().hasNaN(); });
    ASSERT_TRUE(gap != q.begin() && gap + 1 < q.end());
    EXPECT_NEAR(angular_distance(*(gap - 1), about_z(30.0)), 0.0, 1e-12);
    EXPECT_NEAR(angular_distance(*(gap + 1), about_z(90.0)), 0.0, 1e-12);
    EXPECT_EQ(samples.path.times[static_cast<std::size_t>(gap - q.begin())], 1.0);
  }
}

TEST(PageSamples, CoverTheCurveEvenlyWithAllThatItHas) {
  const PageSamples samples = sampled(*make_pose_curve("auto", turning_keys()), 30);
  const std::vector<double>& t = samples.path.times;
  EXPECT_EQ(t.size(), 32U);
  EXPECT_EQ(t.front(), 0.0);
  EXPECT_EQ(t.back(), 3.0);
  EXPECT_TRUE(std::ranges::is_sorted(t));
  for (std::size_t i = 1; i < t.size(); ++i) EXPECT_LE(t[i] - t[i - 1], 0.1 + 1e-12);
  for (const std::size_t size : {samples.path.orientations.size(), samples.angular_velocities.size(),
                                 samples.angular_accelerations.size(), samples.angular_jerks.size()})
    EXPECT_EQ(size, t.size());
  ASSERT_EQ(samples.positions.size(), t.size());
  for (std::size_t i = 0; i < t.size(); ++i) EXPECT_NEAR(samples.positions[i].x(), t[i], 1e-12);
}

TEST(PageSamples, OfManySegmentsMissNoPeak) {
  KeyframeData data;
  for (int k = 0; k < 1000; ++k) {
    data.times.push_back(k);
    data.orientations.push_back(about_z(k + (k == 617 ? 60.0 : 0.0)));  // one spike among steady turning
  }
  const PoseCurve curve = *make_pose_curve("auto", *Keyframes::make(data));
  const PageSamples samples = sampled(curve, 100);
  const auto largest_in = [](const std::vector<Eigen::Vector3d>& vectors) {
    double largest = 0.0;
    for (const Eigen::Vector3d& v : vectors) largest = std::max(largest, v.norm());
    return largest;
  };
  double rate = 0.0, acceleration = 0.0;
  for (int i = 0; i <= 1'000'000; ++i) {
    const Motion m = curve.orientation.motion(999e-6 * i);
    rate = std::max(rate, m.angular_velocity.norm());
    acceleration = std::max(acceleration, m.angular_acceleration.norm());
  }
  EXPECT_GE(largest_in(samples.angular_velocities), 0.97 * rate);
  EXPECT_GE(largest_in(samples.angular_accelerations), 0.97 * acceleration);
  EXPECT_LE(samples.path.times.size(), 9U * 11U + 1U);
  EXPECT_EQ(samples.path.times.front(), 0.0);
  EXPECT_EQ(samples.path.times.back(), 999.0);
  EXPECT_TRUE(std::ranges::is_sorted(samples.path.times));
  EXPECT_EQ(samples.angular_jerks.size(), samples.path.times.size());
}

TEST(PageSamples, OfManySegmentsAreTheSameHoweverTheCurveIsLookedAt) {
  KeyframeData data;
  for (int k = 0; k < 200; ++k) {
    data.times.push_back(k);
    data.orientations.push_back(about_z(30.0 * std::sin(k) + 20.0 * std::sin(0.1 * k)));
  }
  const PoseCurve curve = *make_pose_curve("auto", *Keyframes::make(data));
  std::size_t looks = 0;
  const auto look = [&](std::size_t segment, std::span<const double> times, std::span<Motion> motions) {
    ++looks;
    for (std::size_t k = 0; k < times.size(); ++k) motions[k] = curve.orientation.motion_on(segment, times[k]);
  };
  EXPECT_EQ(sampled(curve, 100, look).path.times, sampled(curve, 100).path.times);
  EXPECT_EQ(looks, 199u);
}

TEST(PageSamples, OfOneKeyAreOne) {
  const Keyframes key = *Keyframes::make({.times = {2.0}, .orientations = {about_z(10.0)}});
  EXPECT_EQ(sampled(*make_pose_curve("auto", key)).path.times, std::vector{2.0});
}

TEST(PageSamples, ThinnedPathsKeepTheirEnds) {
  PagePath path;
  for (int k = 0; k < 1001; ++k) {
    path.times.push_back(k);
    path.orientations.push_back(about_z(0.1 * k));
  }
  const PagePath few = thinned(path, 11);
  ASSERT_EQ(few.times.size(), 11U);
  for (std::size_t k = 0; k < 11; ++k) EXPECT_EQ(few.times[k], 100.0 * static_cast<double>(k));
  EXPECT_EQ(few.orientations.size(), 11U);
  EXPECT_EQ(thinned(few, 11).times, few.times);
}

TEST(PageSamples, ThinnedKeysKeepTheirPositions) {
  KeyframeData data;
  for (int k = 0; k < 101; ++k) {
    data.times.push_back(k);
    data.orientations.push_back(about_z(k));
    data.positions.emplace_back(2.0 * k, 0.0, 0.0);
  }
  const PageKeys few = thinned(page_keys(*Keyframes::make(data)), 11);
  ASSERT_EQ(few.path.times.size(), 11U);
  ASSERT_EQ(few.positions.size(), 11U);
  for (std::size_t k = 0; k < 11; ++k) EXPECT_EQ(few.positions[k].x(), 2.0 * few.path.times[k]);
}

TEST(PageSamples, TheLargestOfManyErrorsAreKept) {
  PageErrors errors;
  for (int k = 0; k < 1000; ++k) {
    errors.times.push_back(0.1 * k);
    errors.values.push_back(k == 777 ? 9.0 : k % 10 == 3 ? 1.0 : 0.5);
  }
  const PageErrors few = largest(errors, 100);
  ASSERT_EQ(few.values.size(), 100U);
  for (std::size_t k = 0; k < 100; ++k) EXPECT_EQ(few.values[k], k == 77 ? 9.0 : 1.0);
  EXPECT_EQ(few.times[77], errors.times[777]);
  EXPECT_EQ(largest(errors, 1000).times, errors.times);
  EXPECT_EQ(largest(errors, 300).times.size(), 300U);
  EXPECT_EQ(std::ranges::max(largest(errors, 7).values), 9.0);
}

TEST(PageSamples, ErrorsAtGivenPlacesAreTheLargestOfThoseThatAreNearest) {
  const double missing = std::nan("");
  const PageErrors errors{{0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0},
                          {1.0, 2.0, 9.0, 4.0, 8.0, missing, missing, missing}};
  const PageErrors few = largest_near(errors, std::vector<std::size_t>{0, 3, 7});
  EXPECT_EQ(few.times, (std::vector{0.0, 3.0, 7.0}));
  EXPECT_EQ(few.values[0], 2.0);
  EXPECT_EQ(few.values[1], 9.0);
  EXPECT_TRUE(std::isnan(few.values[2]));
  EXPECT_EQ(largest_near(errors, std::vector<std::size_t>{4}).values, std::vector{9.0});
  EXPECT_TRUE(largest_near({}, {}).values.empty());
}

TEST(PageSamples, AGapIsMarkedBetweenTheNeighbours) {
  const Covers covers = [](double t) { return t <= 1.0 || t >= 2.0; };
  const PagePath path = with_gaps({{0.0, 1.0, 2.0, 3.0}, std::vector(4, about_z(5.0))}, covers);
  EXPECT_EQ(path.times, (std::vector{0.0, 1.0, 1.5, 2.0, 3.0}));
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(std::isnan(path.orientations[i].z()), i == 2);
  const PageErrors errors = with_gaps(PageErrors{{0.5, 2.5}, {1.0, 2.0}}, covers);
  EXPECT_EQ(errors.times, (std::vector{0.5, 1.5, 2.5}));
  EXPECT_TRUE(std::isnan(errors.values[1]));
  EXPECT_EQ(errors.values[2], 2.0);
}

TEST(PageSamples, KeysAreTakenAsTheyAre) {
  const PageKeys keys = page_keys(turning_keys());
  EXPECT_EQ(keys.path.times, (std::vector{0.0, 1.0, 3.0}));
  EXPECT_EQ(keys.path.orientations.size(), 3U);
  EXPECT_EQ(keys.positions[2].x(), 3.0);
}

}}  // namespace orispline::report
