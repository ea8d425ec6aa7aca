// SPDX-License-Identifier: Apache-2.0
// Curves made of curves: their rates are those of the quaternions, multiplied as power series in time.
#include <orispline/curve/composition.hpp>

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <batch/agreement.hpp>
#include <batch/specimen_curves.hpp>
#include <orispline/analysis/curve_in_stretches.hpp>
#include <orispline/batch/baked_curve.hpp>
#include <orispline/batch/pose_sampler.hpp>
#include <orispline/curve/taylor.hpp>
#include <support/near.hpp>
#include <support/tracks.hpp>

namespace orispline { namespace {

using namespace testing_support;

using Series = Quaternion<Jet<double, 3>>;

Series series_of(const Motion& m) { return taylor(m, Jet<double, 3>::variable(0.0)); }

constexpr MotionTolerance composed{1e-14, 1e-12, 1e-11, 1e-10};

/// Times in the domain, its ends and some between knots.
std::vector<double> times_of(const AnyCurve& curve) {
  std::vector<double> times{curve.domain().start};
  for (std::size_t i = 0; i < curve.knots().segments(); ++i)
    for (const double u : {0.11, 0.5, 0.93}) {
      const KnotSpan span = curve.knots().span(i);
      times.push_back(span.start() + u * span.step());
    }
  times.push_back(curve.domain().end);
  return times;
}

RateSizes sizes_of(const AnyCurve& curve) {
  RateSizes sizes;
  for (const double t : times_of(curve)) sizes.include(curve.motion(t));
  return sizes;
}

TEST(Inverse, HasTheRatesOfItsQuaternionsForEveryFamily) {
  for (const auto& [name, curve] : curve_of_every_family(301)) {
    const AnyCurve inverted = inverse_of(curve);
    for (const double t : times_of(curve))
      EXPECT_TRUE(
          near(inverted.motion(t), motion_from_jet(series_of(curve.motion(t)).conjugate()), composed, sizes_of(curve)))
          << name << " at " << t;
  }
}

TEST(Inverse, IsMadeOfPiecesForTheKernelThatAgreeWithItsMotion) {
  for (const char* const name : kinds_of_curves) {
    const AnyCurve curve = specimen_curve(name), inverted = inverse_of(curve);
    EXPECT_EQ(inverted.form(0).index(), curve.form(0).index()) << name;
    const auto times = times_of(curve);
    Sampled<double> samples(times.size(), Wanted::jerk);
    ASSERT_TRUE(sample_at<double>(inverted, times, samples.spans()));
    EXPECT_TRUE(agree(samples, inverted, times, Wanted::jerk)) << name;
  }
}

TEST(Inverse, OfTheInverseIsTheCurve) {
  const AnyCurve curve = specimen_curve("auto");
  for (const double t : times_of(curve))
    EXPECT_TRUE(near(inverse_of(inverse_of(curve)).motion(t), curve.motion(t), composed, sizes_of(curve)));
}

TEST(Product, HasTheRatesOfItsQuaternionsForEveryFamilyOnEitherSide) {
  const AnyCurve other = specimen_curve("timed-c3", 302);
  for (const auto& [name, curve] : curve_of_every_family(303))
    for (const auto& [a, b] : {std::pair{curve, other}, std::pair{other, curve}}) {
      const AnyCurve made = product_of(a, b, {.a = 0.5, .b = 0.25}).value();
      RateSizes sizes = sizes_of(a);
      for (const double t : times_of(b)) sizes.include(b.motion(t));
      for (const double t : times_of(made)) {
        const Series q = series_of(a.motion(t + 0.5)) * series_of(b.motion(t + 0.25));
        if (t + 0.5 > a.domain().end || t + 0.25 > b.domain().end || t + 0.5 < a.domain().start ||
            t + 0.25 < b.domain().start)
          continue;  // by rounding
        EXPECT_TRUE(near(made.motion(t), motion_from_jet(q), {1e-14, 1e-11, 1e-10, 1e-9}, sizes))
            << name << " at " << t;
      }
    }
}

TEST(Product, HasTheKnotsOfBothWhereBothAre) {
  const auto curve_at = [](std::vector<double> times) {
    std::vector<Eigen::Quaterniond> turns;
    for (const double t : times) turns.push_back(exp<double>(Eigen::Vector3d(0.1 * t, 0.0, 0.2)));
    return make_curve("slerp", keyframes({.times = std::move(times), .orientations = turns})).value();
  };
  const AnyCurve a = curve_at({0.0, 1.0, 2.0, 4.0}), b = curve_at({11.0, 12.5, 13.0, 20.0});
  const auto knots = [](const AnyCurve& curve) {
    const auto times = curve.knots().times();
    return std::vector(times.begin(), times.end());
  };
  EXPECT_EQ(knots(product_of(a, b, {.b = 10.0}).value()), (std::vector{1.0, 2.0, 2.5, 3.0, 4.0}));
  EXPECT_EQ(knots(product_of(a, b, {.a = -7.0}).value()), (std::vector{11.0}));
  const auto none = product_of(a, b);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message,
            "found a curve from 0 to 4 s and one from 11 to 20 s, wanted two curves with a time in common");
}

PoseSampler sampler_of(const AnyCurve& curve) { return PoseSampler(PoseCurve{curve}); }

TEST(Product, SamplesAreThoseOfItsMotion) {
  for (const char* const name : kinds_of_curves) {
    const AnyCurve a = specimen_curve(name, 304, 120), b = specimen_curve("least", 305, 90);
    const PoseSampler sampler = PoseSampler::product(sampler_of(a), sampler_of(b), {.b = 0.5}).value();
    const AnyCurve& curve = sampler.curve().orientation;
    const auto times = times_of(curve);
    for (const Wanted wanted : {Wanted::orientation, Wanted::velocity, Wanted::acceleration, Wanted::jerk}) {
      Sampled<double> samples(times.size(), wanted);
      ASSERT_TRUE(sampler.sample_at<double>(times, samples.spans()));
      EXPECT_TRUE(agree(samples, curve, times, wanted)) << name;
      Sampled<double> by_many(times.size(), wanted);
      ASSERT_TRUE(
          sampler.sample_at<double>(times, by_many.spans(), Extrapolation::hold, RateFrame::body, {.threads = 3}));
      EXPECT_TRUE(by_many.same_bits(samples)) << name;
    }
  }
}

TEST(Product, HoldsItsEndsAndIsNothingAtNoTime) {
  const AnyCurve a = specimen_curve("auto", 306), b = specimen_curve("timed-c2", 307);
  const PoseSampler sampler = PoseSampler::product(sampler_of(a), sampler_of(b)).value();
  const Domain domain = sampler.curve().orientation.domain();
  const std::vector times{domain.start - 1.0, domain.start, domain.end, domain.end + 5.0,
                          std::numeric_limits<double>::quiet_NaN()};
  Sampled<double> samples(times.size(), Wanted::jerk);
  ASSERT_TRUE(sampler.sample_at<double>(times, samples.spans()));
  EXPECT_EQ(samples.orientation(0), samples.orientation(1));
  EXPECT_EQ(samples.orientation(3), samples.orientation(2));
  EXPECT_TRUE(samples.velocity(0).isZero() && samples.jerk(3).isZero());
  EXPECT_GT(samples.velocity(1).norm(), 0.01);
  EXPECT_GT(samples.velocity(2).norm(), 0.01);
  EXPECT_TRUE(samples.orientation(4).hasNaN() && samples.velocity(4).hasNaN());
  EXPECT_FALSE(sampler.sample_at<double>(times, samples.spans(), Extrapolation::error));
}

TEST(Product, OfManyCurvesTakesLittleOfTheStack) {
  const AnyCurve curve = specimen_curve("slerp", 309);
  PoseSampler sampler = sampler_of(curve);
  for (int i = 0; i < 1000; ++i) sampler = PoseSampler::product(sampler, sampler_of(curve)).value();
  const std::vector times{curve.domain().start, curve.domain().end};
  Sampled<double> samples(times.size(), Wanted::jerk);
  ASSERT_TRUE(sampler.sample_at<double>(times, samples.spans(), Extrapolation::hold, RateFrame::body, {.threads = 2}));
  EXPECT_FALSE(samples.jerk(1).hasNaN());
}

/// Slerps that break off twice: a gap from 0.3 to 0.7 s, and a jump at 0.9 s.
AnyCurve broken_curve() {
  KeyframeData data{.times = {0.0, 0.1, 0.2, 0.3, 0.7, 0.8, 0.9, 0.9, 1.0, 1.1}, .jumps = true};
  for (std::size_t i = 0; i < data.times.size(); ++i)
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0.3 * static_cast<double>(i), 0.0, 0.2)));
  return curve_beside_gaps("slerp", keyframes(std::move(data)), 0.3).value().orientation;
}

