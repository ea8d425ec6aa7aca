// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/rate_bounds.hpp>

#include <atomic>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include <orispline/analysis/segment_hull.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/degrees.hpp>

#include "retime/retimed_motion.hpp"
#include "support/random_motion.hpp"
#include "support/specimens.hpp"

namespace orispline { namespace {

using testing_support::steady_rotation;

const Eigen::Vector3d moments(1.0, 2.0, 2.5);
constexpr MotionSizes low_floors{1e-3, 1e-3, 1e-3, 1e-3};

/// Euler's equations, component by component.
double torque_by_components(const Motion& m) {
  const Eigen::Vector3d& w = m.angular_velocity;
  const Eigen::Vector3d& a = m.angular_acceleration;
  return std::hypot(moments[0] * a[0] - (moments[1] - moments[2]) * w[1] * w[2],
                    moments[1] * a[1] - (moments[2] - moments[0]) * w[2] * w[0],
                    moments[2] * a[2] - (moments[0] - moments[1]) * w[0] * w[1]);
}

/// The largest of one segment at so many steps.
MotionSizes densely_sampled(const AnyCurve& curve, std::size_t segment, int steps = 10000) {
  const KnotSpan span = curve.knots().span(segment);
  MotionSizes largest{};
  for (int i = 0; i <= steps; ++i) {
    const Motion m = curve.motion_on(segment, span.start() + i * span.step() / steps);
    largest.rate = std::max(largest.rate, m.angular_velocity.norm());
    largest.acceleration = std::max(largest.acceleration, m.angular_acceleration.norm());
    largest.torque = std::max(largest.torque, torque_by_components(m));
    largest.jerk = std::max(largest.jerk, m.angular_jerk.norm());
  }
  return largest;
}

/// What the snap is nowhere above on a segment [rad/s⁴].
std::optional<double> snap_bound(const SegmentForm& form, double duration) {
  const auto hull = SegmentHull::of(form, duration);
  return hull ? std::optional(hull->on(0.0, 1.0).snap) : std::nullopt;
}

void expect_tight(const CertifiedPeak& peak, double sampled, const std::string& what, double gap = 1.001e-4) {
  EXPECT_GE(peak.bound, sampled) << what;
  EXPECT_LE(peak.bound, std::max(1e-3, peak.found * (1.0 + gap))) << what;
  EXPECT_LE(peak.found, sampled * (1.0 + 1e-4) + 1e-9) << what;
}

void expect_bounds(const AnyCurve& curve, const std::string& what, double gap_of_jerk = 1.001e-4) {
  const auto peaks = certified(curve, inertia, low_floors).value();
  ASSERT_EQ(peaks.size(), curve.knots().segments());
  for (std::size_t s = 0; s < peaks.size(); ++s) {
    const MotionSizes sampled = densely_sampled(curve, s);
    expect_tight(peaks[s].rate, sampled.rate, what + ", rate");
    expect_tight(peaks[s].acceleration, sampled.acceleration, what + ", acceleration");
    expect_tight(peaks[s].torque, sampled.torque, what + ", torque");
    expect_tight(peaks[s].jerk, sampled.jerk, what + ", jerk", gap_of_jerk);
  }
}

TEST(RateBounds, HoldEverywhereAndAreNearForEveryMethodOfPolynomialsWithRatesOfItsOwn) {
  std::size_t methods = 0;
  for (const FamilyInfo& info : families_info()) {
    const std::string name(info.name);
    unsigned seed = 7;
    for (const KeyDrawing how :
         {KeyDrawing{4, 60.0 * radians_per_degree}, KeyDrawing{4, 170.0 * radians_per_degree, 100.0},
          KeyDrawing{2, 170.0 * radians_per_degree}}) {
      const auto curve = make_curve(info.name, random_keys(++seed, how));
      if (info.rate_orders > 0 || !curve || !certified(*curve, {}, low_floors)) continue;
      expect_bounds(*curve, name + " of " + std::to_string(how.count));
      ++methods;
    }
  }
  EXPECT_GE(methods, 40u);
}

TEST(RateBounds, HoldOnIntervalsThatAreNotHalved) {
  constexpr double any = std::numeric_limits<double>::infinity();
  for (unsigned seed = 0; seed < 40; ++seed)
    for (const std::string_view method : {"auto", "timed-c2", "timed-c1", "bspline", "rational"}) {
      const AnyCurve curve =
          make_curve(method, random_keys(seed, {5, method == "rational" ? 1.5 : 3.0, seed % 2 == 0 ? 1.0 : 10.0}))
              .value();
      const auto peaks = certified(curve, inertia, {any, any, any, any}).value();
      for (std::size_t s = 0; s < peaks.size(); ++s) {
        const MotionSizes sampled = densely_sampled(curve, s, 200);
        EXPECT_GE(peaks[s].rate.bound, sampled.rate) << method << seed;
        EXPECT_GE(peaks[s].acceleration.bound, sampled.acceleration) << method << seed;
        EXPECT_GE(peaks[s].torque.bound, sampled.torque) << method << seed;
        EXPECT_GE(peaks[s].jerk.bound, sampled.jerk) << method << seed;
      }
    }
}

TEST(RateBounds, OfTheSnapIsAboveThatOfTheCurve) {
  for (unsigned seed = 0; seed < 20; ++seed)
    for (const std::string_view method : {"auto", "timed-c2", "timed-sextic", "bspline", "rational"}) {
      const AnyCurve curve = make_curve(method, random_keys(seed, {5, method == "rational" ? 1.5 : 3.0, 10.0})).value();
      for (std::size_t s = 0; s < curve.knots().segments(); ++s) {
        const KnotSpan span = curve.knots().span(s);
        const double bound = snap_bound(curve.form(s), span.step()).value();
        for (int i = 1; i < 100; ++i) {
          const double t = span.start() + 0.01 * i * span.step(), h = 1e-5 * span.step();
          const Eigen::Vector3d difference =
              curve.motion_on(s, t + h).angular_jerk - curve.motion_on(s, t - h).angular_jerk;
          EXPECT_LE(difference.norm() / (2.0 * h), bound * (1.0 + 1e-6)) << method << seed;
        }
      }
    }
}

TEST(RateBounds, OfTheSnapIsThatOfASmallTurn) {
  constexpr double angle = 1e-4, duration = 2.0;  // [rad], [s]; about one axis by angle · u⁴
  ChartForm quartic{.degree = 4, .base = Eigen::Quaterniond::Identity(), .rotation_vector = {}};
  quartic.rotation_vector[1].coefficients[4] = angle;
  EXPECT_NEAR(snap_bound(quartic, duration).value() / (24.0 * angle / std::pow(duration, 4)), 1.0, 0.01);
  CumulativeForm steady{.degree = 1,
                        .base = Eigen::Quaterniond::Identity(),
                        .increments = {Eigen::Vector3d(0, 0, 3), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()},
                        .blending = {}};
  steady.blending[0].coefficients[1] = 1.0;
  EXPECT_EQ(snap_bound(steady, duration).value(), 0.0);
  EXPECT_FALSE(snap_bound({}, duration));
}

TEST(RateBounds, AreZeroAtRest) {
  const auto rest = Keyframes::make({.times = {0, 1, 3}, .orientations = std::vector(3, exp<double>({1.0, 2.0, 0.5}))});
  for (const std::string_view method : {"auto", "timed-c2"}) {
    const auto found = certified(make_curve(method, rest.value()).value(), inertia, low_floors).value();
    for (const TurningPeaks& peaks : found) {
      EXPECT_LE(peaks.rate.bound, 1e-12);
      EXPECT_LE(peaks.acceleration.bound, 1e-12);
      EXPECT_LE(peaks.torque.bound, 1e-11);
      EXPECT_EQ(peaks.rate.found, 0.0);
    }
  }
}

TEST(RateBounds, HoldWhereTimesAreRoundedMuch) {
  const Keyframes keys = random_keys(3, {5, 1.0});
  KeyframeData late{.orientations = {keys.orientations().begin(), keys.orientations().end()}};
  for (const double t : keys.times()) late.times.push_back(1.7e9 + 0.01 * t);  // [s]; a double there is exact to 2e-7 s
  expect_bounds(make_curve("timed-c2", Keyframes::make(late).value()).value(), "late",
                5e-4);  // within the rounding of the times the jerk changes by nearly that share
}

TEST(RateBounds, ThatAreBelowTheFloorsAreNearEnough) {
  const AnyCurve curve = make_curve("auto", random_keys(5, {6, 1.0})).value();
  const auto found = certified(curve, {}, {100.0, 1000.0, 1.0, 1e5}).value();
  for (const TurningPeaks& peaks : found) {
    EXPECT_LE(peaks.rate.bound, 100.0);
    EXPECT_LE(peaks.acceleration.bound, 1000.0);
    EXPECT_EQ(peaks.torque.bound, 0.0);
  }
}

/// A curve, and how often it was asked.
class Watched {
 public:
  Watched(AnyCurve curve, std::atomic<int>& asked) : curve_(std::move(curve)), asked_(&asked) {}

