// SPDX-License-Identifier: Apache-2.0
#include <orispline/align.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <orispline/math/median.hpp>
#include <orispline/smooth/smoothing_element.hpp>

#include "two_recordings.hpp"

namespace orispline { namespace {

using testing_support::Difference;
using testing_support::fixed_recording;
using testing_support::moved_recording;
using testing_support::Taken;

/// Errors of several simulated pairs in units of the standard deviations that were stated.
struct Deviations {
  std::vector<double> offset, angle;
  double rms(const std::vector<double>& of) const {
    double sum = 0.0;
    for (const double x : of) sum += x * x;
    return std::sqrt(sum / static_cast<double>(of.size()));
  }
};

Deviations deviations_of(const Taken& taken, std::size_t pairs) {
  Deviations deviations;
  for (std::size_t seed = 0; seed < pairs; ++seed) {
    std::mt19937_64 random(seed);
    Difference truth;
    truth.offset = std::uniform_real_distribution<double>(0.0, 0.3)(random);
    const auto found = align(moved_recording(taken, truth, random), fixed_recording(taken, random));
    EXPECT_TRUE(found) << describe(found.error());
    if (!found) continue;
    deviations.offset.push_back((found->offset.to_double() - truth.offset) / found->sigmas.offset);
    const Eigen::Vector3d turn = shortest_increment(found->world.conjugate(), truth.world.conjugate());
    for (Eigen::Index k = 0; k < 3; ++k) deviations.angle.push_back(turn[k] / found->sigmas.world[k]);
  }
  return deviations;
}

/// The standard deviations that are stated are those of the errors, within a third.
TEST(AlignmentAccuracy, IsWhatItIsStatedToBe) {
  const Deviations d = deviations_of({.to = 12.0, .noise = 0.5 * degree}, 12);
  EXPECT_LE(d.rms(d.offset), 1.6);
  EXPECT_LE(d.rms(d.angle), 1.6);
  EXPECT_GE(d.rms(d.angle), 0.5);
}

TEST(AlignmentAccuracy, IsNotHarmedByATenthOfWildSamplesInBothRecordings) {
  for (std::size_t seed = 0; seed < 4; ++seed) {
    std::mt19937_64 random(seed);
    const Difference truth;
    const Taken taken{.to = 12.0, .noise = 0.5 * degree, .position_noise = 0.02, .wild = 0.1, .has_positions = true};
    const auto found = align(moved_recording(taken, truth, random), fixed_recording(taken, random));
    ASSERT_TRUE(found) << describe(found.error());
    EXPECT_LE(angular_distance(found->world, truth.world), 0.3 * degree);
    EXPECT_LE(angular_distance(found->body, truth.body), 0.3 * degree);
    EXPECT_NEAR(found->offset.to_double(), truth.offset, 2e-3);
    EXPECT_NEAR(found->scale.value(), truth.scale, 0.02 * truth.scale);
    EXPECT_GE(found->rejected.size(), found->compared.size() / 20);
  }
}

/// Interpolated noise is less between two samples than at them: that does not draw the offset to half of an interval.
TEST(AlignmentAccuracy, DoesNotDependOnWhereSamplesLie) {
  std::vector<double> errors;
  for (const double offset : {0.0, 0.0025, 0.005, 0.0075, 0.01, 0.013}) {
    std::mt19937_64 random(11);
    const Difference truth{.offset = offset};
    const Taken taken{.rate = 100.0, .to = 12.0, .noise = 0.5 * degree};
    const auto found = align(moved_recording(taken, truth, random), fixed_recording(taken, random));
    ASSERT_TRUE(found) << describe(found.error());
    errors.push_back(std::abs(found->offset.to_double() - offset));
  }
  EXPECT_LE(median(errors), 5e-4);
  EXPECT_LE(*std::ranges::max_element(errors), 1e-3);
}

}}  // namespace orispline
