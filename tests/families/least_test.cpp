// SPDX-License-Identifier: Apache-2.0
// The curves of least energy against multiple shooting in SciPy: tests/data/golden/least_*.csv, made by
// tools/make_golden.py least, and what an optimum must obey.
#include <gtest/gtest.h>

#include <orispline/analysis/curve_measures.hpp>
#include <orispline/families/registry.hpp>
#include <support/data_table.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

/// Of the energies: what the refinement leaves.
constexpr double energy_agreement = 1e-7;
/// Of the motions: quintic pieces, whose energy is off by the square of what their α is off.
constexpr MotionTolerance motion_agreement{3e-6, 3e-5, 1e-3, 1e-1};

Keyframes keys_named(const std::string& sequence, const std::string& file = "golden/least_keys.csv") {
  const DataTable table(file);
  KeyframeData data;
  for (const auto& row : table.rows_where("sequence", sequence)) {
    data.times.push_back(row.number("t"));
    data.orientations.push_back(row.quaternion("qw", "qx", "qy", "qz"));
  }
  return Keyframes::make(std::move(data)).value();
}

CurveOptions options_of_least(const DataTable::Row& row) {
  CurveOptions options{.parameters = {{"inertia", row.numbers("inertia")}},
                       .choices = {{"energy", row.text("energy")}}};
  const FamilyInfo& family = *find_family("least").value();
  options.start.rule = options.end.rule = end_rule_by_name(family, row.text("ends")).value();
  if (row.text("ends") == "clamped") {
    options.start.angular_velocity = {0.4, -0.3, 0.2};
    options.end.angular_velocity = {-0.1, 0.5, 0.3};
  }
  return options;
}

Eigen::Matrix3d inertia_of(const DataTable::Row& row) {
  const auto j = row.numbers("inertia");
  Eigen::Matrix3d inertia;
  inertia << j.at(0), j.at(3), j.at(4), j.at(3), j.at(1), j.at(5), j.at(4), j.at(5), j.at(2);
  return inertia;
}

double energy_of(const AnyCurve& curve, const DataTable::Row& row) {
  const Energies e = energies(curve, inertia_of(row));
  return row.text("energy") == "jerk" ? e.jerk : row.text("energy") == "torque" ? e.torque : e.acceleration;
}

TEST(Least, EnergiesAreThoseOfMultipleShooting) {
  const DataTable cases("golden/least_energies.csv");
  ASSERT_EQ(cases.size(), 10u);
  for (const auto& row : cases.rows()) {
    SCOPED_TRACE(row.text("sequence") + " " + row.text("energy") + " " + row.text("ends"));
    const auto curve = make_curve({"least", options_of_least(row)}, keys_named(row.text("sequence")));
    ASSERT_TRUE(curve) << describe(curve.error());
    EXPECT_NEAR(energy_of(*curve, row) / row.number("value"), 1.0, energy_agreement);
  }
}

TEST(Least, EnergiesOfWideTurnsAtUnevenTimesAreThoseOfMultipleShooting) {
  const DataTable cases("golden/least_hard_energies.csv");
  ASSERT_EQ(cases.size(), 12u);
  for (const auto& row : cases.rows()) {
    const auto curve = make_curve("least", keys_named(row.text("sequence"), "golden/least_hard_keys.csv"));
    ASSERT_TRUE(curve) << row.text("sequence") << ": " << describe(curve.error());
    EXPECT_NEAR(energies(*curve).acceleration / row.number("value"), 1.0, energy_agreement) << row.text("sequence");
  }
}

TEST(Least, MotionsAreThoseOfMultipleShooting) {
  const DataTable cases("golden/least_energies.csv"), motions("golden/least_motions.csv");
  for (const auto& row : cases.rows()) {
    SCOPED_TRACE(row.text("sequence") + " " + row.text("energy") + " " + row.text("ends"));
    const AnyCurve curve = make_curve({"least", options_of_least(row)}, keys_named(row.text("sequence"))).value();
    const auto expected = motions.rows_where("case", row.text("case"));
    ASSERT_FALSE(expected.empty());
    for (const auto& motion : expected) {
      const Motion ours = curve.motion(motion.number("t"));
      EXPECT_TRUE(near(ours.orientation, motion.quaternion("qw", "qx", "qy", "qz"), motion_agreement.orientation));
      EXPECT_TRUE(near(ours.angular_velocity, motion.vector("wx", "wy", "wz"), motion_agreement.angular_velocity));
      EXPECT_TRUE(
          near(ours.angular_acceleration, motion.vector("ax", "ay", "az"), motion_agreement.angular_acceleration));
    }
  }
}

