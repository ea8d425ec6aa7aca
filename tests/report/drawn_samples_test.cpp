// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <orispline/analysis/curve_in_stretches.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/report/page_samples.hpp>
#include <support/drawn_as_stated.hpp>

namespace orispline::report { namespace {

Eigen::Quaterniond about_z_by(double degrees_of_turn) {
  return exp<double>({0.0, 0.0, degrees_of_turn * radians_per_degree});
}

/// 45° about z in 1 s, then 45° in 2 s; 1 m a second along x.
Keyframes three_keys() {
  return *Keyframes::make({.times = {0.0, 1.0, 3.0},
                           .orientations = {about_z_by(0.0), about_z_by(45.0), about_z_by(90.0)},
                           .positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {3.0, 0.0, 0.0}}});
}

/// A smooth turn about changing axes with a key every tenth of a second.
Keyframes smooth_keys(int count) {
  KeyframeData data;
  for (int k = 0; k < count; ++k) {
    const double t = 0.1 * k;
    data.times.push_back(t);
    data.orientations.push_back(exp<double>({std::sin(0.3 * t), std::cos(0.2 * t), 0.5 * std::sin(0.5 * t + 1.0)}));
  }
  return *Keyframes::make(data);
}

/// The largest angle between what is drawn and the curve [deg].
double largest_angle(const PageSamples& samples, const PoseCurve& curve, int places) {
  const testing_support::DrawnAsStated drawn{samples.path.times, samples.path.orientations, samples.angular_velocities,
                                             samples.is_straight};
  const Domain domain = curve.orientation.domain();
  double largest = 0.0;
  for (int k = 0; k <= places; ++k) {
    const double t = std::lerp(domain.start, domain.end, static_cast<double>(k) / places);
    largest = std::max(largest, angular_distance(drawn(t), curve.orientation(t)) * degrees);
  }
  return largest;
}

double largest_norm(const std::vector<Eigen::Vector3d>& vectors) {
  double largest = 0.0;
  for (const Eigen::Vector3d& v : vectors) largest = std::max(largest, v.norm());
  return largest;
}

TEST(DrawnSamples, OfFewSegmentsAreEvenWithBothSidesWhereARateJumps) {
  const PageSamples slerps = drawn_samples(*make_pose_curve("slerp", three_keys()));
  EXPECT_GE(slerps.path.times.size(), 600U);
  EXPECT_LE(slerps.path.times.size(), 620U);
  const auto left = static_cast<std::size_t>(std::ranges::find(slerps.path.times, 1.0) - slerps.path.times.begin());
  ASSERT_EQ(slerps.path.times[left + 1], 1.0);
  EXPECT_NEAR(slerps.angular_velocities[left].z(), 45.0 * radians_per_degree, 1e-13);
  EXPECT_NEAR(slerps.angular_velocities[left + 1].z(), 22.5 * radians_per_degree, 1e-13);
  EXPECT_EQ(std::ranges::count(drawn_samples(*make_pose_curve("timed-c3", smooth_keys(9))).path.times, 0.1), 1);
}

TEST(DrawnSamples, SayHowFarTheDrawingIsFromTheCurve) {
  for (const std::string_view method : {"slerp", "squad", "auto", "sextic", "bezier", "bspline"})
    for (const int count : {2, 5, 400, 1501}) {
      const auto curve = make_pose_curve(method, smooth_keys(count));
      if (!curve) continue;
      const PageSamples samples = drawn_samples(*curve);
      const double found = largest_angle(samples, *curve, 20'000);
      EXPECT_LE(*samples.exactness, 0.005) << method << count;
      EXPECT_LE(found, 0.005) << method << count;
      EXPECT_LE(samples.path.times.size(), 5000U) << method << count;
    }
}

TEST(DrawnSamples, OfASmoothCurveAreFewerThanItsKnots) {
  const PoseCurve curve = *make_pose_curve("auto", smooth_keys(3001));
  const PageSamples samples = drawn_samples(curve);
  EXPECT_LE(samples.path.times.size(), 800U);
  EXPECT_LE(largest_angle(samples, curve, 30'000), 0.005);
}

TEST(DrawnSamples, OfManySegmentsMissNoPeak) {
  KeyframeData data;
  for (int k = 0; k < 1000; ++k) {
    data.times.push_back(k);
    data.orientations.push_back(about_z_by(k + (k == 617 ? 60.0 : 0.0)));  // one spike among steady turning
  }
  const PoseCurve curve = *make_pose_curve("auto", *Keyframes::make(data));
  const PageSamples samples = drawn_samples(curve, {.least = 100});
  double rate = 0.0, acceleration = 0.0, jerk = 0.0;
  for (int i = 0; i <= 100'000; ++i) {
    const Motion m = curve.orientation.motion(999e-5 * i);
    rate = std::max(rate, m.angular_velocity.norm());
    acceleration = std::max(acceleration, m.angular_acceleration.norm());
    jerk = std::max(jerk, m.angular_jerk.norm());
  }
  EXPECT_GE(largest_norm(samples.angular_velocities), 0.97 * rate);
  EXPECT_GE(largest_norm(samples.angular_accelerations), 0.97 * acceleration);
  EXPECT_GE(largest_norm(samples.angular_jerks), 0.97 * jerk);
  EXPECT_EQ(samples.path.times.front(), 0.0);
  EXPECT_EQ(samples.path.times.back(), 999.0);
  EXPECT_TRUE(std::ranges::is_sorted(samples.path.times));
  EXPECT_LE(samples.path.times.size(), 400U);
}

TEST(DrawnSamples, AreNoMoreThanAllowedAndSayWhatTheyReach) {
  KeyframeData data;
  std::uint32_t noise = 7;
  for (int k = 0; k < 20'000; ++k) {
    noise = 1664525U * noise + 1013904223U;
    data.times.push_back(0.01 * k);
    data.orientations.push_back(about_z_by(5.0 * std::sin(0.01 * k) + 1e-9 * static_cast<double>(noise)));
  }
  const PoseCurve curve = *make_pose_curve("auto", *Keyframes::make(data));
  const PageSamples samples = drawn_samples(curve, {.most = 1000});
  EXPECT_LE(samples.path.times.size(), 1000U);
  EXPECT_GT(*samples.exactness, 0.005);
  EXPECT_LE(largest_angle(samples, curve, 100'000), 1.2 * *samples.exactness);
}

TEST(DrawnSamples, OfNoiseGoStraightAndAreAsFarOffAsItIs) {
  const double noise = 1e-9 * 4294967296.0 * radians_per_degree;  // the largest
  KeyframeData data;
  std::uint32_t state = 7;
  for (int k = 0; k < 20'000; ++k) {
    state = 1664525U * state + 1013904223U;
    data.times.push_back(0.01 * k);
    data.orientations.push_back(about_z_by(1e-9 * static_cast<double>(state)));
  }
  const PageSamples samples = drawn_samples(*make_pose_curve("auto", *Keyframes::make(data)), {.most = 1000});
  EXPECT_TRUE(samples.is_straight);
  EXPECT_LE(*samples.exactness, 1.5 * noise / radians_per_degree);
  EXPECT_LE(samples.path.times.size(), 1000U);
  EXPECT_FALSE(drawn_samples(*make_pose_curve("auto", smooth_keys(3001))).is_straight);
}

/// Turned by 30 degrees more at each knot, and at rest between.
class Steps {
 public:
  explicit Steps(std::size_t count) : knots_(times(count)) {}
  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  template <Number T>
  [[nodiscard]] Quaternion<T> point(const T&, std::size_t segment) const noexcept {
    return constant<T>(about_z_by(30.0 * static_cast<double>(segment)));
  }

 private:
  static std::vector<double> times(std::size_t count) {
    std::vector<double> times;
    for (std::size_t k = 0; k <= count; ++k) times.push_back(0.25 * static_cast<double>(k));
    return times;
  }
  Knots knots_;
};

TEST(DrawnSamples, OfACurveThatJumpsHaveBothSidesOfEachJump) {
  for (const std::size_t count : {3u, 40u, 1000u}) {
    const PoseCurve curve{AnyCurve(Steps(count)), {}};
    const PageSamples samples = drawn_samples(curve);
    const std::vector<double>& t = samples.path.times;
    EXPECT_LE(*samples.exactness, 0.005) << count;
    EXPECT_FALSE(samples.is_straight);
    for (const double knot : curve.orientation.knots().times().subspan(1, count - 1)) {
      const auto left = static_cast<std::size_t>(std::ranges::lower_bound(t, knot) - t.begin());
      ASSERT_EQ(std::ranges::count(t, knot), 2) << count;
      EXPECT_NEAR(angular_distance(samples.path.orientations[left], samples.path.orientations[left + 1]) * degrees,
                  30.0, 1e-9);
    }
  }
}

TEST(DrawnSamples, OfACurveThatIsNaNInAPartHaveAGapThere) {
  const Keyframes keys = smooth_keys(1001);
  std::vector<double> times(keys.times().begin(), keys.times().end());
  for (std::size_t i = 400; i < times.size(); ++i) times[i] += 20.0;
  const Keyframes apart = *Keyframes::make({times, {keys.orientations().begin(), keys.orientations().end()}});
  const auto curve = curve_in_stretches("auto", apart, *stretches_between_gaps(times, 1.0));
  ASSERT_TRUE(curve);
  const PageSamples samples = drawn_samples(*curve);
  EXPECT_LE(*samples.exactness, 0.005);
  for (std::size_t i = 0; i < samples.path.times.size(); ++i)
    EXPECT_EQ(samples.path.orientations[i].coeffs().hasNaN(),
              times[399] < samples.path.times[i] && samples.path.times[i] < times[400])
        << samples.path.times[i];
  EXPECT_EQ(std::ranges::count_if(samples.path.orientations, [](const auto& q) { return std::isnan(q.w()); }), 1);
}

TEST(DrawnSamples, HavePositionsBetweenWhichStraightLinesShowThePath) {
  KeyframeData data;
  for (int k = 0; k < 400; ++k) {
    data.times.push_back(0.1 * k);
    data.orientations.push_back(about_z_by(1.0));
    data.positions.emplace_back(1000.0 + std::cos(0.05 * k), std::sin(0.05 * k), 0.0);
  }
  const PoseCurve curve = *make_pose_curve("auto", *Keyframes::make(data));
  const PageSamples samples = drawn_samples(curve);
  ASSERT_EQ(samples.positions.size(), samples.path.times.size());
  for (std::size_t i = 1; i < samples.path.times.size(); ++i)
    for (const double u : {0.25, 0.5, 0.75}) {
      const double t = std::lerp(samples.path.times[i - 1], samples.path.times[i], u);
      const Eigen::Vector3d line = samples.positions[i - 1] + u * (samples.positions[i] - samples.positions[i - 1]);
      EXPECT_LE((curve.position->linear_motion(t).position - line).norm(), 2.0 / 2000.0);
    }
}

TEST(DrawnSamples, OfOneKeyAreOne) {
  const Keyframes key = *Keyframes::make({.times = {2.0}, .orientations = {about_z_by(10.0)}});
  const PageSamples samples = drawn_samples(*make_pose_curve("auto", key));
  EXPECT_EQ(samples.path.times, std::vector{2.0});
  EXPECT_EQ(samples.exactness, 0.0);
}

TEST(DrawnSamples, InAGapThereIsNothing) {
  for (const int count : {4, 1001}) {
    const Keyframes keys = smooth_keys(count);
    const double first = keys.times()[1], end = keys.times()[2];
    const Covers covers = [&](double t) { return t <= first || t >= end; };
    const PageSamples samples = drawn_samples(*make_pose_curve("auto", keys), {.covers = covers});
    std::size_t none = 0;
    for (std::size_t i = 0; i < samples.path.times.size(); ++i) {
      const bool gap = !covers(samples.path.times[i]);
      none += gap ? 1 : 0;
      EXPECT_EQ(std::isnan(samples.path.orientations[i].w()), gap);
      EXPECT_EQ(samples.angular_velocities[i].hasNaN(), gap);
      EXPECT_EQ(samples.angular_jerks[i].hasNaN(), gap);
    }
    EXPECT_EQ(none, 1U);
    for (const double edge : {first, end}) EXPECT_EQ(std::ranges::count(samples.path.times, edge), 1) << edge;
  }
  const PageSamples nothing =
      drawn_samples(*make_pose_curve("auto", smooth_keys(3)), {.covers = [](double) { return false; }});
  EXPECT_EQ(nothing.path.times.size(), 1U);
}

}}  // namespace orispline::report
