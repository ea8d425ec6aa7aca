// SPDX-License-Identifier: Apache-2.0
// Sampling on one thread allocates nothing.
#include <gtest/gtest.h>

#include <batch/sampled.hpp>
#include <batch/specimen_curves.hpp>
#include <curve/counting_new.hpp>

namespace orispline { namespace {

using namespace testing_support;

template <class T>
void expect_no_allocation(const AnyCurve& curve) {
  constexpr std::size_t count = 300;
  const CompiledCurve<T> compiled(curve);
  const std::vector<CompiledCurve<T>> curves(count, compiled);
  const double start = curve.domain().start, end = curve.domain().end;
  const double dt = (end - start) / 280.0;
  std::vector<double> times;
  for (std::size_t k = 0; k < count; ++k) times.push_back(static_cast<double>(k) * dt + start);
  Sampled<T> memory(count, Wanted::jerk);
  const Samples<T> out = memory.spans();

  const auto allocations_of = [](auto take) {
    const std::size_t before = allocations_of_this_thread();
    const bool taken = take().has_value();
    const std::size_t after = allocations_of_this_thread();
    EXPECT_TRUE(taken);
    return after - before;
  };
  EXPECT_EQ(allocations_of([&] { return sample<T>(curve, times, out); }), 0U);
  EXPECT_EQ(allocations_of([&] { return sample<T>(compiled, times, out); }), 0U);
  EXPECT_EQ(allocations_of([&] { return sample_uniform<T>(curve, start, dt, out); }), 0U);
  EXPECT_EQ(allocations_of([&] { return sample_uniform<T>(compiled, start, dt, out); }), 0U);
  EXPECT_EQ(allocations_of([&] { return sample_at<T>(compiled, times, out); }), 0U);
  EXPECT_EQ(allocations_of([&] { return sample_many<T>(curves, start + 0.4, out); }), 0U);
}

TEST(BatchAllocation, DoesNotHappenOnOneThread) {
  for (const auto& [name, curve] : curve_of_every_family(89)) {
    SCOPED_TRACE(name);
    expect_no_allocation<double>(curve);
    expect_no_allocation<float>(curve);
  }
}

}}  // namespace orispline
