// SPDX-License-Identifier: Apache-2.0
// Curves that tuning varies by their construction.
#include <orispline/tune/objective_sums.hpp>

#include <gtest/gtest.h>

#include <orispline/analysis/curve_measures.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/tune/tune.hpp>
#include "tune/some_keys.hpp"

namespace orispline { namespace {

using testing_support::some_keys;
using testing_support::turned;

/// Constructed families, their parameters away from their defaults, and what is sought.
struct MovedCurve {
  std::string_view family;
  CurveOptions options;
  std::vector<std::string> parameters;
};

const std::vector<MovedCurve> moved_curves{
    {"nu", {.parameters = {{"nu", {0.0, 0.4, -0.3, 0.8, 0.1, 0.0}}}}, {"nu"}},
    {"nu-exact", {.parameters = {{"nu", {0.0, 0.4, -0.3, 0.8, 0.1, 0.0}}}}, {"nu"}},
    {"beta",
     {.parameters = {{"beta1", {1.1, 0.8, 1.3, 0.9, 1.2, 1.0}}, {"beta2", {0.5, -0.4, 2.0, 0.1, -1.0, 0.3}}}},
     {"beta1", "beta2"}},
    {"beta-g2",
     {.parameters = {{"beta1", {1.1, 0.8, 1.3, 0.9, 1.2, 1.0}}, {"beta2", {0.5, -0.4, 2.0, 0.1, -1.0, 0.3}}}},
     {"beta1", "beta2"}},
    {"beta-g2",
     {.parameters = {{"beta1", {1.1, 0.8, 1.3, 0.9, 1.2, 1.0}}, {"beta2", {0.5, -0.4, 2.0, 0.1, -1.0, 0.3}}},
      .choices = {{"form", "global"}}},
     {"beta1", "beta2"}},
    {"beta-through", {.parameters = {{"beta1", {1.1, 0.8, 1.3, 0.9, 1.2, 1.0}}, {"beta2", {0.5}}}}, {"beta1"}},
    {"beta-through", {.parameters = {{"beta2", {0.5, -0.4, 2.0, 0.1, -1.0, 0.3}}}}, {"beta2"}}};

/// A recording that no curve follows, for the segments of a curve.
Goal fit_to_something(std::size_t segments) {
  Goal goal{.objective = Objective::fit, .reference_samples = {}, .sample_count = 3 * segments};
  for (std::size_t i = 0; i < segments; ++i)
    goal.reference_samples.push_back(
        {{0.1, turned(0.3, 0.2, 0.1)}, {0.5, turned(0.5, -0.4, 0.2)}, {0.9, turned(0, 1, 0)}});
  return goal;
}

TEST(Construction, KnowsHowAConstructionChangesWithItsParameters) {
  const Keyframes keys = some_keys();
  for (const auto& [family, options, parameters] : moved_curves) {
    const auto model = construction_model(*find_family(family).value(), keys, options, parameters).value();
    for (const Objective objective :
         {Objective::acceleration, Objective::jerk, Objective::linearised, Objective::fit}) {
      const Goal goal = objective == Objective::fit ? fit_to_something(model.construction->variables().size())
                                                    : Goal{.objective = objective};
      ConstructionSum sum(model, goal);
      std::vector<double> start;
      for (const Variable& variable : model.model.variables) start.push_back(variable.initial);
      constexpr double h = 1e-5;
      for (std::size_t block = 0; block < sum.blocks(); ++block) {
        sum.move_to(start);
        const auto variables = sum.variables(block);
        const Eigen::MatrixXd exact = sum.jacobian(block);
        for (std::size_t v = 0; v < variables.size(); ++v) {
          const auto at = [&](double move) {
            std::vector<double> values = start;
            values[variables[v]] += move;
            sum.move_to(values);
            return sum.residuals(block);
          };
          const Eigen::VectorXd slope = (at(h) - at(-h)) / (2.0 * h);
          const Eigen::VectorXd column = exact.col(static_cast<Eigen::Index>(v));
          EXPECT_NEAR((slope - column).norm(), 0.0, 1e-7 * (1.0 + column.norm())) << family << " " << v << " " << block;
        }
      }
    }
  }
}

TEST(Construction, SegmentsOfAConstructionAreThoseOfTheCurve) {
  for (const auto& [family, options, parameters] : moved_curves) {
    const Keyframes keys = some_keys();
    const auto model = construction_model(*find_family(family).value(), keys, options, parameters).value();
    for (const Objective objective : {Objective::acceleration, Objective::jerk}) {
      const Goal goal{.objective = objective};
      const Energies energy = energies(make_curve({family, options}, some_keys()).value(), Eigen::Matrix3d::Identity());
      const double wanted = objective == Objective::jerk ? energy.jerk : energy.acceleration;
      EXPECT_NEAR(value_of(ConstructionSum(model, goal)) / wanted, 1.0, 1e-10) << family;
    }
  }
}

TEST(Construction, FitsTheParametersThatMadeTheReference) {
  const Keyframes keys = some_keys();
  for (const auto& [family, options, parameters] : moved_curves) {
    const AnyCurve curve = make_curve({family, options}, keys).value();
    std::vector<double> times;
    std::vector<Eigen::Quaterniond> orientations;
    for (double t = -0.5; t < 5.0; t += 0.02) {
      times.push_back(t);
      orientations.emplace_back(-curve(t).coeffs());
    }
    const Method plain{family, {.choices = options.choices}};
    const auto found = tune(keys, plain, {.objective = Objective::fit, .reference = {times, orientations}});
    ASSERT_TRUE(found) << family << ": " << describe(found.error());
    EXPECT_GT(found->energy_before, 1e-6) << family;
    EXPECT_LT(found->energy_after, 1e-18) << family;
  }
}

}}  // namespace orispline
