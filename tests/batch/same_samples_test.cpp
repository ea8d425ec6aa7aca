// SPDX-License-Identifier: Apache-2.0
// Whichever way a sample is asked for, it has the same bits.
#include <gtest/gtest.h>

#include <batch/sampled.hpp>
#include <batch/specimen_curves.hpp>

namespace orispline { namespace {

using namespace testing_support;

template <class T>
struct Grid {
  double t0, dt;
  std::vector<double> times;

  /// Over the whole domain and a little beyond it.
  Grid(const AnyCurve& curve, std::size_t count) {
    const double start = curve.domain().start, end = curve.domain().end;
    dt = 1.02 * (end - start) / static_cast<double>(count);
    t0 = start - 0.01 * (end - start);
    for (std::size_t k = 0; k < count; ++k) times.push_back(static_cast<double>(k) * dt + t0);
  }
};

template <class T>
void expect_the_same_by_every_door(const AnyCurve& curve, std::size_t count, Wanted wanted) {
  const Grid<T> grid(curve, count);
  const CompiledCurve<T> compiled(curve);
  Sampled<T> reference(count, wanted);
  ASSERT_TRUE(sample<T>(curve, grid.times, reference.spans()));
  const auto expect_same = [&](const char* door, auto take) {
    Sampled<T> samples(count, wanted);
    ASSERT_TRUE(take(samples.spans()));
    EXPECT_TRUE(samples.same_bits(reference)) << door << ", " << count << " samples";
  };
  expect_same("sample, compiled", [&](const Samples<T>& out) { return sample<T>(compiled, grid.times, out); });
  expect_same("sample_uniform", [&](const Samples<T>& out) { return sample_uniform<T>(curve, grid.t0, grid.dt, out); });
  expect_same("sample_uniform, compiled",
              [&](const Samples<T>& out) { return sample_uniform<T>(compiled, grid.t0, grid.dt, out); });
  expect_same("sample_at", [&](const Samples<T>& out) { return sample_at<T>(curve, grid.times, out); });
  expect_same("sample_at, compiled", [&](const Samples<T>& out) { return sample_at<T>(compiled, grid.times, out); });
}

class BatchDoors : public testing::TestWithParam<Wanted> {};

TEST_P(BatchDoors, GiveTheSameBits) {
  for (const auto& [name, curve] : curve_of_every_family(71)) {
    SCOPED_TRACE(name);
    for (const std::size_t count : {1U, 10U, 1000U}) {
      expect_the_same_by_every_door<double>(curve, count, GetParam());
      expect_the_same_by_every_door<float>(curve, count, GetParam());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, BatchDoors,
                         testing::Values(Wanted::orientation, Wanted::velocity, Wanted::acceleration, Wanted::jerk),
                         [](const auto& test) { return "wanted_" + std::to_string(test.index); });

template <class T>
void expect_one_by_one_the_same(const AnyCurve& curve) {
  const Grid<T> grid(curve, 97);
  const CompiledCurve<T> compiled(curve);
  Sampled<T> samples(97, Wanted::orientation);
  ASSERT_TRUE(sample<T>(curve, grid.times, samples.spans()));
  for (std::size_t i = 0; i < 97; ++i)
    EXPECT_EQ(compiled(grid.times[i]).coeffs().template cast<double>(), samples.orientation(i)) << i;
}

TEST(BatchDoors, OneSampleIsAsOneOfMany) {
  for (const auto& [name, curve] : curve_of_every_family(73)) {
    SCOPED_TRACE(name);
    expect_one_by_one_the_same<double>(curve);
    expect_one_by_one_the_same<float>(curve);
  }
}

/// `place(i)` is where the i-th of the times to be asked for stands among 500 that rise.
template <class Place>
void expect_the_samples_of_the_same_times(const AnyCurve& curve, Place place) {
  const CompiledCurve<> compiled(curve);
  const Grid<double> grid(curve, 500);
  std::vector<double> times;
  for (std::size_t i = 0; i < 500; ++i) times.push_back(grid.times[place(i)]);
  Sampled<double> sorted(500, Wanted::jerk), any(500, Wanted::jerk), from_compiled(500, Wanted::jerk);
  ASSERT_TRUE(sample<double>(curve, grid.times, sorted.spans()));
  ASSERT_TRUE(sample_at<double>(curve, times, any.spans()));
  ASSERT_TRUE(sample_at<double>(compiled, times, from_compiled.spans()));
  EXPECT_TRUE(from_compiled.same_bits(any));
  for (std::size_t i = 0; i < 500; ++i) {
    ASSERT_EQ(any.orientation(i), sorted.orientation(place(i))) << i;
    ASSERT_EQ(any.acceleration(i), sorted.acceleration(place(i))) << i;
    ASSERT_EQ(any.jerk(i), sorted.jerk(place(i))) << i;
  }
}

TEST(BatchDoors, TimesInAnyOrderGiveTheSamplesOfThoseTimes) {
  for (const char* kind : kinds_of_curves) {
    SCOPED_TRACE(kind);
    const AnyCurve curve = specimen_curve(kind);
    expect_the_samples_of_the_same_times(curve, [](std::size_t i) { return (i * 137) % 500; });
    expect_the_samples_of_the_same_times(curve, [](std::size_t i) { return 499 - i; });
    expect_the_samples_of_the_same_times(curve, [](std::size_t i) { return i ^ 3U; });  // mostly within a segment
  }
}

TEST(BatchDoors, ManyCurvesGiveEachItsOwnSample) {
  std::vector<CompiledCurve<>> curves;
  for (const auto& named : curve_of_every_family(79)) curves.emplace_back(named.curve);
  for (const double t : {-3.0, 0.37, 1.9, 1e6}) {
    Sampled<double> together(curves.size(), Wanted::jerk, Layout::planar);
    ASSERT_TRUE(sample_many<double>(curves, t, together.spans()));
    for (std::size_t i = 0; i < curves.size(); ++i) {
      Sampled<double> alone(1, Wanted::jerk);
      ASSERT_TRUE(sample<double>(curves[i], {&t, 1}, alone.spans()));
      EXPECT_EQ(together.orientation(i), alone.orientation(0)) << i;
      EXPECT_EQ(together.velocity(i), alone.velocity(0)) << i;
      EXPECT_EQ(together.acceleration(i), alone.acceleration(0)) << i;
      EXPECT_EQ(together.jerk(i), alone.jerk(0)) << i;
    }
  }
}

}}  // namespace orispline
