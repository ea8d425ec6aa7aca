// SPDX-License-Identifier: Apache-2.0
// The smooth motion is no farther from the truth than the noisy samples are: of simulated gaits with strikes, and of
// recordings that are taken for the truth. ORISPLINE_SWEEP=all in the environment takes every track and seed, which is
// hours of work; else a few that are hard.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include <gtest/gtest.h>

#include "smooth/safety_net.hpp"

namespace orispline::known_truth { namespace {

struct Errors {
  double samples, robust, l2;
  std::size_t rejected;
};

Errors errors_of(const Truth& truth, const KeyframeData& noisy) {
  const Keyframes keys = Keyframes::make(noisy).value();
  const auto robust = smooth(keys).value(), l2 = smooth(keys, {.loss = Loss::l2}).value();
  const auto& wanted = truth.data.orientations;
  return {rms_between(noisy.orientations, wanted), rms_between(robust.nodes.orientations, wanted),
          rms_between(l2.nodes.orientations, wanted), robust.rejected.size()};
}

/// The truth comes nearer by the default options, or stays as far; a truth that is too noisy or faulty itself is
/// reported only.
void expect_no_worse(const Truth& truth, double noise_deg, std::uint64_t seed) {
  const KeyframeData noisy = disturbed(truth.data, noise_deg * degree, seed);
  const double own = own_noise(truth.data);
  const Keyframes keys = Keyframes::make(noisy).value();
  const auto smoothing = smooth(keys);
  ASSERT_TRUE(smoothing) << truth.name << ": " << describe(smoothing.error());
  const double before = rms_between(noisy.orientations, truth.data.orientations),
               after = rms_between(smoothing->nodes.orientations, truth.data.orientations);
  if (!is_judged(truth, noise_deg)) {
    std::printf("not judged: %s has noise of %.3g°%s, with %.3g° more %.4f° become %.4f°\n", truth.name.c_str(),
                own / degree, is_faulty(truth) ? " and single samples that jump" : "", noise_deg, before / degree,
                after / degree);
    return;
  }
  EXPECT_LE(after, allowed * before) << truth.name << ", noise " << noise_deg << "°, seed " << seed << ", "
                                     << smoothing->rejected.size() << " rejected";
}

// A strike of 20 ms is hardly told from a fault: one rejected sample of a crest costs a few percent of what l2 has.
TEST(Strikes, AreNoOutliers) {
  for (const double noise_deg : {0.05, 0.1, 0.3}) {
    if (!sweeps() && noise_deg == 0.1) continue;
    double sum = 0.0, sum_l2 = 0.0;
    for (const Strike kind : {Strike::pulse, Strike::step, Strike::ring})
      for (std::uint64_t seed = 0; seed < (sweeps() ? 10 : 1); ++seed) {
        const Truth truth = gait(seed, kind);
        const Errors errors = errors_of(truth, disturbed(truth.data, noise_deg * degree, seed));
        EXPECT_LE(errors.robust, allowed * errors.samples) << truth.name << ", " << noise_deg << "°";
        EXPECT_LE(errors.robust, 1.12 * errors.l2) << truth.name << ", " << noise_deg << "°";
        EXPECT_LE(errors.rejected, 3u) << truth.name << ", " << noise_deg << "°";
        sum += errors.robust;
        sum_l2 += errors.l2;
      }
    EXPECT_LE(sum, 1.03 * sum_l2) << noise_deg << "°";
  }
}

TEST(Strikes, DoNotHideOutliers) {
  for (const Strike kind : {Strike::pulse, Strike::step, Strike::ring}) {
    if (!sweeps() && kind == Strike::step) continue;
    const Truth truth = gait(3, kind);
    const KeyframeData faulty = disturbed(truth.data, 0.1 * degree, 3, 0.02);
    const Errors without = errors_of(truth, disturbed(truth.data, 0.1 * degree, 3)), with = errors_of(truth, faulty);
    EXPECT_LE(with.robust, 1.5 * without.robust) << truth.name;
    EXPECT_LE(with.robust, 0.2 * with.samples) << truth.name;
    EXPECT_LE(with.robust, 0.5 * with.l2) << truth.name;
  }
}

TEST(NeverWorse, OfGaits) {
  for (const Strike kind : {Strike::pulse, Strike::step, Strike::ring})
    for (const double noise_deg : noises())
      for (std::uint64_t seed = 10; seed < 10 + seeds(); ++seed) expect_no_worse(gait(seed, kind), noise_deg, seed);
}

TEST(NeverWorse, OfJoints) {
  const std::string path = std::string(data) + "/mocap/cmu_01_01_fairmotion.bvh";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const auto joints = bvh_joints(path);
  ASSERT_EQ(joints.size(), 31u);
  for (std::size_t joint = 0; joint < joints.size(); joint += sweeps() ? 1 : 14)
    for (const double noise_deg : noises())
      for (std::uint64_t seed = 0; seed < seeds(); ++seed) expect_no_worse(joints[joint], noise_deg, seed);
}

/// How far a smoothed joint is from the recording, over the bound that the added noise and the recording's own give;
/// all samples, or those that are not rejected.
double over_noise(const Truth& joint, double noise, std::uint64_t seed, bool with_rejected) {
  constexpr double margin = 1.05;
  const Smoothing smoothing = smooth(Keyframes::make(disturbed(joint.data, noise, seed)).value()).value();
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < joint.data.orientations.size(); ++i) {
    if (!with_rejected && std::ranges::binary_search(smoothing.rejected, i)) continue;
    const double d = angular_distance(smoothing.nodes.orientations[i], joint.data.orientations[i]);
    sum += d * d;
    count += 1.0;
  }
  const double own = own_noise(joint.data);
  return std::sqrt(sum / count / (3.0 * (noise * noise + own * own))) / margin;
}

// At 0.05° the samples of RightToeBase are followed as they are, but for one that is 15° from where its neighbours
// lead: that one alone is more than the bound allows all of them together.
TEST(Smooth, MovesNoJointFartherThanItsNoise) {
  const std::string path = std::string(data) + "/mocap/cmu_01_01_fairmotion.bvh";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  for (const Truth& joint : bvh_joints(path)) {
    if (is_faulty(joint)) continue;
    for (const double noise_deg : {0.05, 0.1}) {
      const bool is_rejected = joint.name == "bvh/RightToeBase" && noise_deg < 0.1;
      EXPECT_LE(over_noise(joint, noise_deg * degree, 0, !is_rejected), 1.0) << joint.name << ", " << noise_deg << "°";
    }
  }
}

TEST(NeverWorse, OfRecordings) {
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "no " << data;
  const auto all = recordings(data);
  ASSERT_EQ(all.size(), 4u);
  for (const Truth& truth : all) {
    if (!sweeps() && truth.data.times.size() > 10000) continue;
    for (const double noise_deg : noises())
      for (std::uint64_t seed = 0; seed < seeds(); ++seed) expect_no_worse(truth, noise_deg, seed);
  }
}

}}  // namespace orispline::known_truth
