// SPDX-License-Identifier: Apache-2.0
// A curve that swings away from its keys: told, with where and how far, and not where a motion is smooth.
#include <algorithm>

#include <gtest/gtest.h>

#include <orispline/families/method_warnings.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/degrees.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

std::optional<Warning> swing_told(const Method& method, Keyframes keys, bool with_curve = false) {
  const AnyCurve curve = make_curve(method, keys).value();
  const auto warnings = warnings_of(method, Track(std::move(keys)), with_curve ? &curve : nullptr);
  const auto found = std::ranges::find(warnings, "overshot_span", &Warning::code);
  return found == warnings.end() ? std::nullopt : std::optional(*found);
}

/// Turned to these angles [°] about one axis.
Keyframes at_angles(const std::vector<double>& times, const std::vector<double>& angles) {
  KeyframeData data{.times = times};
  for (const double angle : angles) data.orientations.push_back(about_z(angle * radians_per_degree));
  return keyframes(data);
}

/// An arm that goes up and back, stays nearly where it is, turns aside and stays nearly there.
Keyframes nearly_held() { return at_angles({0.0, 1.2, 2.0, 2.4, 2.6, 3.4}, {0.0, 10.0, 0.0, 0.05, 30.0, 30.05}); }

TEST(OvershotSpan, IsToldWhereACurveSwingsBetweenNearlyEqualKeys) {
  for (const bool with_curve : {false, true}) {
    const auto found = swing_told("auto", nearly_held(), with_curve);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->where.key, 4U);
    EXPECT_NEAR(found->number("step_deg"), 0.05, 1e-9);
    const AnyCurve curve = make_curve("auto", nearly_held()).value();
    double farthest = 0.0;
    for (double t = 2.6; t < 3.4; t += 1e-3)
      farthest =
          std::max(farthest, angular_distance(curve(t), about_z(30.05 * radians_per_degree)) / radians_per_degree);
    EXPECT_NEAR(found->number("swing_deg"), farthest, 0.02 * farthest);
    EXPECT_TRUE(found->message.starts_with("between the keys at 2.6 s and 3.4 s the curve of auto swings "))
        << found->message;
    EXPECT_NE(found->message.find("take monotone"), std::string::npos);
  }
}

TEST(OvershotSpan, IsNotToldOfMethodsThatStayNear) {
  for (const char* method : {"monotone", "slerp"}) EXPECT_FALSE(swing_told(method, nearly_held())) << method;
  EXPECT_FALSE(swing_told({"auto", {.parameters = {{"rest-angle", {0.1 * radians_per_degree}}}}},
                          at_angles({0.0, 1.0, 2.0, 3.0}, {0.0, 0.05, 90.0, 90.05})));
}

TEST(OvershotSpan, LeavesWhatTurnsMuchFartherToItsWarning) {
  const auto warnings =
      warnings_of("auto", Track(at_angles({0.0, 1.2, 2.0, 2.4, 2.6, 3.4}, {0.0, 30.0, 0.0, 0.05, 90.0, 90.05})));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].code, "overturned_span");
  EXPECT_NE(warnings[0].message.find("take monotone"), std::string::npos);
}

TEST(OvershotSpan, IsNotToldOfSmoothMotion) {
  for (const double keys_a_swing : {4.0, 6.0, 9.0, 20.0})  // of which some lie on either side of where it turns back
    for (const double phase : {0.0, 0.25, 0.5}) {
      std::vector<double> times, angles;
      for (int i = 0; i < 30; ++i) {
        times.push_back(0.1 * i);
        angles.push_back(40.0 * std::sin(2.0 * pi * (i + phase) / keys_a_swing));
      }
      for (const char* method : {"auto", "timed-c2", "global-c2"})
        EXPECT_FALSE(swing_told(method, at_angles(times, angles))) << method << ", " << keys_a_swing << ", " << phase;
    }
}

TEST(OvershotSpan, IsNotToldOfLessThanADegree) {
  EXPECT_FALSE(swing_told("auto", at_angles({0.0, 1.0, 2.0, 3.0, 4.0}, {0.0, 0.001, 2.0, 2.001, 2.002})));
}

TEST(OvershotSpan, LeavesEqualKeysToTheWarningOfRests) {
  const auto warnings = warnings_of("auto", Track(at_angles({0.0, 1.0, 2.0, 3.0}, {0.0, 0.0, 90.0, 90.0})));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].code, "moving_rests");
}

}}  // namespace orispline
