// SPDX-License-Identifier: Apache-2.0
// Families of one's own: blending functions that are typed in agree with those that are built in, and what they promise
// is found from their coefficients.
#include <orispline/families/blending/blending_family.hpp>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>

#include "families/own_blending.hpp"

namespace orispline { namespace {

using namespace testing_support;
using Promise = BlendingFinding::Promise;
using Rows = std::vector<std::vector<std::string>>;

const Rows tans_rows{{"1", "1+a/5", "1+7*a/20", "1", "1", "1"},
                     {"0", "a/5", "9*a/20", "1-9*b/20", "1-b/5", "1"},
                     {"0", "0", "0", "-7*b/20", "-b/5", "0"}};
const Rows sextic_rows{{"1", "1+a", "1-1/12+2*a", "1", "1", "1", "1"},
                       {"0", "a", "1/12+2*a", "1/2", "1-1/12-2*b", "1-b", "1"},
                       {"0", "0", "0", "0", "1/12-2*b", "-b", "0"}};
const Rows xings_rows{{"1", "9/8", "1", "1", "1"}, {"0", "1/8", "1/2", "7/8", "1"}, {"0", "0", "0", "-1/8", "0"}};
const Rows timed_rows{{"1", "1+2*a*h^2/(5*h_1*(h_1+h))", "1+(4*a/5-a2/10)*h^2/(h_1*(h_1+h))", "1", "1", "1"},
                      {"0", "2*a*h_1/(5*(h_1+h))", "(4*a*h_1/5+a2*h/10)/(h_1+h)", "1-(4*b*h1/5+b2*h/10)/(h+h1)",
                       "1-2*b*h1/(5*(h+h1))", "1"},
                      {"0", "0", "0", "(-4*b/5+b2/10)*h^2/(h1*(h+h1))", "-2*b*h^2/(5*h1*(h+h1))", "0"}};

BlendingData data_of(Rows rows, std::vector<BlendingParameter> parameters = {}) {
  return {.name = "mine", .title = "Typed in", .parameters = std::move(parameters), .rows = std::move(rows)};
}

std::string refusal(const BlendingData& data) {
  const auto made = BlendingFamily::make(data);
  return made ? "" : made.error().message;
}

std::string refusal_of_entry(const std::string& entry) {
  return refusal(data_of({{"0", entry, "1"}}, {{.name = "tension", .initial = 0.5}}));
}

struct Typed {
  const char* built_in;
  BlendingData data;
};

class TypedIn : public testing::TestWithParam<Typed> {
 protected:
  static void expect_agreement(CurveOptions options, Spacing spacing) {
    const Keyframes keys = keyframes(random_walk(81, 9, spacing, 1.0));
    for (auto& [name, values] : options.parameters)
      for (std::size_t i = 0; i < keys.size(); ++i) values.push_back(0.3 + 0.05 * static_cast<double>(i));
    const auto typed = make_curve(Method(family_of(GetParam().data), options), keys);
    const auto built_in = make_curve(Method(GetParam().built_in, options), keys);
    ASSERT_TRUE(typed) << typed.error().message;
    ASSERT_TRUE(built_in) << built_in.error().message;
    for (const double t : sample_times(keys.times(), 7)) {
      const Motion mine = typed->motion(t), theirs = built_in->motion(t);
      EXPECT_LE((mine.orientation.coeffs() - theirs.orientation.coeffs()).norm(), 1e-14);
      EXPECT_LE((mine.angular_velocity - theirs.angular_velocity).norm(),
                1e-13 * std::max(1.0, theirs.angular_velocity.norm()));
      EXPECT_LE((mine.angular_jerk - theirs.angular_jerk).norm(), 1e-12 * std::max(1.0, theirs.angular_jerk.norm()));
    }
  }
};

TEST_P(TypedIn, AgreesWithTheBuiltInMethodOnEvenAndUnevenKeys) {
  for (const Spacing spacing : {Spacing::even, Spacing::uneven}) expect_agreement({}, spacing);
}

TEST_P(TypedIn, AgreesWithAParameterAtEveryKey) {
  CurveOptions options;
  for (const BlendingParameter& parameter : GetParam().data.parameters) options.parameters[parameter.name] = {};
  expect_agreement(options, Spacing::uneven);
}

TEST_P(TypedIn, AgreesWithEveryEndRule) {
  for (const EndRule rule : find_family(GetParam().built_in).value()->ends) {
    const End end{
        .rule = rule,
        .angular_velocity = rule == EndRule::clamped ? Eigen::Vector3d(0.1, 0.2, -0.3) : Eigen::Vector3d::Zero()};
    expect_agreement({.start = end, .end = end}, Spacing::uneven);
  }
}

TEST_P(TypedIn, AgreesAroundALoop) {
  if (!find_family(GetParam().built_in).value()->closes) GTEST_SKIP() << "the built-in method has no loops";
  expect_agreement({.loop = Loop{.period = 30.0}}, Spacing::uneven);
}

TEST_P(TypedIn, IsFoundToBeWhatTheBuiltInMethodDeclares) {
  const FamilyInfo& declared = *find_family(GetParam().built_in).value();
  const auto family = family_of(GetParam().data);
  const FamilyInfo& found = family->info();
  EXPECT_EQ(found.interpolates, declared.interpolates);
  EXPECT_EQ(found.continuity_uniform, declared.continuity_uniform);
  EXPECT_EQ(found.continuity_uneven, declared.continuity_uneven);
  EXPECT_EQ(found.shape_order(), declared.shape_order());
  EXPECT_EQ(found.keeps_constant_rate_uniform, declared.keeps_constant_rate_uniform);
  EXPECT_EQ(found.keeps_constant_rate_uneven, declared.keeps_constant_rate_uneven);
  EXPECT_EQ(found.support_keys, declared.support_keys);
  ASSERT_EQ(found.parameters.size(), declared.parameters.size());
  for (std::size_t p = 0; p < found.parameters.size(); ++p) {
    EXPECT_EQ(found.parameters[p].tunable, declared.parameters[p].tunable);
    EXPECT_EQ(found.parameters[p].rests_at_zero, declared.parameters[p].rests_at_zero);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Rows, TypedIn,
    testing::Values(Typed{"quintic", data_of(tans_rows, {{"tension", 0.5}})},
                    Typed{"sextic", data_of(sextic_rows, {{"tension", 1.0 / 12.0}})},
                    Typed{"xing-quartic", data_of(xings_rows)}, Typed{"slerp", data_of({{"0", "1"}})},
                    Typed{"timed-c2",
                          [] {
                            BlendingData data = data_of(timed_rows, {{"tension", 0.5}, {"tension2", 1.0}});
                            data.ends = "natural";
                            return data;
                          }()}),
    [](const auto& test) {
      std::string name = test.param.built_in;
      std::ranges::replace(name, '-', '_');
      return name;
    });

TEST(Blending, InOtherBasesIsTheSameCurve) {
  // Xing's quartic: β̃ in powers of u, and the blending functions of its four points.
  BlendingData powers =
      data_of({{"1", "1/2", "-3/2", "3/2", "-1/2"}, {"0", "1/2", "3/2", "-1", "0"}, {"0", "0", "0", "-1/2", "1/2"}});
  powers.basis = BlendingBasis::power;
  BlendingData points = data_of({{"0", "-1/8", "0", "0", "0"},
                                 {"1", "1", "1/2", "1/8", "0"},
                                 {"0", "1/8", "1/2", "1", "1"},
                                 {"0", "0", "0", "-1/8", "0"}});
  points.basis = BlendingBasis::bezier;
  const Keyframes keys = keyframes(random_walk(82, 6, Spacing::uneven, 1.0));
  const auto built_in = make_curve("xing-quartic", keys);
  for (const BlendingData& data : {powers, points}) {
    const auto curve = make_curve(Method(family_of(data)), keys);
    for (const double t : sample_times(keys.times(), 7))
      EXPECT_LE(((*curve)(t).coeffs() - (*built_in)(t).coeffs()).norm(), 1e-14);
  }
  EXPECT_EQ(finding(points, Promise::sums_to_one).order, 1);
}

TEST(Blending, OfFiveIncrementsPassesThroughItsKeysAndIsAsSmoothAsFound) {
  // A cubic with the five-point rate (P₋₂ - 8 P₋₁ + 8 P₁ - P₂)/12 at its keys.
  const BlendingData data = data_of({{"1", "1-1/36", "1", "1"},
                                     {"1", "1+7/36", "1+1/36", "1"},
                                     {"0", "7/36", "1-7/36", "1"},
                                     {"0", "-1/36", "-7/36", "0"},
                                     {"0", "0", "1/36", "0"}});
  const auto family = family_of(data);
  EXPECT_TRUE(family->info().interpolates);
  EXPECT_EQ(family->info().continuity_uniform, 1);
  EXPECT_EQ(family->info().support_keys, 6);
  for (const bool is_closed : {false, true}) {
    const Keyframes keys = keyframes(random_walk(83, 8, Spacing::even, 1.0));
    const auto curve = make_curve(
        Method(family, {.loop = is_closed ? std::optional(Loop{.period = keys.times().back() + 1.0}) : std::nullopt}),
        keys);
    ASSERT_TRUE(curve) << curve.error().message;
    for (std::size_t i = 0; i < keys.size(); ++i)
      EXPECT_LE(angular_distance((*curve)(keys.times()[i]), keys.orientations()[i]), 1e-14);
    for (std::size_t i = 1; i + 1 < keys.size(); ++i)
      EXPECT_LE((curve->motion(keys.times()[i], Side::left).angular_velocity -
                 curve->motion(keys.times()[i]).angular_velocity)
                    .norm(),
                1e-12);
  }
}

TEST(Blending, SaysWhatFails) {
  Rows rows = tans_rows;
  rows[1].back() = "0.95";
  const BlendingData data = data_of(rows, {{"tension", 0.5}});
  const BlendingFinding found = finding(data, Promise::interpolates);
  EXPECT_EQ(found.order, 0);
  EXPECT_EQ(found.why, "β̃2(1) = 0.95, wanted 1: the curve does not reach its key");
  const auto curve = make_curve(Method(family_of(data)), keyframes(random_walk(84, 4, Spacing::even)));
  ASSERT_FALSE(curve);
  EXPECT_EQ(curve.error().message, "mine: the curve jumps at its keys: " + found.why);
}

TEST(Blending, SaysForWhichParametersMoreIsKept) {
  // Catmull–Rom with a third coefficient that only fits one tension.
  const BlendingData data = data_of(tans_rows, {{"tension", 0.35}});
  const BlendingFinding steady = finding(data, Promise::steady_even);
  EXPECT_EQ(steady.order, 0);
  EXPECT_EQ(steady.where, "tension = 1/2");
  EXPECT_EQ(finding(data, Promise::continuity_even).order, 2);
}

TEST(Blending, RefusesWhatItCannotUnderstandWithItsPlace) {
  EXPECT_EQ(refusal_of_entry("1+c"),
            "row 1, entry 2, position 3: unknown name 'c', wanted a or b for the parameter, a_1 or b_1 farther out, or "
            "h, h_1, h1");
  EXPECT_EQ(refusal_of_entry("1/a"),
            "row 1, entry 2, position 3: found a division by a parameter, wanted one by numbers and lengths");
  EXPECT_EQ(refusal_of_entry("1/(h-h)"), "row 1, entry 2, position 3: found a division by 0");
  EXPECT_EQ(refusal_of_entry("1e300"), "row 1, entry 2, position 1: found '1e300', wanted a number up to 1e+09");
  EXPECT_EQ(refusal_of_entry("a^a"), "row 1, entry 2, position 3: found 'a', wanted a whole power from 0 to 20");
  EXPECT_EQ(refusal_of_entry("1 2"), "row 1, entry 2, position 3: found '2', wanted an operator");
  EXPECT_EQ(refusal_of_entry(""),
            "row 1, entry 2, position 1: found the end of the expression, wanted a number, a parameter or '('");
  EXPECT_EQ(refusal_of_entry("(1"), "row 1, entry 2, position 3: found the end of the expression, wanted ')'");
  EXPECT_NE(refusal_of_entry(std::string(1000, '(') + "1" + std::string(1000, ')')).find("levels"), std::string::npos);
  EXPECT_NE(refusal_of_entry(std::string(1000, '-') + "1").find("levels"), std::string::npos);
  EXPECT_EQ(refusal_of_entry("system(1)"),
            "row 1, entry 2, position 1: unknown name 'system', wanted a or b for the parameter, a_1 or b_1 farther "
            "out, or h, h_1, h1");
  EXPECT_EQ(refusal(data_of({{"0", "1"}, {"0", "1", "1"}, {"0", "1"}})),
            "row 2: found 3 entries, wanted 2 as in row 1");
  EXPECT_EQ(refusal(data_of({{"0", "1"}, {"0", "1"}})),
            "first: 2 increments do not say where they begin, wanted 'first', 0 being the segment's own");
  EXPECT_EQ(refusal(data_of({{"0", "a", "1"}}, {{.name = "tension", .initial = 1e-300}})),
            "parameters: 'tension' is 1e-300, wanted 0 or a size of 1e-30 at least");
  EXPECT_EQ(refusal(data_of({{"0", "a", "1"}}, {{.name = "tension", .initial = -1e-30}})), "");
  BlendingData taken = data_of({{"0", "1"}});
  taken.name = "squad";
  EXPECT_EQ(refusal(taken), "name: found 'squad', which is a method already, wanted another name");
}

TEST(Blending, AFamilyLivesAsLongAsItsMethods) {
  const Keyframes keys = keyframes(random_walk(85, 4, Spacing::even));
  std::optional<Method> method = Method(family_of(data_of(tans_rows, {{"tension", 0.5}})));
  const Method copy(**family_of_method(*method));
  method.reset();
  EXPECT_TRUE(make_curve(copy, keys));
  EXPECT_EQ(blending_of(copy)->rows, tans_rows);
  EXPECT_EQ(blending_of(Method("auto")), nullptr);
}

}}  // namespace orispline
