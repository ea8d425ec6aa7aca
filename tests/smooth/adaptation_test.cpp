// SPDX-License-Identifier: Apache-2.0
// Smoothing that adapts in time beside one smoothing time for the whole recording, against the truth: of simulated
// gaits, of joints, and of recordings. ORISPLINE_SWEEP=all in the environment takes every track and seed, else a few.
#include <cstdio>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "smooth/safety_net.hpp"

namespace orispline::known_truth { namespace {

constexpr double step = 1.3;  // of τ, in the search for the best single one

/// Distances to the truth [rad].
struct Distances {
  double usual, adapted, best_single;
};

double distance(const Truth& truth, const Keyframes& keys, const SmoothOptions& options) {
  return rms_between(smooth(keys, options).value().nodes.orientations, truth.data.orientations);
}

/// Of the smoothing time that is best for all, found with the truth.
double best_single(const Truth& truth, const Keyframes& keys, double smoothing_time, double distance_there) {
  std::map<int, double> tried{{0, distance_there}};
  const auto at = [&](int k) {
    if (!tried.contains(k)) tried[k] = distance(truth, keys, {.smoothing_time = smoothing_time * std::pow(step, k)});
    return tried[k];
  };
  int k = 0;
  for (const int direction : {-1, 1})
    while (std::abs(k) < 12 && at(k + direction) < at(k)) k += direction;
  double best = at(k);
  for (const double half : {-0.5, 0.5})
    best = std::min(best, distance(truth, keys, {.smoothing_time = smoothing_time * std::pow(step, k + half)}));
  return best;
}

Distances distances_of(const Truth& truth, double noise_deg, std::uint64_t seed) {
  const Keyframes keys = Keyframes::make(disturbed(truth.data, noise_deg * degree, seed)).value();
  const Smoothing usual = smooth(keys, {.adapt = false}).value();
  Distances found{.usual = rms_between(usual.nodes.orientations, truth.data.orientations),
                  .adapted = distance(truth, keys, {}),
                  .best_single = 0.0};
  found.best_single = best_single(truth, keys, usual.smoothing_time, found.usual);
  std::printf("%s, noise %g°, seed %d: %.4f of the usual, %.4f of the best single one\n", truth.name.c_str(), noise_deg,
              static_cast<int>(seed), found.adapted / found.usual, found.adapted / found.best_single);
  return found;
}

/// The geometric mean over cases.
class Mean {
 public:
  void add(double ratio) {
    sum_ += std::log(ratio);
    ++count_;
  }
  [[nodiscard]] double value() const { return std::exp(sum_ / count_); }

