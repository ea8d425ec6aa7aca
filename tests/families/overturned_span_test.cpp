// SPDX-License-Identifier: Apache-2.0
// A curve that turns much farther than its keys: told, with the two keys that are too near in time.
#include <algorithm>

#include <gtest/gtest.h>

#include <orispline/families/method_warnings.hpp>
#include <orispline/families/registry.hpp>
#include <support/random_motion.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

std::optional<Warning> told(std::string_view method, Keyframes keys) {
  const auto warnings = warnings_of(method, Track(std::move(keys)));
  const auto found = std::ranges::find(warnings, "overturned_span", &Warning::code);
  return found == warnings.end() ? std::nullopt : std::optional(*found);
}

/// A steady turn, half a radian a second, whose fourth key comes so much before the fifth one.
Keyframes steady_but_for_one_key(double before) {
  KeyframeData data;
  for (int i = 0; i < 9; ++i) {
    data.times.push_back(i);
    data.orientations.push_back(about_z(0.5 * i));
  }
  data.times[3] = data.times[4] - before;
  return keyframes(data);
}

TEST(OverturnedSpan, IsToldWithTheTwoKeysThatAreTooNear) {
  for (const char* method : {"auto", "hermite-c2", "timed-c2", "tcb", "shoemake"}) {
    const auto found = told(method, steady_but_for_one_key(0.01));
    ASSERT_TRUE(found) << method;
    EXPECT_EQ(found->where.key, 3U) << method;
    EXPECT_GT(found->number("turn_deg"), 2.0 * found->number("turn_of_keys_deg"));
    EXPECT_NE(found->message.find("the keys at 3.99 s and 4 s are too near in time"), std::string::npos)
        << found->message;
  }
}

TEST(OverturnedSpan, SaysThatAMethodCannotBeUsedWhereItsCurveGoesRoundAndRound) {
  for (const char* method : {"auto", "timed-c2", "log-parabola"}) {
    const auto found = told(method, steady_but_for_one_key(1e-5));
    ASSERT_TRUE(found) << method;
    EXPECT_TRUE(found->message.starts_with(std::string(method) + " cannot be used on these keys: between the keys at "))
        << found->message;
    EXPECT_TRUE(found->message.ends_with("or take slerp or squad, which can be used whatever the times are"))
        << found->message;
  }
  for (const char* usable : {"slerp", "squad"}) EXPECT_FALSE(told(usable, steady_but_for_one_key(1e-5))) << usable;
}

TEST(OverturnedSpan, IsNotToldWhereTheCurveTurnsAsItsKeysDo) {
  for (const char* method : {"auto", "hermite-c2", "timed-c2", "tcb"}) {
    EXPECT_FALSE(told(method, steady_but_for_one_key(1.0))) << method;
    EXPECT_FALSE(told(method, random_keys(5, {400, 0.5, 3.0}))) << method;
  }
  EXPECT_FALSE(told("slerp", steady_but_for_one_key(0.001)));
  EXPECT_FALSE(told("bspline", steady_but_for_one_key(0.001)));
}

TEST(OverturnedSpan, IsFoundFarFromTheStartOfManyKeys) {
  KeyframeData data;
  for (int i = 0; i < 2000; ++i) {
    data.times.push_back(i);
    data.orientations.push_back(about_z(0.4 * i));
  }
  data.times[1500] = 1500.995;
  const auto found = told("auto", keyframes(data));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->where.key, 1500U);
}

}}  // namespace orispline
