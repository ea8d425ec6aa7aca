// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <random>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/reduce/cubic_keys.hpp>
#include <orispline/reduce/hermite_keys.hpp>
#include <orispline/reduce/hermite_span.hpp>
#include <reduce/recorded_walk.hpp>

namespace orispline { namespace {

using testing_support::degree;
using testing_support::Walk;

/// Keys of `hermite-c1` at uneven times, with rates; each step turns by 140° at most.
Keyframes rated_keys(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto vector = [&] { return Eigen::Vector3d(any(random), any(random), any(random)); };
  KeyframeData data;
  Eigen::Quaterniond at = exp<double>(vector());
  for (std::size_t i = 0; i < count; ++i) {
    data.times.push_back(0.4 * static_cast<double>(i) + 0.1 * any(random));
    data.orientations.push_back(at = (at * exp<double>(Eigen::Vector3d(1.4 * vector()))).normalized());
    data.angular_velocities.emplace_back(4.0 * vector());
  }
  return Keyframes::make(std::move(data)).value();
}

/// So many samples, and `stride` targets to each, between two keys in a row of a curve.
CubicSamples<Eigen::Quaterniond> samples_of(const AnyCurve& curve, std::size_t each, std::size_t stride) {
  CubicSamples<Eigen::Quaterniond> samples{.stride = stride};
  auto& [times, points] = samples.targets;
  const auto knots = curve.knots().times();
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    for (std::size_t k = i == 0 ? 0 : 1; k <= each * stride; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(each * stride);
      times.push_back(k == each * stride ? knots[i + 1] : knots[i] + share * (knots[i + 1] - knots[i]));
      Eigen::Vector4d point = curve(times.back()).coeffs();
      if (!points.empty() && point.dot(points.back()) < 0.0) point = -point;
      points.push_back(point);
    }
  return samples;
}

AnyCurve hermite(const Keyframes& keys) { return make_curve("hermite-c1", keys).value(); }

AnyCurve curve_of(const CubicSamples<Eigen::Quaterniond>& samples, const HermiteKeys& found) {
  KeyframeData data{.angular_velocities = found.rates};
  for (const std::size_t sample : found.samples) {
    data.times.push_back(samples.targets.times[sample * samples.stride]);
    data.orientations.emplace_back(samples.targets.points[sample * samples.stride]);
  }
  return hermite(Keyframes::make(std::move(data)).value());
}

TEST(HermiteKeys, TheRatesOfACurveAreFoundFromItsPoints) {
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    const Keyframes keys = rated_keys(6, seed);
    const auto samples = samples_of(hermite(keys), 10, 1);
    std::vector<HermiteSpan<Eigen::Quaterniond>> spans;
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) spans.emplace_back(samples.targets, 10 * i, 10 * (i + 1), true);
    std::vector<HermiteSpan<Eigen::Quaterniond>*> row;
    row.reserve(spans.size());
    for (auto& span : spans) row.push_back(&span);
    std::vector<Eigen::Vector3d> rates(keys.size(), Eigen::Vector3d::Zero());
    fit_rates<Eigen::Quaterniond>(row, rates, {.first = true, .last = true});
    for (std::size_t i = 0; i < keys.size(); ++i)
      EXPECT_LT((rates[i] - keys.angular_velocities()[i]).norm(), 1e-9) << "seed " << seed << ", key " << i;
    rates.assign(keys.size(), Eigen::Vector3d::Zero());  // the ends are given now
    rates.front() = keys.angular_velocities().front();
    rates.back() = keys.angular_velocities().back();
    fit_rates<Eigen::Quaterniond>(row, rates, {});
    EXPECT_LT((rates[2] - keys.angular_velocities()[2]).norm(), 1e-9);
  }
}

