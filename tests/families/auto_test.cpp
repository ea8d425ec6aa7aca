// SPDX-License-Identifier: Apache-2.0
// auto and auto5: agreement with the reference, and what their page promises.
#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/data_table.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

/// What golden_auto.json states: its reference is double precision itself.
constexpr double auto_orientation = 1e-11, auto_velocity = 1e-9, auto_acceleration = 1e-7;

AnyCurve auto_curve(const KeyframeData& data, std::string_view family = "auto", const CurveOptions& options = {}) {
  return make_curve({family, options}, Keyframes::make(data).value()).value();
}

KeyframeData about_one_axis(const std::vector<double>& times, double (*angle)(double)) {
  KeyframeData data{.times = times};
  for (const double t : times) data.orientations.push_back(exp<double>(angle(t) * Eigen::Vector3d(0.6, 0.0, 0.8)));
  return data;
}

/// Holds the curves through all sequences of keys to the rows; how many sequences there are.
std::size_t sequences_that_agree(const DataTable& keys, const DataTable& rows) {
  std::map<std::string, AnyCurve> curves;
  for (const auto& row : rows.rows()) {
    const std::string name(row.text("sequence"));
    if (!curves.contains(name)) {
      KeyframeData data;
      for (const auto& key : keys.rows_where("sequence", name)) {
        data.times.push_back(key.number("t"));
        data.orientations.push_back(key.quaternion("qw", "qx", "qy", "qz"));
      }
      curves.emplace(name, auto_curve(data));
    }
    const Motion m = curves.at(name).motion(row.number("t"));
    EXPECT_LE(relative_error(m.orientation, row.quaternion("qw", "qx", "qy", "qz")), auto_orientation) << name;
    EXPECT_LE(relative_error(m.angular_velocity, row.vector("wx", "wy", "wz")), auto_velocity) << name;
    EXPECT_LE(relative_error(m.angular_acceleration, row.vector("ax", "ay", "az")), auto_acceleration) << name;
  }
  return curves.size();
}

TEST(Auto, AgreesWithTheReferenceInEveryRow) {
  EXPECT_EQ(sequences_that_agree(DataTable("golden/auto_keys.csv"), DataTable("golden/auto.csv")), 17u);
}

TEST(Auto, BelievesThePolynomialWhereItForetellsKeys) {
  EXPECT_EQ(sequences_that_agree(DataTable("golden/auto_guard_keys.csv"), DataTable("golden/auto_guard.csv")), 6u);
}

TEST(Auto, IsTheSameBackwardsInTime) {
  const KeyframeData data = random_walk(401, 12, Spacing::uneven);
  KeyframeData reversed;
  for (std::size_t i = data.times.size(); i-- > 0;) {
    reversed.times.push_back(-data.times[i]);
    reversed.orientations.push_back(data.orientations[i]);
  }
  for (const char* family : {"auto", "auto5"}) {
    const AnyCurve forward = auto_curve(data, family), backward = auto_curve(reversed, family);
    for (const double t : sample_times(data.times, 5))
      EXPECT_LE(angular_distance(forward(t), backward(-t)), tolerance::algebra) << family << " at " << t;
  }
}

TEST(Auto, IsExactForAFixedAxisWithACubicAngle) {
  const std::vector<double> times{0.0, 0.3, 0.4, 0.9, 1.1, 1.6, 1.9, 2.0};
  const auto angle = [](double t) { return 0.2 + 0.5 * t - 0.6 * t * t + 0.25 * t * t * t; };
  const AnyCurve curve = auto_curve(about_one_axis(times, angle));
  for (const double t : sample_times(times, 7)) {
    const Eigen::Quaterniond truth = exp<double>(angle(t) * Eigen::Vector3d(0.6, 0.0, 0.8));
    EXPECT_LE(angular_distance(curve(t), truth), tolerance::series) << t;
  }
}

