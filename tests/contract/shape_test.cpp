// SPDX-License-Identifier: Apache-2.0
// Contract: the path of a curve is as smooth as its family declares, whatever the speed, and not one order smoother.
// This holds where the body moves: `biarcs` rests at a key to turn back.
#include <orispline/analysis/continuity.hpp>

#include <contract/family_contract.hpp>
#include <contract/random_parameters.hpp>
#include <support/inner_quaternions.hpp>

namespace orispline::contract { namespace {

using namespace testing_support;

constexpr double moderate_step = 0.8;  // [rad], as for the continuity in time
constexpr int highest_order = 3;       // that the shape is looked at

class Shape : public FamilyContract {
 protected:
  static void expect_order(int declared, Spacing spacing, std::uint64_t seed, bool with_parameters) {
    SCOPED_TRACE(seed);
    const Keyframes keys = keyframes(walk(seed, 9, spacing, moderate_step));
    const CurveOptions options = with_parameters ? random_parameters(GetParam(), keys.size(), seed) : CurveOptions{};
    const ShapeContinuity shape = shape_continuity_at_keys(curve(keys, options));
    EXPECT_EQ(shape.order_in_motion(), std::min(declared, highest_order));
    EXPECT_FALSE(shape.is_hidden());
  }
};

TEST_P(Shape, IsOfTheDeclaredOrderOnEvenAndUnevenTimes) {
  for (const Spacing spacing : {Spacing::even, Spacing::uneven})
    for (const std::uint64_t seed : {71u, 72u, 73u}) expect_order(GetParam().shape_order(), spacing, seed, false);
}

TEST_P(Shape, HoldsForRandomParametersAtEveryKey) {
  for (const Spacing spacing : {Spacing::even, Spacing::uneven})
    expect_order(GetParam().shape_order(), spacing, 74, true);
}

/// A parameter that is 0 at one key: the body rests there where the family says so, and nowhere else.
TEST_P(Shape, HasACornerOnlyWhereAParameterIsZeroOfWhichTheFamilySaysSo) {
  const Keyframes keys = keyframes(walk(75, 8, Spacing::even, moderate_step));
  for (const Parameter& parameter : GetParam().parameters) {
    if (!parameter.per_key || parameter.lowest > 0.0) continue;
    SCOPED_TRACE(parameter.name);
    std::vector<double> values(keys.size(), parameter.initial);
    values[keys.size() / 2] = 0.0;
    const ShapeContinuity shape =
        shape_continuity_at_keys(curve(keys, {.parameters = {{std::string(parameter.name), values}}}));
    EXPECT_EQ(shape.rests, parameter.rests_at_zero ? 1u : 0u);
    if (parameter.rests_at_zero) {
      EXPECT_EQ(shape.order(), 0);
      EXPECT_EQ(shape.corner().second, keys.size() / 2);
    }
  }
}

TEST_P(Shape, IsOfTheDeclaredOrderInTimeTooWithInnerQuaternions) {
  const auto& order = GetParam().order_with_inner_quaternions;
  if (!order) return;
  for (const Spacing spacing : {Spacing::even, Spacing::uneven}) {
    const AnyCurve bent = curve(keyframes(with_inner_quaternions(walk(76, 9, spacing, moderate_step), 77)));
    EXPECT_EQ(continuity_at_keys(bent).order(), *order);
    EXPECT_EQ(shape_continuity_at_keys(bent).order_in_motion(), *order);
  }
}

ORISPLINE_FOR_EVERY_FAMILY(Shape);

}}  // namespace orispline::contract
