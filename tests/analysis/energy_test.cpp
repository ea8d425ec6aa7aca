// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/curve_measures.hpp>

#include <gtest/gtest.h>

#include <orispline/families/auto.hpp>
#include <orispline/families/registry.hpp>
#include <support/data_table.hpp>
#include <support/golden_case.hpp>
#include <support/random_motion.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using testing_support::DataTable;

using testing_support::about_x;
using testing_support::today;

void expect_relative(double found, double wanted, double limit, const std::string& label) {
  EXPECT_NEAR(found, wanted, limit * std::abs(wanted)) << label;
}

TEST(Energies, AreThoseOfTheReferenceAtItsTensions) {
  const DataTable keys("golden/keys.csv"), table("golden/energies.csv");
  ASSERT_EQ(table.size(), 36u);
  for (const auto& row : table.rows()) {
    const auto curve =
        make_curve({row.text("family"), testing_support::options_of(row)}, testing_support::keys_of(keys, row));
    ASSERT_TRUE(curve) << describe(curve.error());
    const auto moments = row.numbers("inertia");
    const Energies found =
        energies(*curve, Eigen::Vector3d(moments[0], moments[1], moments[2]).asDiagonal().toDenseMatrix());
    const std::string label = testing_support::label_of(row);
    if (!row.text("acceleration").empty())
      expect_relative(found.acceleration, row.number("acceleration"), 1e-11, label);
    expect_relative(found.torque, row.number("torque"), 1e-11, label);
  }
}

/// One segment about x with the angle 3u² - 2u³ of h = 2 s: α = 6/h² (1 - 2u), jerk = -12/h³.
AnyCurve cubic_turn() {
  KeyframeData data{.times = {1.0, 3.0}, .orientations = {about_x(0.0), about_x(1.0)}};
  data.angular_velocities = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  return make_curve("hermite-c1", Keyframes::make(std::move(data)).value()).value();
}

TEST(Energies, OfACubicTurnAboutAnAxisAreThoseOfItsPolynomials) {
  const Energies e = energies(cubic_turn(), 3.0 * Eigen::Matrix3d::Identity());

  EXPECT_NEAR(e.acceleration, 36.0 / 16.0 / 3.0 * 2.0, 1e-13);  // ∫ (6/h²)² (1 - 2u)² h du
  EXPECT_NEAR(e.jerk, 144.0 / 64.0 * 2.0, 1e-12);
  EXPECT_NEAR(e.torque, 9.0 * e.acceleration, 1e-12);
}

TEST(Energies, OfSteadyTurnsAreNoneButForTheTorqueThatHoldsTheAxis) {
  const Eigen::Vector3d rate(0.3, -0.4, 0.5);
  KeyframeData data;
  for (const double t : {0.0, 0.7, 1.0, 3.1}) {
    data.times.push_back(t);
    data.orientations.push_back(exp<double>(Eigen::Vector3d(t * rate)));
  }
  const Eigen::Matrix3d inertia = Eigen::Vector3d(1.0, 2.0, 4.0).asDiagonal();

  const Energies e = energies(make_curve("timed-c3", Keyframes::make(std::move(data)).value()).value(), inertia);

  EXPECT_NEAR(e.acceleration, 0.0, 1e-25);
  EXPECT_NEAR(e.torque, 3.1 * rate.cross(inertia * rate).squaredNorm(), 1e-13);
}

/// A curve that counts how often its motion is asked for.
class CountingCurve {
 public:
  CountingCurve(const Keyframes& keys, std::size_t& motions)
      : curve_(families::Auto::curve(keys, settle(families::Auto::info, {}, keys.size()).value()).value()),
        motions_(&motions) {}
  [[nodiscard]] const Knots& knots() const noexcept { return curve_.knots(); }
  template <Number T>
  [[nodiscard]] Quaternion<T> point(const T& t, std::size_t segment) const noexcept {
    return curve_.point(t, segment);
  }
  [[nodiscard]] Motion motion(double t, std::size_t segment) const noexcept {
    ++*motions_;
    return curve_.motion(t, segment);
  }

 private:
  ChartCurve<5> curve_;
  std::size_t* motions_;
};

/// The same keys with these steps, uneven by 4, of which `origin` takes nothing away.
Keyframes keys_from(double origin, double step, std::size_t count) {
  const Keyframes turns = random_keys(5, {count, 1.5, 4.0});
  std::vector<double> times{origin};
  for (std::size_t i = 1; i < count; ++i) {
    const double interval = std::round(1024.0 * (turns.times()[i] - turns.times()[i - 1])) / 1024.0;
    times.push_back(times.back() + step * interval);
  }
  return turns.with_times(std::move(times)).value();
}

TEST(Energies, AskForAsFewMotionsAtTheTimesOfTodayAsAtTheStartOfTime) {
  for (const double step : {1.0, 1.0 / 64.0}) {
    const auto motions_from = [&](double origin) {
      std::size_t motions = 0;
      static_cast<void>(energies(CountingCurve(keys_from(origin, step, 40), motions)));
      return motions;
    };
    EXPECT_LE(motions_from(today), motions_from(0.0) * 11 / 10);
    EXPECT_LE(motions_from(today), std::size_t{39} * 150);
  }
}

TEST(Energies, OfEveryMethodAreTheSameAtTheTimesOfTodayAsAtTheStartOfTime) {
  const Eigen::Matrix3d inertia = Eigen::Vector3d(1.0, 2.0, 2.5).asDiagonal();
  for (const FamilyInfo& family : families_info())
    for (const double step : {1.0, 1.0 / 64.0}) {
      const auto early = make_curve(family.name, keys_from(0.0, step, 8));
      const auto late = make_curve(family.name, keys_from(today, step, 8));
      if (!early || !late) continue;
      // The arcs of biarcs meet within a segment, at a time that is rounded to 2.4e-7 s today; α jumps there.
      const double limit = family.name == "biarcs" ? 1e-4 : 1e-8;
      const Energies wanted = energies(*early, inertia), found = energies(*late, inertia);
      expect_relative(found.acceleration, wanted.acceleration, limit, std::string(family.name));
      expect_relative(found.jerk, wanted.jerk, limit, std::string(family.name));
      expect_relative(found.torque, wanted.torque, limit, std::string(family.name));
      expect_relative(AngleTravelled(*late).total(), AngleTravelled(*early).total(), limit, std::string(family.name));
    }
}

TEST(Energies, OfOneKeyAreNone) {
  const auto key = Keyframes::make({.times = {4.0}, .orientations = {about_x(1.0)}}).value();
  EXPECT_EQ(energies(make_curve("auto", key).value()).acceleration, 0.0);
}

}}  // namespace orispline