TEST(Auto, TheLastDigitsOfARestMoveNothing) {
  const KeyframeData noisy{
      .times = {0.0, 1.1376953125, 1.41015625, 4.20703125, 5.49609375, 6.0009765625},
      .orientations = {
          quaternion_wxyz(0.93884864055851014, -0.30747458919780912, 0.13632226441816925, -0.0737485412939025),
          quaternion_wxyz(0.93884864055851014, -0.30747458919780907, 0.13632226441816928, -0.073748541293902514),
          quaternion_wxyz(0.93884864055851025, -0.30747458919780918, 0.13632226441816922, -0.0737485412939025),
          quaternion_wxyz(0.93884864055851025, -0.30747458919780907, 0.13632226441816925, -0.073748541293902514),
          quaternion_wxyz(0.93884864055851003, -0.30747458919780912, 0.13632226441816925, -0.0737485412939025),
          quaternion_wxyz(0.86026997682736162, -0.34186287063363624, 0.19754186936931374959, -0.32255628116595408)}};
  KeyframeData resting = noisy;
  std::fill_n(resting.orientations.begin(), 5, noisy.orientations[0]);
  for (const char* family : {"auto", "auto5", "measured"}) {
    const AnyCurve rough = auto_curve(noisy, family), still = auto_curve(resting, family);
    for (const double t : sample_times(noisy.times, 9))
      EXPECT_LE(angular_distance(rough(t), still(t)), tolerance::algebra) << family << " at " << t;
  }
}

TEST(Auto, MovingOneKeyMovesTheStatedSegmentsOnly) {
  const KeyframeData data = random_walk(402, 16, Spacing::uneven);
  constexpr std::size_t moved_key = 8;
  KeyframeData moved = data;
  moved.orientations[moved_key] = moved.orientations[moved_key] * exp<double>(Eigen::Vector3d(0.05, -0.02, 0.03));
  for (const auto& [family, before, after] : {std::tuple("auto", 4u, 3u), std::tuple("auto5", 3u, 2u)}) {
    const AnyCurve a = auto_curve(data, family), b = auto_curve(moved, family);
    for (std::size_t segment = 0; segment + 1 < data.times.size(); ++segment) {
      const double t = 0.5 * (data.times[segment] + data.times[segment + 1]);
      const bool near_the_key = segment + before >= moved_key && segment <= moved_key + after;
      if (!near_the_key) {
        EXPECT_EQ(angular_distance(a(t), b(t)), 0.0) << family << " " << segment;
      }
      if (segment + 1 == moved_key || segment == moved_key) {
        EXPECT_GT(angular_distance(a(t), b(t)), 1e-3) << family;
      }
    }
  }
}

TEST(Auto, HoldsStillBetweenEqualKeysOnRequest) {
  KeyframeData data = random_walk(403, 9, Spacing::even);
  data.orientations[5] = data.orientations[4];
  const double in_the_rest = 0.5 * (data.times[4] + data.times[5]);
  const AnyCurve free = auto_curve(data), holding = auto_curve(data, "auto", {.parameters = {{"hold", {1.0}}}});
  EXPECT_GT(free.motion(in_the_rest).angular_velocity.norm(), 1e-3);
  const Motion rest = holding.motion(in_the_rest);
  EXPECT_LE(angular_distance(rest.orientation, data.orientations[4]), tolerance::exact);
  EXPECT_LE(rest.angular_velocity.norm(), tolerance::algebra);
  for (const std::size_t key : {4u, 5u})
    for (const Side side : {Side::left, Side::right})
      EXPECT_LE(holding.motion(data.times[key], side).angular_velocity.norm(), tolerance::algebra);
}

TEST(Auto, HoldsOrDoesNotAndNothingBetween) {
  const auto half =
      make_curve({"auto", {.parameters = {{"hold", {0.5}}}}}, keyframes(random_walk(443, 5, Spacing::even)));
  ASSERT_FALSE(half);
  EXPECT_EQ(half.error().code, ErrorCode::bad_argument);
}

TEST(Auto, IsDefinedForTwoThreeAndFourKeysAndForLargeSteps) {
  for (const char* family : {"auto", "auto5"}) {
    for (std::size_t keys = 2; keys <= 8; ++keys) {
      const KeyframeData data = random_walk(404 + keys, keys, Spacing::uneven);
      const AnyCurve curve = auto_curve(data, family);
      for (std::size_t i = 0; i < keys; ++i)
        EXPECT_LE(angular_distance(curve(data.times[i]), data.orientations[i]), tolerance::algebra);
    }
    KeyframeData spin;
    for (int i = 0; i < 9; ++i) {
      spin.times.push_back(i);
      spin.orientations.push_back(exp<double>(Eigen::Vector3d(3.1 * i, 0, 0)));
    }
    const AnyCurve curve = auto_curve(spin, family);
    for (const double t : sample_times(spin.times, 5)) {
      EXPECT_TRUE(near(curve.motion(t).angular_velocity, Eigen::Vector3d(3.1, 0, 0), tolerance::series)) << family;
      EXPECT_LE(curve.motion(t).angular_acceleration.norm(), tolerance::rates);
    }
  }
}

}}  // namespace orispline
