// SPDX-License-Identifier: Apache-2.0
// Positions are smoothed as orientations are: known truths, outliers, gaps, exact recordings, uneven and large times.
#include <algorithm>
#include <cstdlib>
#include <ctime>

#include <gtest/gtest.h>

#include <orispline/smooth/smooth.hpp>
#include <orispline/smooth/smoothing.hpp>
#include <orispline/smooth/smoothing_result.hpp>

#include "smooth/noisy_motion.hpp"

namespace orispline { namespace {

using Indices = std::vector<std::size_t>;
using Vectors = std::vector<Eigen::Vector3d>;

Eigen::Vector3d path_at(double t) { return {std::sin(2.0 * t), 2.0 + std::cos(3.0 * t), 0.5 * t}; }

/// Noise of σ per axis [m] beside a body that does not turn, but for 0.2° of noise.
Recording on_path(const std::vector<double>& times, double noise) {
  Recording recording;
  Dice dice(23), turns(5);
  recording.clean.times = recording.noisy.times = times;
  for (const double t : times) {
    recording.noisy.orientations.push_back(exp<double>(Eigen::Vector3d(0.2 * degree * normal_vector(turns))));
    recording.clean.positions.push_back(path_at(t));
    recording.noisy.positions.push_back(path_at(t) + noise * normal_vector(dice));
  }
  return recording;
}

std::vector<double> even_times(std::size_t count, double start = 0.0) {
  std::vector<double> times;
  for (std::size_t i = 0; i < count; ++i) times.push_back(start + 0.01 * static_cast<double>(i));
  return times;
}

/// 0.1 to 30 ms apart.
std::vector<double> uneven_times(std::size_t count) {
  Dice dice(3);
  std::vector<double> times{0.0};
  while (times.size() < count) times.push_back(times.back() + dice.between(1e-4, 0.03));
  return times;
}

double rms_of(const Vectors& found, const Vectors& wanted) {
  double sum = 0.0;
  for (std::size_t i = 0; i < wanted.size(); ++i) sum += (found[i] - wanted[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(wanted.size()));
}

TEST(SmoothPositions, ComeNearTheTruthWithoutBeingToldAnything) {
  for (const auto& times : {even_times(800), uneven_times(800), even_times(800, 1.7e9)})
    for (const Penalty penalty : {Penalty::acceleration, Penalty::jerk}) {
      const auto recording = on_path(times, 0.02);
      const Smoothing smoothing = smoothed(recording.noisy, {.penalty = penalty});
      const double before = rms_of(recording.noisy.positions, recording.clean.positions),
                   after = rms_of(smoothing.nodes.positions, recording.clean.positions);
      EXPECT_LT(after, 0.35 * before);
      ASSERT_TRUE(smoothing.positions);
      EXPECT_EQ(smoothing.positions->criterion, SmoothingCriterion::gcv);
      EXPECT_NEAR(smoothing.positions->noise, 0.02, 0.001);
      EXPECT_NEAR(smoothing.positions->local_noise, 0.02, 0.002);
      EXPECT_TRUE(smoothing.positions->rejected.empty());
      for (const double factor : {0.5, 2.0}) {  // the choice is near the best one
        const double time = factor * *smoothing.positions->smoothing_time;
        const Smoothing other = smoothed(recording.noisy, {.penalty = penalty, .smoothing_time = time});
        EXPECT_DOUBLE_EQ(other.positions->smoothing_time.value(), other.smoothing_time);
        EXPECT_FALSE(other.positions->criterion);
        EXPECT_GT(rms_of(other.nodes.positions, recording.clean.positions), 0.95 * after);
      }
    }
}

TEST(SmoothPositions, AreThoseOfTheKeysAndTheDistancesAreToTheSamples) {
  auto recording = on_path(even_times(400), 0.02);
  recording.noisy.positions[200].x() += 1.0;
  const Smoothing smoothing = smoothed(recording.noisy);
  ASSERT_EQ(smoothing.positions->rejected, Indices{200});
  double sum = 0.0, largest = 0.0, largest_accepted = 0.0;
  for (std::size_t i = 0; i < 400; ++i) {
    EXPECT_EQ(smoothing.track.keys.positions()[i], smoothing.nodes.positions[i]);
    const double distance = (smoothing.nodes.positions[i] - recording.noisy.positions[i]).norm();
    sum += distance * distance;
    largest = std::max(largest, distance);
    if (i != 200) largest_accepted = std::max(largest_accepted, distance);
  }
  EXPECT_NEAR(smoothing.positions->distances.rms, std::sqrt(sum / 400.0), 1e-12);
  EXPECT_NEAR(smoothing.positions->distances.largest, largest, 1e-12);
  EXPECT_NEAR(smoothing.positions->accepted_distances.largest, largest_accepted, 1e-12);
  EXPECT_NEAR(smoothing.positions->accepted_distances.rms, std::sqrt((sum - largest * largest) / 399.0), 1e-12);
}

TEST(SmoothPositions, LeaveOutliersOutAndOrientationsAlone) {
  for (const Penalty penalty : {Penalty::acceleration, Penalty::jerk})
    for (const auto& times : {even_times(600), uneven_times(600)}) {
      auto recording = on_path(times, 0.02);
      const Smoothing without = smoothed(recording.noisy, {.penalty = penalty});
      Indices faults;
      for (std::size_t i = 20; i < 600; i += 73) {
        faults.push_back(i);
        recording.noisy.positions[i] += Eigen::Vector3d(0.0, 0.6, -0.8);
      }
      const Smoothing with = smoothed(recording.noisy, {.penalty = penalty});
      EXPECT_EQ(with.positions->rejected, faults);
      EXPECT_TRUE(with.rejected.empty());
      EXPECT_LT(rms_of(with.nodes.positions, recording.clean.positions),
                1.1 * rms_of(without.nodes.positions, recording.clean.positions));
      const Smoothing trusting = smoothed(recording.noisy, {.penalty = penalty, .loss = Loss::l2});
      EXPECT_TRUE(trusting.positions->rejected.empty());
      EXPECT_GT(rms_of(trusting.nodes.positions, recording.clean.positions),
                2.0 * rms_of(with.nodes.positions, recording.clean.positions));
      for (std::size_t i = 0; i < 600; ++i)
        EXPECT_EQ(with.nodes.orientations[i].coeffs(), without.nodes.orientations[i].coeffs());
    }
}

TEST(SmoothPositions, TakeEveryLoss) {
  auto recording = on_path(even_times(600), 0.02);
  for (const std::size_t i : {100u, 200u, 201u, 300u, 301u, 302u}) recording.noisy.positions[i].z() += 1.0;
  EXPECT_EQ(smoothed(recording.noisy).positions->rejected, (Indices{100, 200, 201}));
  const Indices kept = smoothed(recording.noisy).positions->retained_outlier_runs;
  EXPECT_GE(kept.size(), 3u);
  for (const std::size_t i : kept) EXPECT_NEAR(static_cast<double>(i), 301.0, 5.0);
  const Smoothing huber = smoothed(recording.noisy, {.smoothing_time = 0.03, .loss = Loss::huber}),
                  l2 = smoothed(recording.noisy, {.smoothing_time = 0.03, .loss = Loss::l2}),
                  tukey = smoothed(recording.noisy, {.smoothing_time = 0.03, .loss = Loss::tukey});
  EXPECT_TRUE(huber.positions->rejected.empty());
  EXPECT_TRUE(std::ranges::includes(tukey.positions->rejected, Indices{100, 200, 201}));
  EXPECT_LT(rms_of(huber.nodes.positions, recording.clean.positions),
            0.5 * rms_of(l2.nodes.positions, recording.clean.positions));
}

TEST(SmoothPositions, OfAStretchDoNotKnowTheOthers) {
  const auto recording = on_path(even_times(300), 0.02);
  KeyframeData cut = recording.noisy, first = recording.noisy;
  for (std::size_t i = 150; i < 300; ++i) cut.times[i] += 5.0;
  cut.times[299] += 5.0;  // stands alone
  for (std::size_t i = 150; i < 300; ++i) cut.positions[i].x() += 40.0;
  first.times.resize(150);
  first.orientations.resize(150);
  first.positions.resize(150);
  const SmoothOptions options{.smoothing_time = 0.05, .loss = Loss::l2, .gap = 1.0};
  const Smoothing whole = smoothed(cut, options), part = smoothed(first, options);
  ASSERT_EQ(whole.nodes.positions.size(), 299u);
  for (std::size_t i = 0; i < 150; ++i)
    EXPECT_LT((whole.nodes.positions[i] - part.nodes.positions[i]).norm(), 1e-12) << i;
  EXPECT_LT((whole.nodes.positions[150] - cut.positions[150]).norm(), 0.1);
}

/// Positions made by `at(t)` come out as they are.
template <class At>
void expect_unchanged(At at, const std::vector<double>& times, const SmoothOptions& options = {}) {
  KeyframeData data = on_path(times, 0.0).noisy;
  data.positions.clear();
  double size = 0.0;
  for (const double t : times) {
    data.positions.push_back(at(t - times[0]));
    size = std::max(size, data.positions.back().norm());
  }
  const auto smoothing = smooth(Keyframes::make(data).value(), options);
  ASSERT_TRUE(smoothing) << describe(smoothing.error());
  EXPECT_TRUE(smoothing->positions->rejected.empty());
  for (std::size_t i = 0; i < times.size(); ++i)
    ASSERT_LE((smoothing->nodes.positions[i] - data.positions[i]).norm(), 1e-13 * size) << i;
}

TEST(SmoothPositions, WithoutNoiseStayWhatTheyAre) {
  for (const Penalty penalty : {Penalty::acceleration, Penalty::jerk})
    for (const auto& times : {even_times(150), uneven_times(150), even_times(150, 1.7e9)}) {
      SmoothOptions options{.penalty = penalty};
      const auto line = [](double t) { return Eigen::Vector3d(1e6 + 3.0 * t, -4.0 * t, 0.7); };
      expect_unchanged([](double) { return Eigen::Vector3d::Zero().eval(); }, times, options);
      expect_unchanged([](double) { return Eigen::Vector3d(1e7, 0.1, -3.0); }, times, options);
      expect_unchanged(line, times, options);
      expect_unchanged(path_at, times, options);
      options.smoothing_time = 1.0;
      expect_unchanged(line, times, options);
      options.smoothing_time.reset();
      options.position_noise = 0.01;
      expect_unchanged(line, times, options);
    }
  // A robot's: rests, and ways without a jerk at their ends.
  const auto way = [](double t) {
    const double u = std::clamp(t - 1.0, 0.0, 2.0);
    return Eigen::Vector3d(1.0 - std::cos(0.5 * testing_support::pi * u), 0.0, 2.0);
  };
  expect_unchanged(way, even_times(400));
}

TEST(SmoothPositions, OfAnExactPathWithCornersStayWithinAPartOfAStep) {
  auto recording = on_path(even_times(400), 0.0);
  for (std::size_t i = 0; i < 400; ++i)
    recording.noisy.positions[i] = {std::abs(0.01 * static_cast<double>(i) - 2.0), 0.0,
                                    1.0};  // at 1 m/s, there and back
  const Smoothing smoothing = smoothed(recording.noisy);
  EXPECT_TRUE(smoothing.positions->rejected.empty());
  EXPECT_LT(smoothing.positions->distances.largest, 0.0015);
}

/// 3000 samples with noise in some directions only, for both kinds.
Smoothing with_noise_along(const Eigen::Vector3d& directions) {
  KeyframeData data;
  Dice dice(2);
  for (const double t : even_times(1000)) {
    data.times.push_back(t);
    data.orientations.push_back(exp<double>(Eigen::Vector3d(degree * directions.cwiseProduct(normal_vector(dice)))));
    data.positions.push_back(path_at(t) + 0.02 * directions.cwiseProduct(normal_vector(dice)));
  }
  return smoothed(data);
}

// A vehicle's noise lies in the plane, a heading's about one axis: taken for a third of noise all around, 2 in 100
// samples of it would pass for outliers.
TEST(SmoothingOutliers, AreAsFewWhereNoiseHasOneDirection) {
  for (const Eigen::Vector3d& directions :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(1, 1, 3), Eigen::Vector3d(1, 1, 1)}) {
    const Smoothing smoothing = with_noise_along(directions);
    EXPECT_LE(smoothing.rejected.size() + smoothing.retained_outlier_runs.size(), 1u);
    EXPECT_LE(smoothing.positions->rejected.size() + smoothing.positions->retained_outlier_runs.size(), 1u);
  }
}

TEST(SmoothPositions, OfALongRecordingComeNearTheTruth) {
  const auto recording = on_path(even_times(3000), 0.02);
  EXPECT_LT(rms_of(smoothed(recording.noisy).nodes.positions, recording.clean.positions), 0.012);
}

TEST(SmoothPositions, FollowTheNoiseThatIsStated) {
  const auto recording = on_path(even_times(800), 0.02);
  const Smoothing stated = smoothed(recording.noisy, {.position_noise = 0.02});
  EXPECT_EQ(stated.positions->criterion, SmoothingCriterion::ubre);
  EXPECT_EQ(stated.criterion, SmoothingCriterion::gcv);
  EXPECT_LT(rms_of(stated.nodes.positions, recording.clean.positions), 0.012);
  const Smoothing more = smoothed(recording.noisy, {.position_noise = 0.05});
  EXPECT_GT(*more.positions->smoothing_time, *stated.positions->smoothing_time);
  const Smoothing both = smoothed(recording.noisy, {.smoothing_time = 0.5, .position_noise = 0.02});  // of orientations
  EXPECT_EQ(both.smoothing_time, 0.5);
  EXPECT_EQ(both.nodes.positions, stated.nodes.positions);
  KeyframeData without = recording.noisy;
  without.positions.clear();
  const auto refused = smooth(Keyframes::make(without).value(), {.position_noise = 0.02});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::bad_data);
  EXPECT_EQ(refused.error().message, "found no positions, wanted px,py,pz for `position_noise`");
  const auto small = smooth(Keyframes::make(recording.noisy).value(), {.position_noise = 1e-6});
  ASSERT_FALSE(small);
  EXPECT_EQ(small.error().message,
            "positions: 800 of 800 samples are farther than 5 σ from the best motion, σ = 1e-06 m, wanted a larger "
            "noise, a shorter smoothing time, or the loss l2, which has no outliers");
}

TEST(SmoothPositions, AreAbsentFromTheResultsWithoutAny) {
  const Smoothing smoothing = smoothed(recorded(100, degree).noisy);
  EXPECT_FALSE(smoothing.positions);
  for (const char* name : {"position_smoothing_time", "position_noise", "position_rms_distance", "rejected_positions"})
    EXPECT_TRUE(is_absent(field_named(fields_of<Smoothing>(), name).get(&smoothing))) << name;
  const Smoothing with = smoothed(on_path(even_times(100), 0.02).noisy);
  EXPECT_EQ(field_named(fields_of<Smoothing>(), "position_noise").get(&with), FieldValue(with.positions->noise));
  EXPECT_EQ(field_named(fields_of<Smoothing>(), "rejected_positions").get(&with), FieldValue(Indices{}));
}

TEST(SmoothPositions, ManyThatAreRejectedAreToldApart) {
  const Smoothing smoothing{.keys = Indices(200), .stretches = {{0, 200}}, .positions = {{.rejected = {1, 50, 100}}}};
  const auto warnings = warnings_of(smoothing);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].code, "many_positions_rejected");
  EXPECT_TRUE(warnings[0].message.starts_with("3 of 200 positions (1.5 %) are rejected as outliers"));
}

// Processor time in relation: ten times as many take some ten times as long, in quadratic time a hundred times.
TEST(SmoothPositions, TakeLinearTime) {
  if (!std::getenv("ORISPLINE_TIMING")) GTEST_SKIP() << "by the clock, which wants a machine that does nothing else";
  const auto seconds = [](std::size_t count) {
    const auto recording = on_path(even_times(count), 0.02);
    const SmoothingProblem problem{.times = recording.noisy.times,
                                   .positions = recording.noisy.positions,
                                   .weights = std::vector<double>(count, 1.0)};
    double least = 1e9;
    for (int k = 0; k < 3; ++k) {
      const std::clock_t begin = std::clock();
      EXPECT_EQ(fit_smoothing(problem, {.lambda = 1e-5}).nodes.positions.size(), count);
      least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    return least;
  };
  EXPECT_LT(seconds(10000), 30.0 * seconds(1000));
}

}}  // namespace orispline
