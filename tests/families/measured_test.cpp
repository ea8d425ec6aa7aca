// SPDX-License-Identifier: Apache-2.0
// measured: agreement with the reference, and what its page promises.
#include <gtest/gtest.h>

#include <orispline/families/measured.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/online/online_curve.hpp>
#include <support/data_table.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

/// The reference is double precision itself, with an inverse of 11 rows where the library has a factor of 7.
constexpr double measured_orientation = 1e-12, measured_velocity = 1e-11, measured_acceleration = 1e-9;

KeyframeData keys_of(const DataTable& table, const std::string& name) {
  KeyframeData data;
  for (const auto& key : table.rows_where("sequence", name)) {
    data.times.push_back(key.number("t"));
    data.orientations.push_back(key.quaternion("qw", "qx", "qy", "qz"));
  }
  return data;
}

AnyCurve measured_curve(const KeyframeData& data, const Method& method = "measured") {
  return make_curve(method, Keyframes::make(data).value()).value();
}

KeyFindings findings_of(const KeyframeData& data) {
  return key_findings("measured", Keyframes::make(data).value()).value().value();
}

KeyframeData backwards(const KeyframeData& data) {
  KeyframeData reversed;
  for (std::size_t i = data.times.size(); i-- > 0;) {
    reversed.times.push_back(-data.times[i]);
    reversed.orientations.push_back(data.orientations[i]);
  }
  return reversed;
}

/// A walk with noise of this size at its keys [rad].
KeyframeData noisy_walk(std::uint64_t seed, std::size_t keys, Spacing spacing, double step, double noise) {
  KeyframeData data = random_walk(seed, keys, spacing, step);
  Dice dice(seed + 1);
  for (auto& q : data.orientations)
    q = q * exp<double>(noise * Eigen::Vector3d(dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1)));
  return data;
}

TEST(Measured, AgreesWithTheReferenceInEveryRow) {
  const DataTable keys("golden/measured_keys.csv"), rows("golden/measured.csv");
  ASSERT_EQ(rows.size(), 668u);
  std::map<std::string, AnyCurve> curves;
  for (const auto& row : rows.rows()) {
    const std::string name(row.text("sequence"));
    if (!curves.contains(name)) curves.emplace(name, measured_curve(keys_of(keys, name)));
    const Motion m = curves.at(name).motion(row.number("t"));
    EXPECT_LE(relative_error(m.orientation, row.quaternion("qw", "qx", "qy", "qz")), measured_orientation) << name;
    EXPECT_LE(relative_error(m.angular_velocity, row.vector("wx", "wy", "wz")), measured_velocity) << name;
    EXPECT_LE(relative_error(m.angular_acceleration, row.vector("ax", "ay", "az")), measured_acceleration) << name;
  }
  EXPECT_EQ(curves.size(), 16u);
}

TEST(Measured, HasTheRatesOfTheReferenceAtItsKeys) {
  const DataTable keys("golden/measured_keys.csv");
  std::map<std::string, AnyCurve> curves;
  for (const auto& key : keys.rows()) {
    const std::string name(key.text("sequence"));
    if (!curves.contains(name)) curves.emplace(name, measured_curve(keys_of(keys, name)));
    const Motion m = curves.at(name).motion(key.number("t"));
    EXPECT_LE(relative_error(m.angular_velocity, key.vector("wx", "wy", "wz")), measured_velocity) << name;
    EXPECT_LE(relative_error(m.angular_acceleration, key.vector("ax", "ay", "az")), measured_acceleration) << name;
  }
}

TEST(Measured, BelievesTheModelsThatTheReferenceBelieves) {
  const DataTable keys("golden/measured_keys.csv"), numbers("golden/measured_numbers.csv");
  for (const auto& row : numbers.rows()) {
    const std::string name(row.text("sequence"));
    // The numbers have 40 digits behind them. At a constant rate the misses are rounding, beside which there is 1e-24
    // only.
    const double allowed = name == "constant rate" ? 1e-7 : tolerance::series;
    const KeyFindings found = findings_of(keys_of(keys, name));
    const std::vector<double> wanted = row.numbers("models");
    ASSERT_EQ(wanted.size(), found.belief.models.size());
    for (std::size_t m = 0; m < wanted.size(); ++m)
      EXPECT_NEAR(found.belief.models[m], wanted[m], allowed) << name << ", model " << m;
    EXPECT_NEAR(found.belief.polynomial, row.number("polynomial"), allowed) << name;
    EXPECT_NEAR(found.belief.polynomial9, row.number("polynomial9"), allowed) << name;
  }
}

