// SPDX-License-Identifier: Apache-2.0
// Standard deviations of smoothed nodes: against the inverse of the whole normal matrix, golden/smooth_sigmas.csv, made
// by tools/make_golden.py sigma with 60 digits; and against the truth over seeded noise.
#include <cmath>

#include <gtest/gtest.h>

#include <orispline/smooth/smoothing_element.hpp>
#include <support/near.hpp>

#include "smooth/noisy_motion.hpp"
#include "smooth/smoothing_case.hpp"

namespace orispline { namespace {

using testing_support::DataTable;
using testing_support::golden_figure;
using testing_support::relative_error;
using testing_support::SmoothingCase;

constexpr double within_90 = 1.6448536269514722;        // standard deviations, of nine in ten normal values
constexpr double angle_within_90 = 2.5002777108094975;  // the same of a vector of three

TEST(NodeSigmas, AreThoseOfTheInverseOfTheWholeMatrix) {
  const DataTable cases("golden/smooth_cases.csv"), nodes("golden/smooth_nodes.csv"), table("golden/smooth_sigmas.csv");
  std::size_t compared = 0;
  for (const auto& row : cases.rows()) {
    SCOPED_TRACE(row.text("name"));
    const SmoothingCase test(nodes, row);
    SmoothedNodes found;
    for (const auto& node : test.nodes) {
      found.orientations.push_back(node.quaternion("found_qw", "found_qx", "found_qy", "found_qz"));
      found.angular_velocities.push_back(node.vector("wx", "wy", "wz"));
      found.angular_accelerations.push_back(node.vector("ax", "ay", "az"));
    }
    const NodeSigmas sigmas = node_sigmas(test.problem, test.objective, found);
    const auto wanted = table.rows_where("case", row.text("case"));
    ASSERT_EQ(wanted.size(), sigmas.orientations.size());
    for (std::size_t i = 0; i < wanted.size(); ++i, ++compared) {
      EXPECT_LT(relative_error(sigmas.orientations[i], wanted[i].vector("sigma_x", "sigma_y", "sigma_z")),
                golden_figure)
          << i;
      EXPECT_LT(relative_error(sigmas.angular_velocities[i], wanted[i].vector("sigma_wx", "sigma_wy", "sigma_wz")),
                golden_figure)
          << i;
    }
  }
  EXPECT_EQ(compared, 84u);
}

/// Of the motion of recorded(), body frame.
Eigen::Vector3d true_rate(double t) {
  const double rate = 2.0 * std::cos(2.0 * t), angle = std::sin(3.0 * t);
  return {3.0 * std::cos(3.0 * t), rate * std::sin(angle), rate * std::cos(angle)};
}

/// Shares of components, and of angles, that are within so many standard deviations of the truth.
struct Coverage {
  double turns = 0.0, rates = 0.0, angles = 0.0, samples = 0.0;

  void add(const Smoothing& smoothing, const KeyframeData& clean) {
    for (std::size_t i = 0; i < smoothing.keys.size(); ++i, ++samples) {
      const Eigen::Vector3d& sigma = smoothing.sigmas->orientations[i];
      const Eigen::Vector3d turn = shortest_increment(smoothing.nodes.orientations[i], clean.orientations[i]),
                            rate = clean.angular_velocities[i] - smoothing.nodes.angular_velocities[i];
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        turns += std::abs(turn[axis]) <= within_90 * sigma[axis];
        rates += std::abs(rate[axis]) <= within_90 * smoothing.sigmas->angular_velocities[i][axis];
      }
      angles += turn.cwiseQuotient(sigma).norm() <= angle_within_90;
    }
  }

  [[nodiscard]] double of_turns() const { return turns / (3.0 * samples); }
  [[nodiscard]] double of_rates() const { return rates / (3.0 * samples); }
  [[nodiscard]] double of_angles() const { return angles / samples; }
};

TEST(NodeSigmas, HoldTheTruthAsOftenAsTheySayWhereTheMotionIsThatOfThePenalty) {
  for (const std::optional<double> stated : {std::optional<double>(), std::optional(degree)}) {
    Coverage coverage;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const Recording recording = wandering(500, degree, seed);
      const Keyframes keys = Keyframes::make(recording.noisy).value();
      coverage.add(smooth(keys, {.noise = stated, .sigma = true}).value(), recording.clean);
    }
    for (const double share : {coverage.of_turns(), coverage.of_rates(), coverage.of_angles()}) {
      EXPECT_GT(share, 0.85);
      EXPECT_LT(share, 0.95);
    }
  }
}

