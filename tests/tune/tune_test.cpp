// SPDX-License-Identifier: Apache-2.0
#include <orispline/tune/tune.hpp>

#include <gtest/gtest.h>

#include <orispline/analysis/continuity.hpp>
#include <orispline/analysis/curve_measures.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/gauss_legendre.hpp>
#include <support/data_table.hpp>
#include <support/follower.hpp>
#include <support/golden_case.hpp>
#include <support/random_motion.hpp>
#include "tune/some_keys.hpp"

namespace orispline { namespace {

using testing_support::DataTable;
using testing_support::some_keys;
using testing_support::turned;

const Eigen::Matrix3d inertia = Eigen::Vector3d(1.0, 2.0, 4.0).asDiagonal();

Tuning tuned(const Method& method, const Keyframes& keys, TuneOptions options) {
  options.inertia = inertia;
  auto tuning = tune(keys, method, options);
  EXPECT_TRUE(tuning) << describe(tuning.error());
  return tuning.value_or(Tuning{});
}

/// The rows of one case of energies.csv: default, closed form, least acceleration, least torque.
std::vector<std::vector<DataTable::Row>> golden_cases(const DataTable& table) {
  std::vector<std::vector<DataTable::Row>> cases;
  for (std::size_t i = 0; i + 3 < table.size(); i += 4)
    cases.push_back({table.row(i), table.row(i + 1), table.row(i + 2), table.row(i + 3)});
  return cases;
}

void expect_tensions(const Tuning& tuning, const DataTable::Row& row, double limit) {
  const CurveOptions wanted = testing_support::options_of(row);
  for (const auto& [name, values] : wanted.parameters)
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_NEAR(tuning.method.options.parameters.at(name).at(i), values[i], limit) << testing_support::label_of(row);
}

TEST(Tune, ClosedFormIsThatOfTheReference) {
  const DataTable keys("golden/keys.csv"), table("golden/energies.csv");
  for (const auto& rows : golden_cases(table)) {
    const Keyframes q = testing_support::keys_of(keys, rows[0]);
    expect_tensions(tuned(rows[0].text("family"), q, {.objective = Objective::linearised}), rows[1], 1e-9);
  }
}

TEST(Tune, FindsTheLeastAccelerationOfTheReference) {
  const DataTable keys("golden/keys.csv"), table("golden/energies.csv");
  ASSERT_EQ(golden_cases(table).size(), 9u);
  for (const auto& rows : golden_cases(table)) {
    const Keyframes q = testing_support::keys_of(keys, rows[0]);
    const Tuning found = tuned(rows[0].text("family"), q, {.objective = Objective::acceleration});
    expect_tensions(found, rows[2], 1e-5);
    EXPECT_NEAR(found.energy_before / rows[0].number("acceleration"), 1.0, 1e-9);
    EXPECT_NEAR(found.energy_after / rows[2].number("acceleration"), 1.0, 1e-9);
    EXPECT_LE(found.stationarity, 1e-8);
  }
}

TEST(Tune, FindsTheLeastTorqueOfTheReference) {
  const DataTable keys("golden/keys.csv"), table("golden/energies.csv");
  for (const auto& rows : golden_cases(table)) {
    const Keyframes q = testing_support::keys_of(keys, rows[0]);
    const Tuning found = tuned(rows[0].text("family"), q, {.objective = Objective::torque});
    expect_tensions(found, rows[3], 1e-5);
    EXPECT_NEAR(found.energy_before / rows[0].number("torque"), 1.0, 1e-9);
    EXPECT_NEAR(found.energy_after / rows[3].number("torque"), 1.0, 1e-9);
  }
}

double energy_of(std::string_view family, const CurveOptions& options, Objective objective) {
  const Energies e = energies(make_curve({family, options}, some_keys()).value(), inertia);
  return objective == Objective::jerk ? e.jerk : objective == Objective::torque ? e.torque : e.acceleration;
}

/// Every family with tensions, these away from their defaults, which may be the best ones.
std::vector<Method> families_with_tensions() {
  std::vector<Method> methods;
  for (const FamilyInfo& family : families_info()) {
    if (family.name.starts_with("beta")) continue;  // whose energies on uneven keys fall to the end of the range
    CurveOptions options;
    for (const Parameter& parameter : family.parameters)
      if (parameter.tunable) options.parameters[std::string(parameter.name)] = {parameter.initial + 0.1};
    if (!options.parameters.empty()) methods.push_back({family.name, options});
  }
  return methods;
}

TEST(Tune, LeavesNoTensionThatWouldLowerTheEnergyIfItWereMoved) {
  ASSERT_GE(families_with_tensions().size(), 10u);
  for (const Method& method : families_with_tensions())
    for (const Objective objective : {Objective::acceleration, Objective::torque}) {
      const std::string& family = method.name;
      const Tuning found = tuned(method, some_keys(), {.objective = objective});
      const double least = energy_of(family, found.method.options, objective);
      EXPECT_NEAR(found.energy_after / least, 1.0, 1e-9) << family;
      EXPECT_LT(found.energy_after, found.energy_before) << family;
      for (const std::string& name : found.parameters)
        for (std::size_t key = 0; key < 6; ++key)
          for (const double move : {-1e-3, 1e-3}) {
            CurveOptions moved = found.method.options;
            moved.parameters[name][key] += move;
            EXPECT_GE(energy_of(family, moved, objective), least * (1.0 - 1e-12)) << family << " " << name << key;
          }
    }
}

/// ∫|κ|² ds of the curve itself, by another rule than that of tuning.
double bending_of(const AnyCurve& curve) {
  double sum = 0.0;
  for (std::size_t i = 0; i < curve.knots().segments(); ++i) {
    const KnotSpan span = curve.knots().span(i);
    for (const auto& node : gauss_legendre<100>()) {
      const Motion motion = curve.motion(span.start() + node.u * span.step());
      sum += node.weight * span.step() * path_shape(motion).curvature.squaredNorm() * motion.angular_velocity.norm();
    }
  }
  return sum;
}

TEST(Tune, BendsThePathLeastWhateverItsSpeed) {
  for (const std::string_view family : {"timed-c2", "quintic", "hermite-cumulative", "tcb"}) {
    const auto curve = [&](const CurveOptions& options) { return make_curve({family, options}, some_keys()).value(); };
    const Tuning found = tuned(family, some_keys(), {.objective = Objective::curvature});
    const double least = bending_of(curve(found.method.options));
    EXPECT_NEAR(found.energy_before / bending_of(curve({})), 1.0, 1e-11) << family;
    EXPECT_NEAR(found.energy_after / least, 1.0, 1e-11) << family;
    EXPECT_LT(found.energy_after, 0.99 * found.energy_before) << family;
    for (std::size_t key = 0; key < 6; ++key)
      for (const double move : {-0.02, 0.02}) {
        CurveOptions moved = found.method.options;
        moved.parameters.at("tension")[key] += move;
        EXPECT_GE(bending_of(curve(moved)), least * (1.0 - 1e-11)) << family << " " << key;
      }
  }
}

TEST(Tune, KeepsTensionsWithoutInfluence) {
  const Tuning found = tuned("timed-c2", some_keys(), {.objective = Objective::jerk});
  EXPECT_EQ(found.method.options.parameters.at("tension2").front(), 1.0);
  EXPECT_EQ(found.method.options.parameters.at("tension2").back(), 1.0);
  EXPECT_NE(found.method.options.parameters.at("tension2")[1], 1.0);
}

TEST(Tune, StaysWithinBoundsThatAreAskedFor) {
  const TuneOptions bounded{.objective = Objective::acceleration, .bounds = Interval{0.45, 0.55}};
  const Tuning found = tuned("quintic", some_keys(), bounded);
  const auto [lowest, highest] = std::ranges::minmax(found.method.options.parameters.at("tension"));
  EXPECT_EQ(lowest, 0.45);
  EXPECT_EQ(highest, 0.55);
  EXPECT_GT(found.energy_after, tuned("quintic", some_keys(), {.objective = Objective::acceleration}).energy_after);
}

TEST(Tune, FitsTheTensionsThatMadeTheReference) {
  const CurveOptions made{.parameters = {{"tension", {0.4, 0.7, 0.2, 0.6, 0.5, 0.3}}}};
  const AnyCurve curve = make_curve({"quintic", made}, some_keys()).value();
  std::vector<double> times;
  std::vector<Eigen::Quaterniond> orientations;
  for (double t = -0.5; t < 5.0; t += 0.05) {
    times.push_back(t);
    orientations.emplace_back(-curve(t).coeffs());
  }
  const Tuning found = tuned("quintic", some_keys(), {.objective = Objective::fit, .reference = {times, orientations}});
  for (std::size_t key = 0; key < 6; ++key)
    EXPECT_NEAR(found.method.options.parameters.at("tension")[key], made.parameters.at("tension")[key], 1e-9);
  EXPECT_LT(found.energy_after, 1e-20);
}

Keyframes steady_turn(const std::vector<double>& times) {
  KeyframeData data{.times = times};
  for (const double t : times) data.orientations.push_back(turned(0.0, 0.0, 0.5 * t));
  return Keyframes::make(std::move(data)).value();
}

TEST(Tune, LeavesTensionsWhoseEnergyIsRoundingAsTheyAre) {
  for (const Keyframes& keys : {steady_turn({0, 1, 2, 3, 4, 5, 6, 7}), steady_turn({0, 1, 1.001, 1.5, 4, 4.25})})
    for (const std::string_view method : {"timed-c2", "timed-c3", "timed-sextic"})
      for (const Objective objective :
           {Objective::linearised, Objective::acceleration, Objective::jerk, Objective::torque, Objective::curvature}) {
        const Tuning found = tuned(method, keys, {.objective = objective});
        EXPECT_LT(found.energy_before, 1e-9) << method;
        EXPECT_EQ(found.energy_after, found.energy_before) << method;
        EXPECT_EQ(found.stationarity, 0.0) << method;
        EXPECT_EQ(found.iterations, 0u) << method;
        const AnyCurve plain = make_curve(method, keys).value(), same = make_curve(found.method, keys).value();
        EXPECT_EQ(plain(0.7).coeffs(), same(0.7).coeffs()) << method;
      }
}

TEST(Tune, BringsSteadyTurnsWithinBoundsThatTheirTensionsBreak) {
  const Tuning found = tuned("timed-c2", steady_turn({0, 1, 2, 3, 4}), {.bounds = Interval{0.6, 0.9}});
  for (const double tension : found.method.options.parameters.at("tension")) EXPECT_GE(tension, 0.6);
}

TEST(Tune, GivesOutWhatDidNotComeToRestWithAWarning) {
  std::size_t unfinished = 0;
  for (unsigned seed = 1; seed <= 2; ++seed) {
    const Keyframes keys = random_keys(seed, {7, 1.5, 2.5e5});
    for (const Objective objective : {Objective::acceleration, Objective::jerk}) {
      const Tuning found = tuned("timed-c3", keys, {.objective = objective});
      EXPECT_LT(found.energy_after, found.energy_before) << seed;
      EXPECT_GE(found.iterations, 1u) << seed;
      EXPECT_LE(found.iterations, 200u) << seed;
      const auto warning = std::ranges::find(found.warnings, "not_at_rest", &Warning::code);
      ASSERT_EQ(warning != found.warnings.end(), found.stationarity > 1e-8) << seed;
      if (warning == found.warnings.end()) continue;
      ++unfinished;
      EXPECT_EQ(warning->number("stationarity"), found.stationarity);
      EXPECT_EQ(warning->number("iterations"), static_cast<double>(found.iterations));
    }
  }
  EXPECT_GE(unfinished, 1u);
}

TEST(Tune, RefusesWhatItCannotTune) {
  const auto error = [](std::string_view family, const Keyframes& keys, const TuneOptions& options) {
    const auto tuning = tune(keys, family, options);
    return tuning ? std::string("none") : describe(tuning.error());
  };
  const Keyframes two = Keyframes::make({.times = {0, 1}, .orientations = {turned(0, 0, 0), turned(1, 0, 0)}}).value();
  EXPECT_EQ(error("quintic", two, {}), "found 2 keys, wanted at least 3 to tune tensions");
  EXPECT_EQ(error("auto", some_keys(), {}), "method: auto has no tensions to tune, wanted one of " + tunable_methods());
  const auto fourth = tune(some_keys(), Method{"uniform", {.parameters = {{"order", {4.0}}}}}, {});
  ASSERT_FALSE(fourth);
  EXPECT_EQ(describe(fourth.error()), "uniform: tensions of order 4 are not tuned, wanted order 1, 2 or 3");
  EXPECT_EQ(error("quintic", some_keys(), {.objective = Objective::fit}),
            "objective: found fit, wanted `reference` as well");
  EXPECT_EQ(error("quintic", some_keys(), {.objective = Objective::torque}),
            "objective: found torque, wanted `inertia` as well");
  const std::vector<double> late{10.0};
  const std::vector<Eigen::Quaterniond> there{Eigen::Quaterniond::Identity()};
  EXPECT_EQ(error("quintic", some_keys(), {.reference = {late, there}}),
            "reference: it is used by the objective fit alone, wanted `objective` fit as well");
  EXPECT_EQ(error("quintic", some_keys(), {.objective = Objective::fit, .reference = {late, there}}),
            "the reference has no time between the first and the last key, wanted some from 0 to 4 s");
  Track since(some_keys());
  since.epoch = Decimal::parse("1700000000.5").value();
  const auto apart = tune(since, "quintic", {.objective = Objective::fit, .reference = {late, there}});
  ASSERT_FALSE(apart);
  EXPECT_EQ(describe(apart.error()),
            "the reference has no time between the first and the last key, wanted some from "
            "1700000000.5 to 1700000004.5 s");
  EXPECT_EQ(error("quintic", some_keys(),
                  {.objective = Objective::torque, .inertia = Eigen::Vector3d(1, -2, 3).asDiagonal()}),
            "inertia: found the principal moments -2, 1, 3, wanted all of them greater than 0");
  EXPECT_FALSE(is_physical_inertia(inertia));  // 4 > 1 + 2
  EXPECT_TRUE(is_physical_inertia(Eigen::Matrix3d::Identity()));
}

TEST(Tune, IsFollowedAndStopped) {
  const DataTable keys("golden/keys.csv"), table("golden/energies.csv");
  const auto rows = golden_cases(table).front();
  const Keyframes q = testing_support::keys_of(keys, rows[0]);
  for (const std::string_view method : {"timed-c2", "nu"})
    testing_support::expect_to_be_followed_and_stopped(
        [&](const Progress& progress) { return tune(q, method, {.objective = Objective::jerk}, progress); });
}

}}  // namespace orispline