TEST(HermiteKeys, AMissIsTheAngleToTheCurve) {
  const Keyframes keys = rated_keys(2, 7);
  auto samples = samples_of(hermite(keys), 8, 1);
  Eigen::Quaterniond moved(samples.targets.points[3]);
  samples.targets.points[3] = (moved * exp<double>(Eigen::Vector3d(1e-3, -2e-3, 2e-3))).coeffs();  // by 3 mrad
  HermiteSpan<Eigen::Quaterniond> span(samples.targets, 0, 8, true);
  const auto& rates = keys.angular_velocities();
  EXPECT_NEAR(2.0 * std::sqrt(span.measure(rates[0], rates[1])), 3e-3, 1e-8);
  const double bound = std::sin(0.5 * 3e-3);
  EXPECT_TRUE(span.holds(rates[0], rates[1], std::pow(bound * (1.0 + 1e-9), 2)));
  EXPECT_FALSE(span.holds(rates[0], rates[1], std::pow(bound * (1.0 - 1e-9), 2)));
}

TEST(HermiteKeys, NoMoreAreFoundThanACurveHas) {
  for (const unsigned seed : {5u, 6u, 7u}) {
    const Keyframes keys = rated_keys(9, seed);
    const auto samples = samples_of(hermite(keys), 12, 4);
    const HermiteKeys found = fewest_hermite_keys(samples, 1e-7);
    EXPECT_LE(found.samples.size(), keys.size()) << "seed " << seed;
  }
}

TEST(HermiteKeys, AllTargetsBetweenKeysThatAreNotNeighboursAreHeld) {
  for (const double tolerance : {0.05 * degree, 0.5 * degree, 3.0 * degree}) {
    const Keyframes walk = testing_support::recorded({.samples = 300, .step = 0.2, .noise = 2e-3, .shift = 0.0}, 11);
    const RotationChannel channel{.times = {walk.times().begin(), walk.times().end()},
                                  .values = {walk.orientations().begin(), walk.orientations().end()}};
    const auto samples = cubic_samples(channel, BetweenSamples::smooth);
    const HermiteKeys found = fewest_hermite_keys(samples, tolerance);
    ASSERT_EQ(found.samples.size(), found.rates.size());
    EXPECT_EQ(found.samples.front(), 0u);
    EXPECT_EQ(found.samples.back(), 299u);
    const AnyCurve curve = curve_of(samples, found);
    for (std::size_t k = 0; k + 1 < found.samples.size(); ++k) {
      const std::size_t i = found.samples[k], j = found.samples[k + 1];
      ASSERT_LT(i, j);
      if (j == i + 1) continue;
      for (std::size_t at = i * samples.stride; at <= j * samples.stride; ++at)
        EXPECT_LE(angular_distance(curve(samples.targets.times[at]), Eigen::Quaterniond(samples.targets.points[at])),
                  tolerance + 1e-12);
    }
  }
}

/// Smooth but for the targets between two neighbouring samples, which are wild.
CubicSamples<Eigen::Quaterniond> wild_between(std::size_t sample, double wild, unsigned seed) {
  constexpr std::size_t count = 41, stride = 4;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-wild, wild);
  CubicSamples<Eigen::Quaterniond> samples{.stride = stride};
  auto& [times, points] = samples.targets;
  for (std::size_t k = 0; k <= (count - 1) * stride; ++k) {
    const double t = 0.1 * static_cast<double>(k) / stride;
    times.push_back(t);
    Eigen::Quaterniond q = exp<double>(Eigen::Vector3d(std::sin(2.0 * t), std::cos(3.0 * t), 0.1 * t * t));
    if (k / stride == sample && k % stride != 0)
      q = q * exp<double>(Eigen::Vector3d(any(random), any(random), any(random)));
    points.push_back(q.coeffs());
    if (k > 0 && points[k].dot(points[k - 1]) < 0.0) points[k] = -points[k];
  }
  return samples;
}

