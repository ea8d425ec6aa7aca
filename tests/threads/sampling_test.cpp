// SPDX-License-Identifier: Apache-2.0
// The number of threads changes no bit; every part of the work is done once.
#include <atomic>

#include <gtest/gtest.h>

#include <batch/sampled.hpp>
#include <batch/specimen_curves.hpp>
#include <orispline/base/parallel.hpp>

namespace orispline { namespace {

using namespace testing_support;

TEST(ParallelFor, DoesEveryPartOnce) {
  for (const unsigned threads : {0U, 1U, 2U, 3U, 8U})
    for (const std::size_t count : {0U, 1U, 2U, 7U, 1000U}) {
      std::vector<std::atomic<int>> done(count + 1);
      parallel_for(count, threads, [&](std::size_t i) { ++done.at(i); });
      for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(done[i], 1) << i << " of " << count << ", " << threads;
      EXPECT_EQ(done[count], 0);
    }
}

// More than three parts of work, the last one not whole.
constexpr std::size_t several_parts = 3 * 65536 + 1001;

template <class Take>
void expect_the_same_with_any_threads(Take take) {
  Sampled<double> alone(several_parts, Wanted::jerk);
  ASSERT_TRUE(take(alone.spans(), Work{.threads = 1}));
  for (const unsigned threads : {0U, 2U, 3U, 8U}) {
    Sampled<double> together(several_parts, Wanted::jerk);
    ASSERT_TRUE(take(together.spans(), Work{.threads = threads}));
    EXPECT_TRUE(together.same_bits(alone)) << threads << " threads";
  }
}

TEST(BatchThreads, ChangeNoBit) {
  for (const char* kind : {"timed-c2", "auto", "squad"}) {
    SCOPED_TRACE(kind);
    const AnyCurve curve = specimen_curve(kind, 83, 40);
    const CompiledCurve<> compiled(curve);
    const double start = curve.domain().start, end = curve.domain().end;
    const double dt = (end - start) / (0.9 * static_cast<double>(several_parts));
    std::vector<double> times;
    for (std::size_t k = 0; k < several_parts; ++k) times.push_back(start + dt * static_cast<double>(k));
    expect_the_same_with_any_threads(
        [&](const auto& out, Work work) { return sample_uniform<double>(curve, start, dt, out, work); });
    expect_the_same_with_any_threads(
        [&](const auto& out, Work work) { return sample<double>(compiled, times, out, work); });
    expect_the_same_with_any_threads(
        [&](const auto& out, Work work) { return sample_at<double>(compiled, times, out, work); });
  }
}

}}  // namespace orispline
