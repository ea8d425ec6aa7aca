// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/reduce/cubic_keys.hpp>
#include <reduce/recorded_walk.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using testing_support::degree;

Eigen::Quaterniond about_x(double angle) { return {std::cos(angle / 2), std::sin(angle / 2), 0.0, 0.0}; }

/// dq/dt at q for a rate of the body [rad/s].
Eigen::Quaterniond tangent(const Eigen::Quaterniond& q, const Eigen::Vector3d& rate) {
  return q * Eigen::Quaterniond(0.0, rate.x() / 2, rate.y() / 2, rate.z() / 2);
}

/// One cubic of 1.6 s between orientations 80° apart.
RotationChannel one_cubic() {
  const Eigen::Quaterniond start = about_x(0.3), end = start * exp<double>(Eigen::Vector3d(0.0, 80 * degree, 0.0));
  const Eigen::Quaterniond none(0, 0, 0, 0);
  return {.interpolation = ChannelInterpolation::cubicspline,
          .times = {0.4, 2.0},
          .values = {start, end},
          .in_tangents = {none, tangent(end, {0.2, 1.2, -0.4})},
          .out_tangents = {tangent(start, {0.3, 0.5, 0.2}), none}};
}

/// Samples of a channel at even times, joined by geodesics, with any signs.
template <CurvePoint P>
Channel<P> sampled(const Channel<P>& channel, std::size_t count) {
  const ChannelCurve<P> curve(channel);
  const double start = channel.times.front(), step = (channel.times.back() - start) / static_cast<double>(count - 1);
  Channel<P> samples;
  for (std::size_t i = 0; i < count; ++i) {
    samples.times.push_back(i + 1 == count ? channel.times.back() : start + step * static_cast<double>(i));
    P value = curve.at(samples.times.back());
    if constexpr (std::same_as<P, Eigen::Quaterniond>)
      if (i % 3 == 1) value.coeffs() *= -1.0;
    samples.values.push_back(value);
  }
  return samples;
}

/// Every sample is a target, and none else.
template <CurvePoint P>
CubicSamples<P> only_samples(const Channel<P>& channel) {
  CubicSamples<P> samples{.stride = 1};
  const CubicSamples<P> all = cubic_samples(channel, BetweenSamples::stored);
  for (std::size_t i = 0; i < all.targets.times.size(); i += all.stride) {
    samples.targets.times.push_back(all.targets.times[i]);
    samples.targets.points.push_back(all.targets.points[i]);
  }
  return samples;
}

double farthest(const CubicTargets<Eigen::Quaterniond>& targets, const RotationChannel& channel) {
  const ChannelCurve<Eigen::Quaterniond> curve(channel);
  double farthest = 0.0;
  for (std::size_t i = 0; i < targets.times.size(); ++i)
    farthest = std::max(farthest, angular_distance(Eigen::Quaterniond(targets.points[i]), curve.at(targets.times[i])));
  return farthest;
}

/// A walk about ever new axes, as geodesics.
RotationChannel walk(std::uint64_t seed, std::size_t count, double largest_step) {
  const KeyframeData data = testing_support::random_walk(seed, count, testing_support::Spacing::uneven, largest_step);
  return {.times = data.times, .values = data.orientations};
}

TEST(CubicSpan, OfSamplesOfOneCubicIsThatCubic) {
  const RotationChannel cubic = one_cubic();
  const RotationChannel found = fewest_cubics(only_samples(sampled(cubic, 41)), 0.01 * degree);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found.times, cubic.times);
  const ChannelCurve<Eigen::Quaterniond> wanted(cubic), curve(found);
  for (double t = 0.4; t <= 2.0; t += 0.0123)
    EXPECT_LT(angular_distance(wanted.at(t), curve.at(t)), 0.0105 * degree) << t;
}

TEST(CubicSpan, IsFoundWhereThePolynomialIsFarFromUnitQuaternions) {
  RotationChannel cubic = one_cubic();
  cubic.out_tangents[0].coeffs() += 0.3 * cubic.values[0].coeffs();
  cubic.in_tangents[1].coeffs() += 0.2 * cubic.values[1].coeffs();
  const RotationChannel found = fewest_cubics(only_samples(sampled(cubic, 41)), 0.08 * degree);
  EXPECT_EQ(found.size(), 2u);
}

TEST(CubicSpan, OfPositionsOfOneCubicIsThatCubic) {
  const VectorChannel cubic{.interpolation = ChannelInterpolation::cubicspline,
                            .times = {0.0, 3.0},
                            .values = {{0, 0, 0}, {1, 2, 3}},
                            .in_tangents = {{0, 0, 0}, {1, -1, 4}},
                            .out_tangents = {{2, 0, -1}, {0, 0, 0}}};
  const VectorChannel found = fewest_cubics(only_samples(sampled(cubic, 30)), 1e-9);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_LT((found.out_tangents[0] - cubic.out_tangents[0]).norm(), 1e-12);
  EXPECT_LT((found.in_tangents[1] - cubic.in_tangents[1]).norm(), 1e-12);
}

TEST(CubicSpan, OfTwoCubicsHasItsKeyWhereTheyMeet) {
  RotationChannel cubics = one_cubic();
  const Eigen::Quaterniond middle = cubics.values[1], end = middle * about_x(1.4);
  cubics.times.push_back(3.6);
  cubics.values.push_back(end);
  cubics.out_tangents[1] = tangent(middle, {1.1, 0.4, -0.3});
  cubics.in_tangents.push_back(tangent(end, {0.6, 0.0, 0.2}));
  cubics.out_tangents.emplace_back(0, 0, 0, 0);
  const RotationChannel found = fewest_cubics(only_samples(sampled(cubics, 81)), 0.01 * degree);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_NEAR(found.times[1], 2.0, 1e-12);
  EXPECT_GT((found.in_tangents[1].coeffs() - found.out_tangents[1].coeffs()).norm(), 0.5);
}