TEST(Measured, IsTheSameBackwardsInTime) {
  for (const Spacing spacing : {Spacing::even, Spacing::uneven}) {
    const KeyframeData data = noisy_walk(911, 40, spacing, 0.4, 0.02);
    const AnyCurve forward = measured_curve(data), backward = measured_curve(backwards(data));
    for (const double t : sample_times(data.times, 5))
      EXPECT_LE(angular_distance(forward(t), backward(-t)), tolerance::series) << t;
    const KeyFindings a = findings_of(data), b = findings_of(backwards(data));
    for (std::size_t m = 0; m < a.belief.models.size(); ++m)
      EXPECT_NEAR(a.belief.models[m], b.belief.models[m], tolerance::rates) << m;
  }
}

TEST(Measured, HasItsNumbersInAnyFrame) {
  const KeyframeData data = noisy_walk(912, 60, Spacing::uneven, 0.4, 0.01);
  const Eigen::Quaterniond turn = exp<double>(Eigen::Vector3d(1.3, -2.1, 0.4));
  KeyframeData turned = data;
  for (auto& q : turned.orientations) q = turn * q * turn;
  const KeyFindings a = findings_of(data), b = findings_of(turned);
  for (std::size_t m = 0; m < a.belief.models.size(); ++m)
    EXPECT_NEAR(a.belief.models[m], b.belief.models[m], tolerance::series) << m;
  EXPECT_NEAR(a.belief.polynomial, b.belief.polynomial, tolerance::series);
}

TEST(Measured, TellsNoiseFromSmoothMotion) {
  KeyframeData smooth;
  for (int i = 0; i < 60; ++i) {
    const double t = 0.1 * i;
    smooth.times.push_back(t);
    smooth.orientations.push_back(exp<double>(Eigen::Vector3d(std::sin(t), std::cos(1.3 * t), 0.4 * t)));
  }
  EXPECT_GT(findings_of(smooth).belief.polynomial, 0.99);
  const KeyFindings noisy = findings_of(noisy_walk(913, 100, Spacing::even, 0.01, 0.05));
  double noise = 0.0;
  for (std::size_t m = 4; m < families::noise_models; ++m) noise += noisy.belief.models[m];
  EXPECT_GT(noise, 0.9);
  EXPECT_EQ(noisy.trust, 1.0);
}

TEST(Measured, IsAutoWhereItKnowsNothing) {
  for (const std::size_t keys : {2u, 3u, 5u, 8u}) {
    const KeyframeData data = noisy_walk(914 + keys, keys, Spacing::uneven, 0.5, 0.05);
    const AnyCurve measured = measured_curve(data), automatic = measured_curve(data, "auto");
    for (const double t : sample_times(data.times, 5))
      EXPECT_EQ(measured(t).coeffs(), automatic(t).coeffs()) << keys << " keys";
    EXPECT_FALSE(key_findings("measured", keyframes(data)).value());
  }
  const KeyframeData fast = random_walk(915, 40, Spacing::even, 3.0);
  ASSERT_EQ(findings_of(fast).trust, 0.0);
  const AnyCurve measured = measured_curve(fast), automatic = measured_curve(fast, "auto");
  for (const double t : sample_times(fast.times, 5)) EXPECT_EQ(measured(t).coeffs(), automatic(t).coeffs());
}

TEST(Measured, TakesTheNumbersThatItIsGiven) {
  const KeyframeData data = noisy_walk(916, 50, Spacing::uneven, 0.3, 0.03);
  const KeyFindings found = findings_of(data);
  EXPECT_FALSE(found.given);
  const Method given = with_findings("measured", found);
  const AnyCurve a = measured_curve(data), b = measured_curve(data, given);
  for (const double t : sample_times(data.times, 5)) EXPECT_EQ(a(t).coeffs(), b(t).coeffs()) << t;
  const KeyFindings again = key_findings(given, keyframes(data)).value().value();
  EXPECT_TRUE(again.given);
  EXPECT_EQ(again.belief.models, found.belief.models);
  EXPECT_EQ(again.trust, found.trust);
}

TEST(Measured, WithGivenNumbersMovesFourIntervalsOnEitherSideOfAKey) {
  const KeyframeData data = noisy_walk(917, 40, Spacing::uneven, 0.3, 0.03);
  const Method given = with_findings("measured", findings_of(data));
  constexpr std::size_t moved_key = 18;
  KeyframeData moved = data;
  moved.orientations[moved_key] = moved.orientations[moved_key] * exp<double>(Eigen::Vector3d(0.05, -0.02, 0.03));
  const AnyCurve a = measured_curve(data, given), b = measured_curve(moved, given);
  for (std::size_t segment = 0; segment + 1 < data.times.size(); ++segment) {
    const double t = 0.5 * (data.times[segment] + data.times[segment + 1]);
    const bool near_the_key = segment + 5 >= moved_key && segment <= moved_key + 4;
    EXPECT_EQ(a(t).coeffs() == b(t).coeffs(), !near_the_key) << segment;
  }
}

