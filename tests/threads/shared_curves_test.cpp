// SPDX-License-Identifier: Apache-2.0
// One curve shared by several threads gives every one of them what it gives to one alone.
#include <thread>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

std::vector<double> samples_of(const AnyCurve& curve, const std::vector<double>& times) {
  std::vector<double> samples;
  for (const double t : times) {
    const Motion m = curve.motion(t);
    samples.insert(samples.end(), {m.orientation.w(), m.orientation.x(), m.angular_velocity.y(), m.angular_jerk.z()});
  }
  return samples;
}

TEST(Threads, ShareACurveAndItsCopies) {
  const Keyframes keys = keyframes(random_walk(221, 22, Spacing::uneven, 0.8));
  const std::vector<double> times = sample_times(keys.times(), 50);
  for (const FamilyInfo& family : families_info()) {
    const AnyCurve curve = make_curve(family.name, keys).value();
    const std::vector<double> alone = samples_of(curve, times);

    std::vector<std::vector<double>> together(4);
    std::vector<std::thread> threads;
    for (std::vector<double>& result : together)
      threads.emplace_back([&result, &times, copy = curve] { result = samples_of(copy, times); });
    for (std::thread& thread : threads) thread.join();

    for (const std::vector<double>& result : together) EXPECT_EQ(result, alone) << family.name;
  }
}

}}  // namespace orispline
