// SPDX-License-Identifier: Apache-2.0
// Curves that several threads make, measure and bake at the same moment are those that one makes.
#include <gtest/gtest.h>

#include <batch/specimen_curves.hpp>
#include <orispline/analysis/comparison.hpp>
#include <orispline/batch/baked_curve.hpp>
#include <support/together.hpp>

namespace orispline { namespace {

using namespace testing_support;

constexpr std::size_t racing_threads = 4;

std::vector<double> components(const AnyCurve& curve) {
  std::vector<double> all;
  for (const double t : sample_times(curve.knots().times(), 5)) {
    const Motion m = curve.motion(t);
    for (const double component : m.orientation.coeffs()) all.push_back(component);
    for (const double component : m.angular_jerk) all.push_back(component);
  }
  return all;
}

// First of all in this program, so that what is computed once and kept is computed by threads that race for it.
TEST(MadeAtOnce, AreTheCurvesOfEveryFamily) {
  std::vector<std::vector<NamedCurve>> made(racing_threads);
  together(racing_threads, [&](std::size_t i) { made[i] = curve_of_every_family(421); });
  const std::vector<NamedCurve> alone = curve_of_every_family(421);
  for (const std::vector<NamedCurve>& curves : made)
    for (std::size_t k = 0; k < alone.size(); ++k)
      EXPECT_EQ(components(curves.at(k).curve), components(alone[k].curve)) << alone[k].name;
}

TEST(MadeAtOnce, AreBakedCurves) {
  const AnyCurve curve = specimen_curve("auto", 422);
  const auto knots_of = [&] {
    const auto baked = bake(curve, 1e-7);
    const auto times = baked.value().knots().times();
    return std::vector<double>(times.begin(), times.end());
  };
  std::vector<std::vector<double>> made(racing_threads);
  together(racing_threads, [&](std::size_t i) { made[i] = knots_of(); });
  for (const std::vector<double>& knots : made) EXPECT_EQ(knots, knots_of());
}

TEST(Compare, MeasuresEveryMethodOnManyThreads) {
  const AnyCurve motion = specimen_curve("timed-c3", 423, 25);
  const std::vector<double> times = sample_times(motion.knots().times(), 6);
  std::vector<Eigen::Quaterniond> orientations;
  for (const double t : times) orientations.push_back(motion(t));
  const Keyframes keys = keyframes(random_walk(423, 25, Spacing::uneven, 0.7));
  std::vector<Candidate> candidates;
  for (const FamilyInfo& family : families_info()) candidates.push_back({.method = family.name, .keys = keys});

  const RecordedMotion recording{.times = times, .orientations = orientations};
  const Comparison one = compare(candidates, recording);
  const Comparison many = compare(candidates, recording, {}, 8);
  EXPECT_TRUE(one.any());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    ASSERT_EQ(one.measures[i].has_value(), many.measures[i].has_value()) << candidates[i].method.name;
    if (!one.measures[i]) continue;
    EXPECT_EQ(one.measures[i]->distance.rms, many.measures[i]->distance.rms) << candidates[i].method.name;
    EXPECT_EQ(one.measures[i]->energies.acceleration, many.measures[i]->energies.acceleration);
    EXPECT_EQ(one.measures[i]->peaks.angular_velocity.value, many.measures[i]->peaks.angular_velocity.value);
  }
}

}}  // namespace orispline