 private:
  double sum_ = 0.0;
  int count_ = 0;
};

TEST(Adaptation, OfGaitsIsNearerThanAnySingleTime) {
  Mean ratios;
  for (const Strike kind : {Strike::pulse, Strike::step, Strike::ring})
    for (const double noise_deg : noises())
      for (std::uint64_t seed = 10; seed < 10 + seeds(); ++seed) {
        const Distances found = distances_of(gait(seed, kind), noise_deg, seed);
        EXPECT_LE(found.adapted, allowed * found.usual);
        ratios.add(found.adapted / found.best_single);
      }
  std::printf("gaits: %.4f of the best single one\n", ratios.value());
  EXPECT_LT(ratios.value(), 0.95);
}

TEST(Adaptation, OfJointsIsNearerThanAnySingleTime) {
  const std::string path = std::string(data) + "/mocap/cmu_01_01_fairmotion.bvh";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const auto joints = bvh_joints(path);
  Mean ratios;
  for (std::size_t joint = 0; joint < joints.size(); joint += sweeps() ? 1 : 14)
    for (const double noise_deg : noises())
      for (std::uint64_t seed = 0; seed < (sweeps() ? 2 : 1); ++seed) {
        if (!is_judged(joints[joint], noise_deg)) continue;
        const Distances found = distances_of(joints[joint], noise_deg, seed);
        EXPECT_LE(found.adapted, allowed * found.usual) << joints[joint].name << ", " << noise_deg << "°";
        ratios.add(found.adapted / found.best_single);
      }
  std::printf("joints: %.4f of the best single one\n", ratios.value());
  EXPECT_LT(ratios.value(), 0.98);
}

TEST(Adaptation, OfRecordingsIsNotWorse) {
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "no " << data;
  for (const Truth& truth : recordings(data)) {
    if (!sweeps() && truth.data.times.size() > 5000) continue;
    for (const double noise_deg : noises())
      for (std::uint64_t seed = 0; seed < (sweeps() ? 2 : 1); ++seed) {
        if (!is_judged(truth, noise_deg)) continue;
        const Keyframes keys = Keyframes::make(disturbed(truth.data, noise_deg * degree, seed)).value();
        const double usual = distance(truth, keys, {.adapt = false}), adapted = distance(truth, keys, {});
        std::printf("%s, noise %g°: %.4f of the usual\n", truth.name.c_str(), noise_deg, adapted / usual);
        EXPECT_LE(adapted, allowed * usual) << truth.name << ", " << noise_deg << "°";
      }
  }
}

TEST(Adaptation, OfAnEvenMotionIsNotWorse) {
  for (const double noise_deg : {0.03, 0.3, 3.0})
    for (std::uint64_t seed = 1; seed <= (sweeps() ? 10 : 2); ++seed) {
      const Recording recording = recorded(1000, noise_deg * degree, seed);
      const Keyframes keys = Keyframes::make(recording.noisy).value();
      const Smoothing usual = smooth(keys, {.adapt = false}).value(), adapted = smooth(keys).value();
      EXPECT_LE(rms(adapted, recording.clean), allowed * rms(usual, recording.clean)) << noise_deg << "°, " << seed;
    }
}

TEST(Adaptation, TellsItsSmoothingTimesWhichAreShortWhereTheMotionIsQuick) {
  const Truth truth = gait(2, Strike::ring);
  const Keyframes keys = Keyframes::make(disturbed(truth.data, 0.1 * degree, 2)).value();
  const Smoothing smoothing = smooth(keys, {.sigma = true}).value();
  ASSERT_EQ(smoothing.smoothing_times.size(), keys.size());
  EXPECT_LT(2.0 * *smoothing.shortest_smoothing_time(), *smoothing.longest_smoothing_time());
  EXPECT_LT(*smoothing.shortest_smoothing_time(), smoothing.smoothing_time);
  EXPECT_GT(*smoothing.longest_smoothing_time(), smoothing.smoothing_time);
  const auto quickest = static_cast<std::size_t>(std::ranges::min_element(smoothing.smoothing_times) -
                                                 smoothing.smoothing_times.begin()),
             calmest = static_cast<std::size_t>(std::ranges::max_element(smoothing.smoothing_times) -
                                                smoothing.smoothing_times.begin());
  const double second = truth.data.times[quickest], beside = second - std::round(second - 0.5) - 0.5;
  EXPECT_LT(std::abs(beside), 0.25) << "strikes are at half seconds, give or take 0.1 s";
  EXPECT_LT(smoothing.sigmas->orientations[calmest].x(), smoothing.sigmas->orientations[quickest].x());
  EXPECT_LT(smoothing.last_step, 1e-9);
}

TEST(Adaptation, IsForEveryPenaltyLossAndKnowledge) {
  const Truth truth = gait(3, Strike::ring, 600);
  const Keyframes keys = Keyframes::make(disturbed(truth.data, 0.3 * degree, 3)).value();
  for (SmoothOptions options : {SmoothOptions{.penalty = Penalty::jerk}, SmoothOptions{.loss = Loss::l2},
                                SmoothOptions{.noise = 0.3 * degree}}) {
    const double adapted = distance(truth, keys, options);
    options.adapt = false;
    EXPECT_LT(adapted, 0.95 * distance(truth, keys, options));
  }
}

TEST(Adaptation, LeavesOneTimeWhereItServesAsWell) {
  const Keyframes keys = Keyframes::make(recorded(300, degree).noisy).value();
  const Smoothing usual = smooth(keys, {.adapt = false}).value(), adapted = smooth(keys).value();
  EXPECT_TRUE(usual.smoothing_times.empty());
  EXPECT_FALSE(usual.shortest_smoothing_time());
  EXPECT_TRUE(adapted.smoothing_times.empty());
  EXPECT_EQ(adapted.smoothing_time, usual.smoothing_time);
  for (std::size_t i = 0; i < keys.size(); ++i)
    EXPECT_EQ(adapted.nodes.orientations[i].coeffs(), usual.nodes.orientations[i].coeffs());
}

TEST(Adaptation, BearsGapsAndFewSamples) {
  Truth truth = gait(4, Strike::pulse, 600);
  for (std::size_t i = 300; i < 600; ++i) truth.data.times[i] += 5.0;
  const Keyframes keys = Keyframes::make(disturbed(truth.data, 0.1 * degree, 4)).value();
  const Smoothing smoothing = smooth(keys, {.gap = 1.0}).value();
  EXPECT_EQ(smoothing.stretches.size(), 2u);
  EXPECT_TRUE(smoothing.smoothing_times.empty() || smoothing.smoothing_times.size() == 600u);
  for (const std::size_t count : {3u, 4u, 7u})
    EXPECT_TRUE(smooth(Keyframes::make(recorded(count, degree).noisy).value()));
}

TEST(Adaptation, IsNotWhereOneTimeIsStatedOrAGyroIsUsed) {
  const Truth truth = gait(3, Strike::ring, 600);
  KeyframeData data = disturbed(truth.data, 0.3 * degree, 3);
  const Smoothing adapted = smooth(Keyframes::make(data).value()).value();
  ASSERT_FALSE(adapted.smoothing_times.empty());
  data.angular_velocities = adapted.nodes.angular_velocities;
  const Keyframes keys = Keyframes::make(data).value();
  EXPECT_TRUE(smooth(keys, {.smoothing_time = adapted.smoothing_time}).value().smoothing_times.empty());
  EXPECT_TRUE(smooth(keys, {.gyro = true}).value().smoothing_times.empty());
}

}}  // namespace orispline::known_truth