TEST(Product, HasItsBreaksWhereItsFactorsHaveThemOnEveryClock) {
  const AnyCurve broken = broken_curve(), other = specimen_curve("auto", 308);
  const double start = other.domain().start;
  for (int k = 0; k < 200; ++k) {
    const double offset = 0.0137 * k - 1.7e5, of_other = start + offset;
    const PoseSampler sampler =
        PoseSampler::product(sampler_of(broken), sampler_of(other), {.a = offset, .b = of_other}).value();
    const AnyCurve& made = sampler.curve().orientation;
    const std::vector times{0.3 - offset, 0.7 - offset, 0.9 - offset};
    Sampled<double> samples(times.size(), Wanted::orientation);
    ASSERT_TRUE(sampler.sample_at<double>(times, samples.spans()));
    const std::array own{0.3, 0.7, 0.9};
    for (std::size_t i = 0; i < own.size(); ++i) {
      const Eigen::Quaterniond wanted = broken(own[i]) * other(own[i] + start);
      EXPECT_LT(angular_distance(made(times[i]), wanted), 1e-8) << k << " " << i;
      EXPECT_LT(angular_distance(Eigen::Quaterniond(samples.orientation(i)), wanted), 1e-8) << k << " " << i;
    }
    const Eigen::Quaterniond before = broken.motion(0.9, Side::left).orientation * other(0.9 + start);
    EXPECT_LT(angular_distance(made.motion(times[2], Side::left).orientation, before), 1e-8) << k;
  }
}

TEST(Product, IsNotBakedOverABreak) {
  const AnyCurve broken = broken_curve(), other = specimen_curve("auto", 308);
  const auto gap = bake<double>(product_of(other, broken, {.a = other.domain().start}).value(), 1e-6);
  ASSERT_FALSE(gap);
  EXPECT_EQ(gap.error().message.substr(0, 18), "found a gap from 0");
  const Keyframes keys = keyframes(
      {.times = {0.0, 1.0, 1.0, 2.0}, .orientations = std::vector(4, Eigen::Quaterniond::Identity()), .jumps = true});
  const auto jump = bake<double>(curve_beside_gaps("slerp", keys, std::nullopt).value().orientation, 1e-6);
  ASSERT_FALSE(jump);
  EXPECT_EQ(jump.error().message, "found a jump of the motion at 1 s, wanted one curve without a break");
}

}}  // namespace orispline
