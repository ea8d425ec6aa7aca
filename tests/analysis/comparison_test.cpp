// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/comparison.hpp>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <orispline/analysis/curve_measures.hpp>
#include <orispline/analysis/decimation.hpp>
#include <orispline/analysis/key_statistics.hpp>
#include <orispline/families/motion_band.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/geodesic.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using testing_support::about_x;

/// The angle t³ about x at 41 times from 0 to 2 s, with its rate.
struct Motions {
  std::vector<double> times;
  std::vector<Eigen::Quaterniond> orientations;
  std::vector<Eigen::Vector3d> rates;

  [[nodiscard]] RecordedMotion recording() const { return {times, orientations, rates}; }
  [[nodiscard]] Keyframes every(std::size_t step) const {
    KeyframeData data;
    for (std::size_t i = 0; i < times.size(); i += step) {
      data.times.push_back(times[i]);
      data.orientations.push_back(orientations[i]);
    }
    return Keyframes::make(std::move(data)).value();
  }
};

Motions cubic_motion() {
  Motions m;
  for (int i = 0; i <= 40; ++i) {
    const double t = 0.05 * i;
    m.times.push_back(t);
    m.orientations.push_back(about_x(t * t * t / 4.0));
    m.rates.emplace_back(0.75 * t * t, 0.0, 0.0);
  }
  return m;
}

TEST(Comparison, OfACandidateWithoutKeysSaysSo) {
  const Candidate none{};
  EXPECT_EQ(none.keys.size(), 0u);
  const auto measures = measure(none, {});
  ASSERT_FALSE(measures);
  EXPECT_EQ(measures.error().message, "empty: no keys");
  EXPECT_EQ(key_statistics(none.keys).span, 0.0);
  EXPECT_FALSE(leave_out_error(none.keys));
}

TEST(Measure, TellsTheShareInsideTheBandOfAMethodThatHasOne) {
  Motions motion = cubic_motion();
  for (std::size_t i = 0; i < motion.times.size(); ++i)  // too fast for the keys
    motion.orientations[i] = about_x(0.3 * std::sin(17.0 * motion.times[i]));
  const Keyframes keys = motion.every(2);
  const auto banded = measure({.method = "measured", .keys = keys}, motion.recording());
  ASSERT_TRUE(banded && banded->inside_band);
  const MotionBand band = MotionBand::make("measured", keys, 0.9).value();
  const AnyCurve curve = make_curve("measured", keys).value();
  int inside = 0;
  for (std::size_t i = 0; i < motion.times.size(); ++i)
    inside += angular_distance(curve(motion.times[i]), motion.orientations[i]) <= band(motion.times[i]) + 1e-12 ? 1 : 0;
  EXPECT_EQ(*banded->inside_band, inside / 41.0);
  EXPECT_GT(inside, 21);
  EXPECT_FALSE(measure({.method = "auto", .keys = keys}, motion.recording())->inside_band);
}

TEST(Measure, FindsAMethodThatReproducesTheMotionWithoutError) {
  const Motions motion = cubic_motion();
  const auto measures = measure({.method = "auto", .keys = motion.every(4)}, motion.recording());
  ASSERT_TRUE(measures) << describe(measures.error());
  EXPECT_EQ(measures->distance.count, 41u);
  EXPECT_LT(measures->distance.largest, 1e-12);
  ASSERT_TRUE(measures->rate_error);
  EXPECT_LT(measures->rate_error->largest, 1e-11);
  EXPECT_NEAR(measures->energies.acceleration, 2.25 * 8.0 / 3.0, 1e-9);  // ∫ (1.5 t)² dt
  EXPECT_NEAR(measures->peaks.angular_velocity.value, 3.0, 1e-10);
  EXPECT_NEAR(measures->angle_travelled, 2.0, 1e-10);
  EXPECT_GE(measures->seconds, measures->build_seconds);
}

TEST(Measure, CountsOnlyWhatLiesBetweenTheKeysAndTheKeysThemselves) {
  const Motions motion = cubic_motion();
  KeyframeData data{.times = {0.5, 1.0}, .orientations = {motion.orientations[10], motion.orientations[20]}};
  const auto measures =
      measure({.method = "slerp", .keys = Keyframes::make(std::move(data)).value()}, motion.recording());
  EXPECT_EQ(measures->distance.count, 11u);
  const double largest = measures->distance.largest;
  EXPECT_NEAR(largest,
              angular_distance(motion.orientations[measures->distance.largest_at],
                               slerp<double>(motion.orientations[10], motion.orientations[20],
                                             (motion.times[measures->distance.largest_at] - 0.5) / 0.5)),
              1e-14);
}

TEST(Measure, RefusesAReferenceThatDoesNotOverlap) {
  const Motions motion = cubic_motion();
  KeyframeData data{.times = {5.0, 6.0}, .orientations = {about_x(0.0), about_x(1.0)}};
  const auto measures =
      measure({.method = "slerp", .keys = Keyframes::make(std::move(data)).value()}, motion.recording());
  ASSERT_FALSE(measures);
  EXPECT_EQ(measures.error().message, "none of the 41 reference times lies between the keys, 5 to 6 s");
}