TEST(CubicSpan, HoldsTheToleranceOfEveryTargetAndKeepsTheSigns) {
  for (const double tolerance : {0.05 * degree, 1.0 * degree, 10.0 * degree})
    for (const auto between : {BetweenSamples::smooth, BetweenSamples::stored}) {
      const RotationChannel channel = walk(3, 200, 0.4);
      const auto samples = cubic_samples(channel, between);
      const RotationChannel found = fewest_cubics(samples, tolerance);
      EXPECT_EQ(found.times.front(), channel.times.front());
      EXPECT_EQ(found.times.back(), channel.times.back());
      CubicTargets<Eigen::Quaterniond> keys;
      for (std::size_t i = 0; i < samples.targets.times.size(); i += samples.stride) {
        keys.times.push_back(samples.targets.times[i]);
        keys.points.push_back(samples.targets.points[i]);
      }
      EXPECT_LE(farthest(keys, found), tolerance * (1.0 + 1e-9));
      for (std::size_t i = 1; i < found.size(); ++i) EXPECT_GE(found.values[i].dot(found.values[i - 1]), 0.0);
    }
}

TEST(CubicSpan, BetweenSamplesAlsoHoldsWhereItSpansSeveral) {
  const RotationChannel channel = walk(5, 150, 0.1);
  const auto samples = cubic_samples(channel, BetweenSamples::smooth);
  const double tolerance = 2.0 * degree;
  const RotationChannel found = fewest_cubics(samples, tolerance);
  EXPECT_LT(found.size(), channel.size() / 2);
  const ChannelCurve<Eigen::Quaterniond> curve(found);
  for (std::size_t i = 0; i < samples.targets.times.size(); ++i) {
    const double t = samples.targets.times[i];
    const std::size_t segment = curve.knots().segment_at(t);
    const auto inside = std::ranges::count_if(
        channel.times, [&](double time) { return time > found.times[segment] && time < found.times[segment + 1]; });
    if (inside == 0) continue;
    EXPECT_LE(angular_distance(Eigen::Quaterniond(samples.targets.points[i]), curve.at(t)), tolerance * (1.0 + 1e-9))
        << t;
  }
}

TEST(CubicSpan, OfASpinTurnsByHalfATurnAtMost) {
  RotationChannel spin;
  for (int i = 0; i <= 144; ++i) {
    spin.times.push_back(i / 30.0);
    spin.values.push_back(about_x(i * 10.0 * degree));  // four turns
  }
  const RotationChannel found = fewest_cubics(cubic_samples(spin, BetweenSamples::smooth), 0.5 * degree);
  EXPECT_GE(found.size(), 9u);
  EXPECT_LE(found.size(), 20u);
  const ChannelCurve<Eigen::Quaterniond> curve(found);
  for (std::size_t i = 1; i < found.size(); ++i) {
    EXPECT_GE(found.values[i].dot(found.values[i - 1]), 0.0) << i;
    EXPECT_LE(found.times[i] - found.times[i - 1], 18.001 / 30.0) << i;
  }
  for (std::size_t i = 0; i < spin.size(); ++i)
    EXPECT_LE(angular_distance(curve.at(spin.times[i]), spin.values[i]), 0.5 * degree);
}

TEST(CubicSpan, OfTwoSamplesIsTheChordBetweenThem) {
  const RotationChannel two{.times = {0.0, 2.0}, .values = {about_x(0.0), about_x(1.0)}};
  const RotationChannel found = fewest_cubics(only_samples(two), 0.01);
  ASSERT_EQ(found.size(), 2u);
  const Eigen::Vector4d rate = 0.5 * (about_x(1.0).coeffs() - about_x(0.0).coeffs());
  EXPECT_LT((found.out_tangents[0].coeffs() - rate).norm(), 1e-15);
  EXPECT_LT((found.in_tangents[1].coeffs() - rate).norm(), 1e-15);
}

TEST(CubicSpan, OfThreeSamplesPassesTheOneBetween) {
  const VectorChannel three{.times = {0.0, 1.0, 3.0}, .values = {{0, 0, 0}, {1, 5, 0}, {2, 0, 1}}};
  const VectorChannel found = fewest_cubics(only_samples(three), 1e-9);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_LT((ChannelCurve<Eigen::Vector3d>(found).at(1.0) - Eigen::Vector3d(1, 5, 0)).norm(), 1e-12);
}

TEST(CubicSamples, LieOnTheCurveThatIsAskedFor) {
  const RotationChannel channel = walk(11, 20, 0.6);
  const ChannelCurve<Eigen::Quaterniond> stored(channel);
  const auto of_stored = cubic_samples(channel, BetweenSamples::stored);
  const auto of_smooth = cubic_samples(channel, BetweenSamples::smooth);
  ASSERT_EQ(of_stored.targets.times.size(), 19u * of_stored.stride + 1);
  EXPECT_EQ(of_stored.size(), channel.size());
  EXPECT_LT(farthest(of_stored.targets, channel), 1e-14);
  EXPECT_GT(farthest(of_smooth.targets, channel), 1.0 * degree);
  for (std::size_t i = 1; i < of_smooth.targets.points.size(); ++i)
    EXPECT_GT(of_smooth.targets.points[i].dot(of_smooth.targets.points[i - 1]), 0.0);
  // A cubicspline is its own motion in any case.
  EXPECT_LT(farthest(cubic_samples(one_cubic(), BetweenSamples::smooth).targets, one_cubic()), 1e-14);
}

}}  // namespace orispline