TEST(HermiteKeys, TheNeighbouringSampleIsAKeyWhereNothingHoldsTheTargetsBetween) {
  for (std::size_t sample = 20; sample < 40; ++sample)
    for (const double tolerance : {0.05 * degree, 0.5 * degree})
      for (const bool closed : {false, true}) {
        SCOPED_TRACE(testing::Message() << "sample " << sample << ", tolerance " << tolerance << ", closed " << closed);
        const auto samples = wild_between(sample, sample % 2 == 0 ? 1.0 : 0.1, static_cast<unsigned>(sample));
        const auto seam = closed ? std::optional(Eigen::Vector3d(1.0, -0.5, 0.3)) : std::nullopt;
        const HermiteKeys found = fewest_hermite_keys(samples, tolerance, {.first = seam, .last = seam});
        EXPECT_LT(found.samples.size(), samples.size() * 2 / 3);
        if (closed) {
          EXPECT_EQ(found.rates.front(), *seam);
          EXPECT_EQ(found.rates.back(), *seam);
        }
        const auto key = std::ranges::find(found.samples, sample);
        ASSERT_TRUE(key != found.samples.end() && *(key + 1) == sample + 1);
        if (!closed && sample + 2 == samples.size()) {  // then the last rate is the best one for these targets
          HermiteSpan<Eigen::Quaterniond> span(samples.targets, sample * samples.stride, (sample + 1) * samples.stride,
                                               false);
          const std::array<HermiteSpan<Eigen::Quaterniond>*, 1> row{&span};
          std::array<Eigen::Vector3d, 2> best{found.rates.rbegin()[1], Eigen::Vector3d::Zero()};
          fit_rates<Eigen::Quaterniond>(row, best, {.last = true});
          EXPECT_LT((found.rates.back() - best[1]).norm(), 1e-9 * best[1].norm());
        }
        const AnyCurve curve = curve_of(samples, found);
        for (std::size_t k = 0; k + 1 < found.samples.size(); ++k) {
          const std::size_t i = found.samples[k], j = found.samples[k + 1];
          if (j == i + 1) continue;
          for (std::size_t at = i * samples.stride; at <= j * samples.stride; ++at)
            EXPECT_LE(
                angular_distance(curve(samples.targets.times[at]), Eigen::Quaterniond(samples.targets.points[at])),
                tolerance + 1e-12);
        }
      }
}

TEST(HermiteKeys, NoStepIsNearAHalfTurn) {
  RotationChannel spin;  // at a constant rate, which one piece would hold for ever
  for (int i = 0; i < 200; ++i) {
    spin.times.push_back(0.1 * i);
    spin.values.emplace_back(exp<double>(Eigen::Vector3d(0.0, 0.0, 0.2 * i)));
  }
  const auto samples = cubic_samples(spin, BetweenSamples::smooth);
  const HermiteKeys found = fewest_hermite_keys(samples, 0.1 * degree);
  for (std::size_t k = 0; k + 1 < found.samples.size(); ++k)
    EXPECT_LT(0.2 * static_cast<double>(found.samples[k + 1] - found.samples[k]), 178 * degree);
  EXPECT_LE(found.samples.size(), 16u) << "15 steps of 2.8 rad";
}

TEST(HermiteKeys, BothEndsHaveTheRateOfTheSeam) {
  RotationChannel swing;
  for (int i = 0; i <= 120; ++i) {
    const double phase = 2.0 * std::numbers::pi * i / 120.0;
    swing.times.push_back(i / 30.0);
    swing.values.emplace_back(
        exp<double>(Eigen::Vector3d(std::sin(phase), 0.5 * std::cos(2 * phase), std::cos(phase))));
  }
  const auto samples = cubic_samples(swing, BetweenSamples::smooth);
  const Eigen::Vector3d seam = rate_at_seam(samples.targets);
  const HermiteKeys found = fewest_hermite_keys(samples, 0.2 * degree, {.first = seam, .last = seam}),
                    open = fewest_hermite_keys(samples, 0.2 * degree);
  EXPECT_EQ(found.rates.front(), seam);
  EXPECT_EQ(found.rates.back(), seam);
  EXPECT_LE(found.samples.size(), open.samples.size() + 2);
  const AnyCurve curve = curve_of(samples, found);
  for (std::size_t at = 0; at < samples.targets.times.size(); ++at)
    EXPECT_LE(angular_distance(curve(samples.targets.times[at]), Eigen::Quaterniond(samples.targets.points[at])),
              0.2 * degree + 1e-12);
}