TEST(Compare, GoesOnAfterAMethodThatFailsAndGivesTheSameOnAnyNumberOfThreads) {
  const Motions motion = cubic_motion();
  std::vector<Candidate> candidates;
  for (const char* method : {"slerp", "no-such-method", "auto", "timed-c2"})
    candidates.push_back({.method = method, .keys = motion.every(8)});
  std::vector<double> shares;
  const Comparison one = compare(candidates, motion.recording());
  const Comparison four =
      compare(candidates, motion.recording(), {}, 4, {.show = [&](double share) { shares.push_back(share); }});
  EXPECT_TRUE(one.any());
  ASSERT_FALSE(one.measures[1]);
  EXPECT_EQ(one.measures[1].error().code, ErrorCode::bad_argument);
  for (const std::size_t i : {0u, 2u, 3u}) {
    ASSERT_TRUE(one.measures[i] && four.measures[i]);
    EXPECT_EQ(one.measures[i]->distance.rms, four.measures[i]->distance.rms);
    EXPECT_EQ(one.measures[i]->energies.jerk, four.measures[i]->energies.jerk);
  }
  EXPECT_EQ(shares, (std::vector{0.25, 0.5, 0.75, 1.0}));
}

TEST(Compare, FindsTheLeastEnergyOfEachTrackWhateverTheMethodsAndRatesOfItsKeys) {
  const Motions motion = cubic_motion();
  KeyframeData with_rates{.times = {0.0, 1.0, 2.0},
                          .orientations = {about_x(0.0), about_x(0.25), about_x(2.0)},
                          .angular_velocities = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};
  const std::vector<Candidate> candidates{{.method = "slerp", .keys = motion.every(20)},
                                          {.method = "auto", .keys = motion.every(10)},
                                          {.method = "squad", .keys = motion.every(20)},
                                          {.method = "auto", .keys = Keyframes::make(with_rates).value()}};
  const Comparison comparison = compare(candidates, motion.recording(), {}, 2);
  constexpr double natural_spline = 3.375;  // through the angles 0, 0.25, 2 at 0, 1, 2 s
  for (const std::size_t i : {0u, 2u, 3u})
    EXPECT_NEAR(comparison.measures[i]->least_energy.value(), natural_spline, 1e-8) << i;
  EXPECT_GT(comparison.measures[1]->least_energy.value(), natural_spline + 1.0);
  EXPECT_FALSE(measure(candidates[0], motion.recording())->least_energy);
  EXPECT_FALSE(compare(candidates, motion.recording(), {.least_energy = false}).measures[0]->least_energy);
}

TEST(LeastEnergy, IsNotLookedForWithFewerThanTwoKeysOrVeryMany) {
  KeyframeData data{.times = {0.0}, .orientations = {about_x(0.0)}};
  EXPECT_FALSE(least_energy(Keyframes::make(data).value()));
  for (std::size_t i = 1; i <= most_keys_for_least_energy; ++i) {
    data.times.push_back(static_cast<double>(i));
    data.orientations.push_back(about_x(0.0));
  }
  EXPECT_FALSE(least_energy(Keyframes::make(data).value()));
}

TEST(Compare, MeasuresNoMoreOnceItIsStopped) {
  const Motions motion = cubic_motion();
  const std::vector<Candidate> candidates(3, {.method = "slerp", .keys = motion.every(8)});
  std::stop_source source;
  const auto stop_after_one = [&](double) { source.request_stop(); };
  const Comparison comparison =
      compare(candidates, motion.recording(), {}, 1, {.stop = source.get_token(), .show = stop_after_one});
  EXPECT_TRUE(comparison.measures[0]);
  for (const std::size_t i : {1u, 2u}) EXPECT_EQ(comparison.measures[i].error().code, ErrorCode::cancelled);
  const auto stopped = measure(candidates[0], motion.recording(), {}, {.stop = source.get_token()});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
}

TEST(LeaveOut, IsTheDistanceOfSlerpsToTheKeysThatTheySkip) {
  // Steps of 0.1, 0.3: a slerp over two of them passes the middle by 0.1.
  const auto keys =
      Keyframes::make({.times = {0, 1, 2, 3, 4},
                       .orientations = {about_x(0.0), about_x(0.1), about_x(0.4), about_x(0.5), about_x(0.8)}})
          .value();
  const auto error = leave_out_error(keys, "slerp");
  ASSERT_TRUE(error);
  EXPECT_EQ(error->count, 3u);
  EXPECT_NEAR(error->rms, 0.1, 1e-15);
  EXPECT_NEAR(error->largest, 0.1, 1e-15);
}

TEST(LeaveOut, NamesTheKeyThatIsMissedMost) {
  std::vector<double> turns(9);
  for (std::size_t i = 0; i < turns.size(); ++i) turns[i] = 0.1 * static_cast<double>(i);
  for (const std::size_t odd : {1u, 4u, 6u, 7u}) {
    std::vector<double> with_odd = turns;
    with_odd[odd] += 0.03;
    KeyframeData data{.times = {0, 1, 2, 3, 4, 5, 6, 7, 8}};
    for (const double turn : with_odd) data.orientations.push_back(about_x(turn));
    const auto error = leave_out_error(Keyframes::make(std::move(data)).value(), "slerp");
    ASSERT_TRUE(error);
    EXPECT_EQ(error->largest_at, odd);
    EXPECT_NEAR(error->largest, 0.03, 1e-15);
  }
}

TEST(LeaveOut, WantsThreeKeys) {
  const auto keys = Keyframes::make({.times = {0, 1}, .orientations = {about_x(0.0), about_x(0.1)}}).value();
  EXPECT_EQ(leave_out_error(keys, "slerp").error().message, "found 2 keys, wanted 3 to leave one out");
}

}}  // namespace orispline