TEST(Least, NoOtherMethodHasLessEnergy) {
  const Keyframes keys = keys_named("five");
  const double least = energies(make_curve("least", keys).value()).acceleration;
  for (const char* other : {"global-c2", "rotation-spline:ends=natural", "auto", "timed-c2", "nu-exact"}) {
    const std::string text(other);
    const std::string name = text.substr(0, text.find(':'));
    CurveOptions options;
    if (name != text) options.start.rule = options.end.rule = EndRule::natural;
    EXPECT_GT(energies(make_curve({name, options}, keys).value()).acceleration, least) << other;
  }
}

TEST(Least, TheJerkIsConstantInTheWorldBetweenKeys) {
  const Keyframes keys = keys_named("five");
  const AnyCurve curve = make_curve({"least", {.parameters = {{"nodes", {32.0}}}}}, keys).value();
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    const KnotSpan span = curve.knots().span(i);
    const auto momentum = [&](double share) -> Eigen::Vector3d {
      const Motion m = curve.motion(span.start() + share * span.step());
      return m.orientation * m.angular_jerk;
    };
    const Eigen::Vector3d middle = momentum(0.51);
    for (const double share : {0.02, 0.27, 0.74, 0.98}) EXPECT_TRUE(near(momentum(share), middle, 1e-3)) << share;
  }
}

TEST(Least, MeetsTheRatesOfItsKeys) {
  KeyframeData data = random_walk(5, 5, Spacing::uneven, 0.8);
  Dice dice(6);
  for (std::size_t i = 0; i < 5; ++i) data.angular_velocities.push_back(dice.vector());
  const AnyCurve with_rates = make_curve("least", keyframes(data)).value();
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_TRUE(near(with_rates.motion(data.times[i]).angular_velocity, data.angular_velocities[i], tolerance::rates));
  for (std::size_t i = 0; i < 5; ++i) data.angular_accelerations.push_back(dice.vector());
  const AnyCurve with_both = make_curve("least", keyframes(data)).value();
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_TRUE(
        near(with_both.motion(data.times[i]).angular_acceleration, data.angular_accelerations[i], tolerance::rates));
  EXPECT_GT(energies(with_both).acceleration, energies(with_rates).acceleration);
}

TEST(Least, TheRuleOfAnEndGoesBeforeTheRateOfItsKey) {
  KeyframeData data = random_walk(5, 4, Spacing::even, 0.8);
  data.angular_velocities.assign(4, Eigen::Vector3d(0.3, 0.1, 0.2));
  const CurveOptions rest{.start = {.rule = EndRule::rest}, .end = {.rule = EndRule::rest}};
  const AnyCurve curve = make_curve({"least", rest}, keyframes(data)).value();
  EXPECT_LE(curve.motion(data.times.front()).angular_velocity.norm(), tolerance::rates);
  EXPECT_TRUE(near(curve.motion(data.times[1]).angular_velocity, data.angular_velocities[1], tolerance::rates));
}

TEST(Least, IsTheSameWhenTimeRunsBackwards) {
  const KeyframeData data = random_walk(7, 6, Spacing::uneven, 1.0);
  KeyframeData back{.times = {}, .orientations = {data.orientations.rbegin(), data.orientations.rend()}};
  for (auto t = data.times.rbegin(); t != data.times.rend(); ++t) back.times.push_back(-*t);
  const AnyCurve curve = make_curve("least", keyframes(data)).value(),
                 mirror = make_curve("least", keyframes(back)).value();
  for (const double t : sample_times(data.times, 7)) EXPECT_TRUE(near(mirror(-t), curve(t), tolerance::rates)) << t;
}

TEST(Least, RefusesAnInertiaThatNoBodyHas) {
  const auto curve = make_curve({"least", {.parameters = {{"inertia", {1.0, -2.0, 1.0}}}}}, keys_named("five"));
  ASSERT_FALSE(curve);
  EXPECT_EQ(curve.error().code, ErrorCode::bad_argument);
  const auto four = make_curve({"least", {.parameters = {{"inertia", {1.0, 2.0, 1.0, 0.0}}}}}, keys_named("five"));
  ASSERT_FALSE(four);
  EXPECT_EQ(four.error().message,
            "least: found 4 values of inertia, wanted 1, 3 (its diagonal) or 6 (xx,yy,zz,xy,xz,yz)");
}

TEST(Least, RefusesNodesThatAreNoWholeNumber) {
  const auto curve = make_curve({"least", {.parameters = {{"nodes", {2.5}}}}}, keys_named("five"));
  ASSERT_FALSE(curve);
  EXPECT_EQ(curve.error().message, "least: nodes is 2.5, wanted a whole number");
}

}}  // namespace orispline
