// SPDX-License-Identifier: Apache-2.0
// Rates of keys that turn otherwise than the keys do are told, with what they may be.
#include <gtest/gtest.h>

#include <orispline/families/method_warnings.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { namespace {

using Vector = Eigen::Vector3d;

/// Turns about z by 2 sin t, then about x by sin 3t, at 20 Hz; `meant` makes the rates of what they are in the body.
template <class Meant>
Track track_with(Meant meant) {
  KeyframeData data;
  for (int i = 0; i < 100; ++i) {
    const double t = 0.05 * i;
    const Eigen::Quaterniond second = exp<double>(Vector(std::sin(3.0 * t), 0.0, 0.0));
    const Eigen::Quaterniond q = exp<double>(Vector(0.0, 0.0, 2.0 * std::sin(t))) * second;
    const Vector body =
        to_body<double>(second, Vector(0.0, 0.0, 2.0 * std::cos(t))) + Vector(3.0 * std::cos(3.0 * t), 0.0, 0.0);
    data.times.push_back(t);
    data.orientations.push_back(q);
    data.angular_velocities.push_back(meant(q, body));
  }
  return Keyframes::make(std::move(data)).value();
}

std::string warning_of(const Track& track, std::string_view method) {
  const auto warnings = warnings_of(Method{method}, track);
  if (warnings.empty()) return "";
  EXPECT_EQ(warnings[0].code, "contradicting_rates");
  EXPECT_GT(warnings[0].number("misfit"), 0.25);
  return warnings[0].message;
}

TEST(ContradictingRates, AreToldWithWhatTheyMayBe) {
  const auto expect_cure = [](const Track& track, std::string_view cure) {
    for (const std::string_view method : {"hermite-c1", "hermite-c2", "hermite-cumulative"})
      EXPECT_NE(warning_of(track, method).find(cure), std::string::npos) << warning_of(track, method);
    EXPECT_EQ(warning_of(track, "auto"), "");  // which reads none
  };
  using Turn = Eigen::Quaterniond;
  expect_cure(track_with([](const Turn&, const Vector& w) { return Vector(-w); }), "with all signs reversed");
  expect_cure(track_with([](const Turn& q, const Vector& w) { return Vector(q * w); }), "`columns` wx_world=");
  expect_cure(track_with([](const Turn& q, const Vector& w) { return Vector(-(q * w)); }), "give `conjugate`");
  expect_cure(track_with([](const Turn&, const Vector& w) { return Vector(w / radians_per_degree); }), "end in _deg_s");
  expect_cure(track_with([](const Turn&, const Vector& w) { return Vector(w * radians_per_degree); }),
              "do not end in _deg_s");
  expect_cure(track_with([](const Turn& q, const Vector& w) { return Vector(q.conjugate() * w); }), "`columns` wx=");
  expect_cure(track_with([](const Turn&, const Vector& w) { return Vector(-w.y(), -w.z(), -w.x()); }),
              "x, y and z of the rates are -y, -z, -x of the body");
  expect_cure(track_with([](const Turn&, const Vector& w) { return Vector(0.5 * w); }), "divided by 0.5");
  expect_cure(track_with([](const Turn&, const Vector& w) {
                return Vector(3.0 * std::sin(100.0 * w.x()), 3.0 * std::sin(77.0 * w.y()), -3.0 * w.z());
              }),
              "wanted rates of the body in its own frame");
}

TEST(ContradictingRates, AreNeitherTrueOnesNorRests) {
  EXPECT_EQ(warning_of(track_with([](const auto&, const Vector& w) { return w; }), "hermite-c1"), "");
  EXPECT_EQ(warning_of(track_with([](const auto&, const Vector& w) { return Vector(1.3 * w); }), "hermite-c1"), "");
  EXPECT_EQ(warning_of(track_with([](const auto&, const Vector&) { return Vector(0.0, 0.0, 0.0); }), "hermite-c1"), "");
}

/// Turns about x by 2 sin t; `meant` makes the accelerations of the true ones, -2 sin t.
template <class Meant>
Track accelerated(Meant meant) {
  KeyframeData data;
  for (int i = 0; i < 100; ++i) {
    const double t = 0.1 * i;
    const Eigen::Quaterniond q = exp<double>(Vector(2.0 * std::sin(t), 0.0, 0.0));
    data.times.push_back(t);
    data.orientations.push_back(q);
    data.angular_velocities.emplace_back(2.0 * std::cos(t), 0.0, 0.0);
    data.angular_accelerations.push_back(meant(q, Vector(-2.0 * std::sin(t), 0.0, 0.0)));
  }
  return Keyframes::make(std::move(data)).value();
}

TEST(ContradictingAccelerations, AreThoseOfAnAccelerometer) {
  const Track measured =
      accelerated([](const auto& q, const Vector&) { return Vector(q.conjugate() * Vector(0.0, 0.0, 9.81)); });
  const auto warnings = warnings_of(Method{"hermite-c2"}, measured);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].code, "contradicting_accelerations");
  EXPECT_NEAR(warnings[0].number("largest_rate_rad_s"), 2.0, 1e-12);
  EXPECT_GT(warnings[0].number("summed_rad_s"), 20.0);
  EXPECT_NE(warnings[0].message.find("take hermite-c1"), std::string::npos) << warnings[0].message;
  EXPECT_TRUE(warnings_of(Method{"hermite-c1"}, measured).empty());  // which reads none
}

TEST(ContradictingAccelerations, AreNeitherTrueOnesNorNoisyOnes) {
  EXPECT_TRUE(warnings_of(Method{"hermite-c2"}, accelerated([](const auto&, const Vector& a) { return a; })).empty());
  int sign = 1;
  const Track noisy =
      accelerated([&](const auto&, const Vector& a) { return Vector(a.x() + 20.0 * (sign = -sign), 0.0, 0.0); });
  EXPECT_TRUE(warnings_of(Method{"hermite-c2"}, noisy).empty());
}

}}  // namespace orispline
