// SPDX-License-Identifier: Apache-2.0
// After construction an online curve allocates nothing: not for a key, not for a value, not for the end nor a new
// start.
#include <gtest/gtest.h>

#include <curve/counting_new.hpp>
#include <online/online_stream.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { namespace {

using namespace testing_support;

TEST(OnlineCurve, AllocatesNothingAfterConstruction) {
  const KeyframeData data = raw_walk(601, 200);
  std::size_t in_place = 0;
  for (const std::string_view method : OnlineCurve::methods()) {
    if (OnlineCurve::make(method, 20).value().allocates()) continue;
    ++in_place;
    for (const EndRule rule :
         find_family(method).value()->ends.empty()
             ? std::vector{EndRule::none}
             : std::vector(find_family(method).value()->ends.begin(), find_family(method).value()->ends.end())) {
      OnlineCurve curve = OnlineCurve::make({method, {.start = {.rule = rule}, .end = {.rule = rule}}}, 20).value();
      double sum = 0.0;
      std::size_t refused = 0;

      const std::size_t before = allocations_of_this_thread();
      for (int stream = 0; stream < 2; ++stream) {
        curve.reset();
        for (std::size_t i = 0; i < data.times.size(); ++i) {
          refused += curve.append(data.times[i], data.orientations[i], data.positions[i]) ? 0 : 1;
          const Domain domain = curve.available().value();
          for (const double t : {domain.start - 1.0, 0.5 * (domain.start + domain.end), domain.end - 0.01, 1e9})
            sum += curve(t).w() + curve.motion(t).angular_jerk.x() + curve.linear_motion(t)->velocity.x();
          sum += curve.checked_motion(domain.end).value().angular_velocity.x();
        }
        refused += curve.finish() ? 0 : 1;
      }
      const std::size_t after = allocations_of_this_thread();

      EXPECT_EQ(after, before) << method << ", ends " << name_of(rule) << ", checksum " << sum;
      EXPECT_EQ(refused, 0u);
    }
  }
  EXPECT_GE(in_place, 11u);  // slerp and the families of four keys
}

TEST(OnlineCurve, AllocatesNothingWhenItIsEvaluated) {
  const KeyframeData data = raw_walk(602, 30);
  for (const std::string_view method : OnlineCurve::methods()) {
    OnlineCurve curve = OnlineCurve::make(method, 20).value();
    ASSERT_TRUE(append(curve, data, 0, 30));
    const Domain domain = curve.available().value();
    double sum = 0.0;
    const std::size_t before = allocations_of_this_thread();
    for (int k = -5; k <= 105; ++k) {
      const double t = domain.start + (domain.end - domain.start) * k / 100.0;
      sum += curve(t).w() + curve.motion(t).angular_jerk.x() + curve.linear_motion(t)->velocity.x();
    }
    EXPECT_EQ(allocations_of_this_thread(), before) << method << ", checksum " << sum;
  }
}

}}  // namespace orispline
