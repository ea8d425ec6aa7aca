// SPDX-License-Identifier: Apache-2.0
// The setting rest-angle: nearly equal keys are a rest, for the methods that have it, and it is typed with a unit.
#include <gtest/gtest.h>

#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/degrees.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

std::vector<std::string> methods_with(std::string_view setting) {
  std::vector<std::string> names;
  for (const FamilyInfo& family : families_info())
    if (has_name(family.parameters, setting)) names.emplace_back(family.name);
  return names;
}

/// Two holds, of which the keys are 0.05° and 0.2° apart, about different axes.
Keyframes two_holds() {
  KeyframeData data{.times = {0.0, 1.0, 1.7, 2.5, 3.5, 4.0}};
  data.orientations = {about_z(0.0), about_z(0.05 * radians_per_degree)};
  for (const Eigen::Quaterniond& step : {about_x(1.2), about_z(0.2 * radians_per_degree), about_z(0.9), about_x(-0.4)})
    data.orientations.push_back(data.orientations.back() * step);
  return keyframes(data);
}

double rate_at(const Method& method, double t) {
  return make_curve(method, two_holds()).value().motion(t).angular_velocity.norm();
}

TEST(RestAngle, MakesKeysRestThatTurnNoFarther) {
  ASSERT_EQ(methods_with("rest-angle"), (std::vector<std::string>{"auto", "auto5", "monotone"}));
  for (const std::string& name : methods_with("rest-angle")) {
    const Method narrow = method_from_text(name + ":rest-angle=0.1deg").value(),
                 wide = method_from_text(name + ":rest-angle=0.3deg").value();
    for (const double t : {0.0, 1.0}) EXPECT_EQ(rate_at(narrow, t), 0.0) << name << t;
    for (const double t : {1.7, 2.5}) {
      EXPECT_GT(rate_at(narrow, t), 1e-4) << name << t;
      EXPECT_EQ(rate_at(wide, t), 0.0) << name << t;
    }
    EXPECT_GT(rate_at(wide, 3.5), 0.1) << name;
  }
}

TEST(RestAngle, LeavesThePoseOfARestByNoMoreThanItsStep) {
  for (const std::string& name : methods_with("rest-angle")) {
    const AnyCurve curve = make_curve(method_from_text(name + ":rest-angle=0.1deg").value(), two_holds()).value();
    for (double t = 0.0; t <= 1.0; t += 1.0 / 64.0) {
      const double angle = increment<double>(Eigen::Quaterniond::Identity(), curve(t)).z() / radians_per_degree;
      EXPECT_GE(angle, -1e-12) << name << t;
      EXPECT_LE(angle, 0.05 + 1e-12) << name << t;
    }
  }
}

TEST(RestAngle, LeavesHoldItsMeaning) {
  for (const std::string& name : methods_with("hold")) {
    EXPECT_GT(rate_at(method_from_text(name + ":hold=1").value(), 1.0), 1e-4) << name;
    const AnyCurve plain = make_curve(name, two_holds()).value(),
                   none = make_curve(method_from_text(name + ":rest-angle=0").value(), two_holds()).value();
    for (const double t : sample_times(plain.knots().times(), 4))
      EXPECT_EQ(plain(t).coeffs(), none(t).coeffs()) << name << t;
  }
}

TEST(RestAngle, IsTypedWithAUnitAndWrittenInRadians) {
  const auto value = [](const char* text) {
    return method_from_text(text).value().options.parameters.at("rest-angle").at(0);
  };
  EXPECT_DOUBLE_EQ(value("auto:rest-angle=0.1deg"), 0.1 * radians_per_degree);
  EXPECT_DOUBLE_EQ(value("auto:rest-angle=0.1°"), 0.1 * radians_per_degree);
  EXPECT_DOUBLE_EQ(value("auto:rest-angle=2mrad"), 0.002);
  EXPECT_DOUBLE_EQ(value("auto:rest-angle=36arcsec"), 0.01 * radians_per_degree);
  EXPECT_DOUBLE_EQ(value("auto:rest-angle=0.002rad"), 0.002);
  EXPECT_DOUBLE_EQ(value("auto:rest-angle=0.002"), 0.002);
  EXPECT_DOUBLE_EQ(value("auto:rest_angle=0.002"), 0.002);
  EXPECT_EQ(text_of(method_from_text("monotone:rest-angle=2mrad").value()), "monotone:rest-angle=0.002");
  for (const char* wrong : {"auto:rest-angle=0.1s", "auto:rest-angle=deg", "auto:rest-angle=soon"})
    EXPECT_EQ(method_from_text(wrong).error().message.substr(0, 6), "found ") << wrong;
  EXPECT_EQ(method_from_text("auto:rest-angle=0.1s").error().message,
            "found '0.1s', wanted an angle such as 1deg or 0.02rad");
  EXPECT_FALSE(method_from_text("timed-c2:tension=0.1deg"));
}

TEST(RestAngle, IsRefusedBeyondItsRange) {
  for (const char* text : {"auto:rest-angle=-1deg", "auto:rest-angle=181deg", "monotone:rest-angle=nan"}) {
    const auto method = method_from_text(text);
    const auto curve = method ? make_curve(*method, two_holds()) : Expected<AnyCurve>(tl::unexpected(method.error()));
    ASSERT_FALSE(curve) << text;
    EXPECT_EQ(curve.error().code, ErrorCode::bad_argument) << text;
  }
}

}}  // namespace orispline