TEST(HermiteKeys, OfPositionsAreHeldAsWell) {
  VectorChannel path;
  for (int i = 0; i < 150; ++i) {
    const double t = i / 30.0;
    path.times.push_back(t);
    path.values.emplace_back(std::sin(2 * t), t * t, std::cos(3 * t));
  }
  const auto channel = hermite_channel(cubic_samples(path, BetweenSamples::smooth), 1e-3, "hermite-c1");
  ASSERT_TRUE(channel);
  EXPECT_LT(channel->size(), 30u);
  for (std::size_t k = 1; k + 1 < channel->size(); ++k) EXPECT_EQ(channel->in_tangents[k], channel->out_tangents[k]);
  const ChannelCurve<Eigen::Vector3d> curve(*channel);
  for (std::size_t i = 0; i < path.size(); ++i) EXPECT_LE((curve.at(path.times[i]) - path.values[i]).norm(), 1e-3);
}

TEST(Reduce, SeeksTheRatesOfHermiteKeys) {
  const Walk walk{.samples = 400, .step = 0.1, .noise = 1e-3, .shift = 0.0};
  const Keyframes recording = testing_support::recorded(walk, 3);
  const ReduceOptions options{.tolerance = {.angle = 0.5 * degree}};
  const Reduction found = testing_support::reduced("hermite-c1", recording, options);
  EXPECT_EQ(found.track.keys.angular_velocities().size(), found.track.keys.size());
  EXPECT_LE(found.deviation.angle, 0.5 * degree);
  EXPECT_LT(found.track.keys.size(), testing_support::reduced("auto", recording, options).track.keys.size());
  const AnyCurve curve = make_curve("hermite-c1", found.track.keys).value();
  for (std::size_t i = 0; i < recording.size(); ++i)
    EXPECT_LE(angular_distance(curve(recording.times()[i]), recording.orientations()[i]), 0.5 * degree);
}

TEST(Reduce, HermiteKeysHaveNoRatesWhereTheseCannotBeSought) {
  const Keyframes recording = testing_support::recorded({.samples = 120, .step = 0.1, .noise = 1e-3, .shift = 0.1}, 4);
  const ReduceOptions moved{.tolerance = {.angle = 1.0 * degree}, .values = KeyValues::refitted};
  EXPECT_TRUE(testing_support::reduced("hermite-c1", recording, moved).track.keys.angular_velocities().empty());
  const ReduceOptions bounded{.tolerance = {.angle = 1.0 * degree, .position = 0.05}};
  EXPECT_TRUE(testing_support::reduced("hermite-c1", recording, bounded).track.keys.angular_velocities().empty());
  const auto product = reduce(recording, Method("hermite-c1", {.choices = {{"form", "cumulative"}}}),
                              {.tolerance = {.angle = 1.0 * degree}});
  ASSERT_TRUE(product);
  EXPECT_TRUE(product->track.keys.angular_velocities().empty());
}

TEST(Reduce, StopsWhileItSeeksRates) {
  std::stop_source source;
  source.request_stop();
  const Keyframes recording = testing_support::recorded({.samples = 100, .step = 0.1, .noise = 1e-3, .shift = 0.0}, 4);
  const auto found =
      reduce(recording, "hermite-c1", {.tolerance = {.angle = 1.0 * degree}}, {.stop = source.get_token()});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::cancelled);
}

}}  // namespace orispline