// Between samples such a motion bends less than the penalty allows: its rates are surer than they are said to be.
TEST(NodeSigmas, AreNotTooSmallWhereTheMotionIsSmoother) {
  Coverage coverage;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Recording recording = recorded(600, degree, seed);
    for (const double t : recording.clean.times) recording.clean.angular_velocities.push_back(true_rate(t));
    coverage.add(smooth(Keyframes::make(recording.noisy).value(), {.sigma = true}).value(), recording.clean);
  }
  EXPECT_GT(coverage.of_turns(), 0.85);
  EXPECT_LT(coverage.of_turns(), 0.95);
  EXPECT_GT(coverage.of_rates(), 0.9);
}

TEST(NodeSigmas, AreGivenOnlyWhereTheyAreAskedForAndChangeNothingElse) {
  const Keyframes keys = Keyframes::make(recorded(200, degree).noisy).value();
  const Smoothing without = smooth(keys).value(), with = smooth(keys, {.sigma = true}).value();
  EXPECT_FALSE(without.sigmas || without.rms_sigma() || without.rms_sigma_of_rates());
  ASSERT_TRUE(with.sigmas);
  for (std::size_t i = 0; i < 200; ++i)
    EXPECT_EQ(with.nodes.orientations[i].coeffs(), without.nodes.orientations[i].coeffs());
  EXPECT_GT(*with.rms_sigma(), 0.1 * degree);
  EXPECT_LT(*with.rms_sigma(), with.noise);
}

TEST(NodeSigmas, AreLargerAtTheEndsAndWhereSamplesAreRejected) {
  Recording recording = recorded(300, degree);
  recording.noisy.orientations[150] = recording.noisy.orientations[150] * exp<double>(Eigen::Vector3d(0.0, 0.5, 0.0));
  const Smoothing smoothing = smooth(Keyframes::make(recording.noisy).value(), {.sigma = true}).value();
  ASSERT_EQ(smoothing.rejected, std::vector<std::size_t>{150});
  const auto& sigmas = smoothing.sigmas->orientations;
  EXPECT_GT(sigmas.front().x(), 1.5 * sigmas[100].x());
  EXPECT_GT(sigmas.back().x(), 1.5 * sigmas[100].x());
  EXPECT_GT(sigmas[150].x(), 1.01 * sigmas[100].x());
}

TEST(NodeSigmas, AreThoseOfKeysInStretches) {
  Recording recording = recorded(300, degree);
  for (std::size_t i = 150; i < 300; ++i) recording.noisy.times[i] += 10.0;
  recording.noisy.times[299] += 10.0;  // alone
  const Smoothing smoothing = smooth(Keyframes::make(recording.noisy).value(), {.gap = 1.0, .sigma = true}).value();
  ASSERT_EQ(smoothing.keys.size(), 299u);
  ASSERT_EQ(smoothing.sigmas->orientations.size(), 299u);
  EXPECT_GT(smoothing.sigmas->angular_velocities[150].x(), 1.5 * smoothing.sigmas->angular_velocities[225].x());
}

TEST(NodeSigmas, KnowWhatAGyroTellsAndThatItsBiasIsEstimated) {
  Recording recording = recorded(400, degree);
  Dice dice(9);
  for (const double t : recording.noisy.times) {
    recording.clean.angular_velocities.push_back(true_rate(t));
    recording.noisy.angular_velocities.emplace_back(true_rate(t) + 0.02 * normal_vector(dice));
  }
  const Keyframes keys = Keyframes::make(recording.noisy).value();
  const Smoothing with = smooth(keys, {.noise = degree, .gyro = true, .gyro_noise = 0.02, .sigma = true}).value(),
                  without = smooth(keys, {.noise = degree, .sigma = true}).value();
  EXPECT_LT(*with.rms_sigma(), 0.6 * *without.rms_sigma());
  Coverage coverage;
  coverage.add(with, recording.clean);
  EXPECT_GT(coverage.of_turns(), 0.75);  // one seed, and neighbours err alike
  EXPECT_GT(coverage.of_rates(), 0.85);
}

}}  // namespace orispline