TEST(Measured, WithGivenNumbersIsMadeAsKeysArrive) {
  const KeyframeData data = noisy_walk(918, 40, Spacing::uneven, 0.3, 0.03);
  const Method given = with_findings("measured", findings_of(data));
  const AnyCurve offline = measured_curve(data, given);
  OnlineCurve online = OnlineCurve::make(given, 40).value();
  for (std::size_t i = 0; i < data.times.size(); ++i)
    ASSERT_TRUE(online.append({.time = data.times[i], .orientation = data.orientations[i]}));
  ASSERT_TRUE(online.finish());
  for (const double t : sample_times(data.times, 5)) EXPECT_EQ(online(t).coeffs(), offline(t).coeffs()) << t;
  const auto refused = OnlineCurve::make("measured", 40);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("a segment depends on all keys"), std::string::npos);
}

TEST(Measured, FindsWhatItIsNotGiven) {
  const KeyframeData data = noisy_walk(919, 50, Spacing::uneven, 0.3, 0.03);
  const Method spline{"measured", {.parameters = {{"spline", {0.5}}, {"noise50", {0.5}}}}};
  const KeyFindings found = findings_of(data), partly = key_findings(spline, keyframes(data)).value().value();
  EXPECT_FALSE(partly.given);
  EXPECT_EQ(partly.belief.polynomial, found.belief.polynomial);
  EXPECT_EQ(partly.interval, found.interval);
  EXPECT_EQ(partly.belief.models[0], 0.5);
  EXPECT_EQ(partly.belief.models[5], 0.5);
}

TEST(Measured, TakesSharesAsPartsOfTheirSum) {
  const KeyframeData data = noisy_walk(923, 30, Spacing::even, 0.3, 0.03);
  const Method whole{"measured", {.parameters = {{"noise50", {1.0}}, {"noise20", {1.0}}}}};
  const KeyFindings found = key_findings(whole, keyframes(data)).value().value();
  EXPECT_EQ(found.belief.models[3], 0.5);
  EXPECT_EQ(found.belief.models[5], 0.5);
}

TEST(Measured, KeepsAConstantRateOnUnevenKeys) {
  KeyframeData data;
  Dice dice(920);
  double t = 0.0;
  for (int i = 0; i < 40; ++i) {
    data.times.push_back(t);
    data.orientations.push_back(exp<double>(t * Eigen::Vector3d(0.4, -0.3, 0.2)));
    t += dice.between(0.1, 0.9);
  }
  const AnyCurve curve = measured_curve(data);
  for (const double at : sample_times(data.times, 5)) {
    EXPECT_TRUE(near(curve.motion(at).angular_velocity, Eigen::Vector3d(0.4, -0.3, 0.2), tolerance::series));
    EXPECT_LE(curve.motion(at).angular_acceleration.norm(), tolerance::rates);
  }
}

TEST(Measured, IsFiniteOverGapsAndKeysAtNearlyTheSameTime) {
  for (const double step : {1e-13, 1e-9, 1e-3, 1e3, 1e9}) {
    KeyframeData data = noisy_walk(921, 40, Spacing::even, 0.3, 0.02);
    for (std::size_t i = 0; i < 40; ++i) data.times[i] = static_cast<double>(i) + (i > 20 ? step - 1.0 : 0.0);
    const AnyCurve curve = measured_curve(data);
    for (const double t : sample_times(data.times, 5)) {
      const Motion m = curve.motion(t);
      EXPECT_TRUE(m.orientation.coeffs().allFinite() && m.angular_velocity.allFinite() &&
                  m.angular_acceleration.allFinite())
          << step << " at " << t;
    }
    for (const double share : findings_of(data).belief.models) EXPECT_TRUE(std::isfinite(share)) << step;
  }
}

TEST(Measured, MovesPositionsByTheirOwnModels) {
  KeyframeData data = noisy_walk(922, 60, Spacing::uneven, 0.3, 0.02);
  for (const double t : data.times) data.positions.emplace_back(std::sin(t), 0.5 * std::cos(0.7 * t), 0.1 * t);
  const Keyframes keys = Keyframes::make(data).value();
  const PoseCurve measured = make_pose_curve("measured", keys).value(),
                  automatic = make_pose_curve("auto", keys).value();
  double moved = 0.0;
  for (const double t : sample_times(data.times, 5)) {
    const Eigen::Vector3d wanted(std::sin(t), 0.5 * std::cos(0.7 * t), 0.1 * t);
    EXPECT_TRUE(near(measured.position->linear_motion(t).position, wanted, 1e-2)) << t;
    moved = std::max(moved, angular_distance(measured.orientation(t), automatic.orientation(t)));
  }
  EXPECT_GT(moved, 1e-4);  // of the noisy orientations it makes another curve
}

}}  // namespace orispline
