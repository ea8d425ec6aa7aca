// SPDX-License-Identifier: Apache-2.0
// Where memory ends, std::bad_alloc comes out of functions that are not noexcept, on any number of threads; those that
// are noexcept want no memory, or this program would end.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/analysis.hpp>
#include <orispline/orispline.hpp>
#include <orispline/sampling.hpp>
#include <out_of_memory/failing_new.hpp>
#include <support/tracks.hpp>
#if defined(ORISPLINE_TEST_TASKS)
#include <orispline/align.hpp>
#include <orispline/files.hpp>
#include <orispline/mean.hpp>
#include <orispline/reduce.hpp>
#include <orispline/retime.hpp>
#include <orispline/smooth.hpp>
#include <orispline/tune.hpp>

#include "support/places.hpp"
#endif

namespace orispline { namespace {

using namespace testing_support;

/// Runs the work with memory for ever more allocations, some dozens of cases, until it is done.
template <class Work>
void expect_bad_alloc_alone(std::string_view name, Work work) {
  long allowed = 0;
  while (allowed < 10'000'000 && with_allocations(allowed, work) == Ending::out_of_memory) allowed += 1 + allowed / 8;
  EXPECT_GT(allowed, 0) << name << " allocates nothing: test another work";
  EXPECT_LT(allowed, 10'000'000) << name;
}

Keyframes walk(std::size_t count) { return keyframes(posed_walk(77, count, testing_support::Spacing::uneven, 0.5)); }

TEST(OutOfMemory, MakesNoCurveAndEndsNoProgram) {
  const Keyframes keys = walk(10);
  for (const FamilyInfo& family : families_info())
    expect_bad_alloc_alone(family.name, [&] { EXPECT_TRUE(make_pose_curve(family.name, keys)) << family.name; });
  const AnyCurve curve = make_curve("auto", keys).value();
  expect_bad_alloc_alone("compile", [&] { static_cast<void>(CompiledCurve<double>(curve)); });
  expect_bad_alloc_alone("bake", [&] { EXPECT_TRUE(bake<float>(curve, 1e-4)); });
}

TEST(OutOfMemory, ComesOutOfOtherThreads) {
  for (const unsigned threads : {1U, 4U})
    expect_bad_alloc_alone("parallel_for", [threads] {
      parallel_for(16, threads, [](std::size_t i) { std::vector<std::size_t>(i + 1, i).push_back(i); });
    });
}

TEST(OutOfMemory, LeavesWhatNeedsNoMemory) {
  const AnyCurve curve = make_curve("timed-c2", walk(6)).value();
  const CompiledCurve<double> compiled(curve);
  std::vector<double> numbers(400);
  const std::vector<double> times(100, 0.5);
  double sum = 0.0;
  const Ending ending = with_allocations(0, [&] {
    sum += curve.motion(0.5).angular_jerk.x() + compiled(0.5).w() + curve.domain().end;
    sum += static_cast<double>(families_info().size() + measures_info().size() + name_of(EndRule::natural).size());
    if (!sample(compiled, times, Samples<double>{.orientations = numbers})) sum = 0.0;
  });
  EXPECT_EQ(ending, Ending::done) << sum;
  EXPECT_NEAR(numbers[3], curve(0.5).w(), 1e-12);
}

TEST(OutOfMemory, EndsMeasures) {
  const Keyframes keys = walk(20);
  const RecordedMotion recording{keys.times(), keys.orientations()};
  const Candidate candidate{.method = "timed-c1", .keys = keys};
  expect_bad_alloc_alone("measure", [&] { EXPECT_TRUE(measure(candidate, recording)); });
}

#if defined(ORISPLINE_TEST_TASKS)
TEST(OutOfMemory, EndsTasks) {
  const Track track = walk(12);
  const ReduceOptions reduction{.tolerance = {.angle = 0.1}};
  expect_bad_alloc_alone("reduce", [&] { EXPECT_TRUE(reduce(track, "timed-c1", reduction)); });
  expect_bad_alloc_alone("retime", [&] { EXPECT_TRUE(retime(track, "timed-c2", {.limits = {.rate = 0.1}})); });
  expect_bad_alloc_alone("smooth", [&] { EXPECT_TRUE(smooth(track, {.noise = 0.01})); });
  expect_bad_alloc_alone("align", [&] { EXPECT_TRUE(align(track, track, {.offset = 0.0})); });
  const Keyframes& keys = track.keys;
  expect_bad_alloc_alone("mean", [&] { EXPECT_TRUE(mean({keys.orientations(), keys.positions(), {}})); });
  expect_bad_alloc_alone("tune", [&] { EXPECT_TRUE(tune(track, "timed-c2")); });
}

TEST(OutOfMemory, EndsReading) {
  const std::string path = testing_support::in_project("examples/data/five_keys.csv");
  expect_bad_alloc_alone("read_track", [&] { EXPECT_TRUE(io::read_track(path)); });
}
#endif

}}  // namespace orispline