  [[nodiscard]] const Knots& knots() const noexcept { return curve_.knots(); }
  [[nodiscard]] SegmentForm form(std::size_t segment) const noexcept { return curve_.form(segment); }
  [[nodiscard]] Motion motion(double t, std::size_t segment) const noexcept {
    ++*asked_;
    return curve_.motion_on(segment, t);
  }
  template <Number T>
  [[nodiscard]] Quaternion<T> point(const T& t, std::size_t segment) const noexcept {
    return constant<T>(curve_.orientation_on(segment, static_cast<double>(value_of(t))));
  }

 private:
  AnyCurve curve_;
  std::atomic<int>* asked_;
};

TEST(RateBounds, AreNotSoughtBelowTheirRounding) {
  const Keyframes keys = Keyframes::make(steady_rotation({0.0, 1.0}, {1.287, 0.0, 0.0})).value();
  const auto all = quantities_of({.rate = 2.0, .acceleration = 1e-9});
  QuantitySizes floors;
  floors.fill(1e-12);
  std::size_t methods = 0;
  for (const FamilyInfo& info : families_info()) {
    const auto steady = make_curve({info.name, {.start = {EndRule::natural}, .end = {EndRule::natural}}}, keys);
    if (!steady || steady->motion(0.3).angular_acceleration.norm() > 1e-12) continue;
    std::atomic<int> asked = 0;
    if (!certified_peaks({AnyCurve(Watched(*steady, asked))}, {all, {}}, floors)) continue;
    ++methods;
    EXPECT_LE(asked, 200) << info.name;
  }
  EXPECT_GE(methods, 9u);
}

TEST(RateBounds, SamplesAreThoseOfTheCurve) {
  const AnyCurve curve = make_curve("auto", random_keys(5, {6, 2.0, 10.0})).value();
  const auto all = lengths();
  const auto sampled = sampled_peaks({curve}, {all, inertia});
  ASSERT_EQ(sampled.size(), 5u);
  for (std::size_t s = 0; s < sampled.size(); ++s) {
    const MotionSizes dense = densely_sampled(curve, s);
    EXPECT_NEAR(sampled[s][0] / dense.rate, 1.0, 0.02);
    EXPECT_NEAR(sampled[s][1] / dense.acceleration, 1.0, 0.05);
    EXPECT_NEAR(sampled[s][2] / dense.jerk, 1.0, 0.05);
    EXPECT_NEAR(sampled[s][3] / dense.torque, 1.0, 0.05);
    EXPECT_LE(sampled[s][0], dense.rate * (1.0 + 1e-9));
  }
}

TEST(RateBounds, OfComponentsHoldAndAreNear) {
  const auto all = quantities_of(
      {.rate = Eigen::Vector3d(1, 1, 1), .acceleration = Eigen::Vector3d(1, 1, 1), .jerk = Eigen::Vector3d(1, 1, 1)});
  ASSERT_EQ(all.size(), 9u);
  QuantitySizes floors;
  floors.fill(1e-3);
  for (const std::string_view method : {"auto", "timed-c2"}) {
    const AnyCurve curve = make_curve(method, random_keys(17, {6, 2.5, 10.0})).value();
    const auto peaks = certified_peaks({curve}, {all, {}}, floors).value();
    for (std::size_t s = 0; s < peaks.size(); ++s) {
      QuantitySizes sampled{};
      const KnotSpan span = curve.knots().span(s);
      for (int i = 0; i <= 10000; ++i) {
        const Motion m = curve.motion_on(s, span.start() + i * span.step() / 10000);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto k = static_cast<Eigen::Index>(axis);
          sampled[axis] = std::max(sampled[axis], std::abs(m.angular_velocity[k]));
          sampled[3 + axis] = std::max(sampled[3 + axis], std::abs(m.angular_acceleration[k]));
          sampled[6 + axis] = std::max(sampled[6 + axis], std::abs(m.angular_jerk[k]));
        }
      }
      for (std::size_t k = 0; k < 9; ++k)
        expect_tight(peaks[s][k], sampled[k], std::string(method) + " " + std::to_string(k));
    }
  }
}

TEST(RateBounds, OfPositionsHoldAndAreNearForEveryMethodOfPolynomials) {
  const auto all = quantities_of({.speed = 1.0, .linear_acceleration = Eigen::Vector3d(1, 1, 1)});
  QuantitySizes floors;
  floors.fill(1e-3);
  const Keyframes turning = random_keys(18, {13, 1.0, 10.0});
  std::mt19937 random(18);
  std::uniform_real_distribution<double> place(-2.0, 2.0);
  KeyframeData data{.times = {turning.times().begin(), turning.times().end()},
                    .orientations = {turning.orientations().begin(), turning.orientations().end()}};
  for (std::size_t i = 0; i < turning.size(); ++i)
    data.positions.emplace_back(place(random), place(random), place(random));
  const Keyframes keys = Keyframes::make(data).value();
  std::size_t methods = 0;
  for (const FamilyInfo& info : families_info()) {
    const auto curve = make_pose_curve(Method(info.name), keys);
    if (info.rate_orders > 0 || !curve) continue;
    const auto peaks = certified_peaks(*curve, {all, {}}, floors);
    if (!peaks) continue;
    ++methods;
    for (std::size_t s = 0; s < peaks->size(); ++s) {
      QuantitySizes sampled{};
      const KnotSpan span = curve->position->knots().span(s);
      for (int i = 0; i <= 2000; ++i) {
        const LinearMotion m = curve->position->linear_motion_on(s, span.start() + i * span.step() / 2000);
        sampled[0] = std::max(sampled[0], m.velocity.norm());
        for (std::size_t axis = 0; axis < 3; ++axis)
          sampled[1 + axis] = std::max(sampled[1 + axis], std::abs(m.acceleration[static_cast<Eigen::Index>(axis)]));
      }
      for (std::size_t k = 0; k < 4; ++k)
        expect_tight((*peaks)[s][k], sampled[k], std::string(info.name) + " " + std::to_string(k));
    }
  }
  EXPECT_GE(methods, 15u);
}

TEST(RateBounds, AreUnknownWithoutPolynomials) {
  for (const std::size_t keys : {2u, 5u})
    EXPECT_FALSE(certified(make_curve("squad", random_keys(1, {keys, 1.0})).value(), {}, low_floors)) << keys;
}

}}  // namespace orispline
