// SPDX-License-Identifier: Apache-2.0
// Promises of blending functions that hold under a condition only, or not at all: what is said is what curves do.
#include <algorithm>

#include <gtest/gtest.h>

#include <orispline/analysis/continuity.hpp>
#include <orispline/families/blending/blending_family.hpp>
#include <orispline/families/method_warnings.hpp>
#include <orispline/families/registry.hpp>
#include <support/specimens.hpp>

#include "families/own_blending.hpp"

namespace orispline { namespace {

using namespace testing_support;
using Promise = BlendingFinding::Promise;

/// The quintic of Tan with a rate at each key that is an expression: x at the first key of a segment, y at the second.
BlendingData with_rates(const std::string& x, const std::string& y, std::vector<BlendingParameter> parameters) {
  const auto row = [&](std::string_view pattern) {
    std::vector<std::string> entries{""};
    for (const char c : pattern)
      if (c == ' ') entries.emplace_back();
      else if (c == 'x' || c == 'y') entries.back() += "(" + (c == 'x' ? x : y) + ")";
      else entries.back() += c;
    return entries;
  };
  return {.name = "mine",
          .title = "Typed in",
          .parameters = std::move(parameters),
          .rows = {row("1 1+x/5 1+7*x/20 1 1 1"), row("0 x/5 9*x/20 1-9*y/20 1-y/5 1"), row("0 0 0 -7*y/20 -y/5 0")}};
}

std::vector<std::string> codes_of(const Method& method, const Keyframes& keys) {
  Track track;
  track.keys = keys;
  std::vector<std::string> codes;
  for (const Warning& warning : warnings_of(method, track)) codes.emplace_back(warning.code);
  return codes;
}

/// A condition, and values of the parameters at every key with which it fails at key 3 of 7.
struct Conditional {
  const char *x, *y, *condition;
  std::map<std::string, std::vector<double>, std::less<>> failing;
};

const std::vector<Conditional> conditional{
    {"a", "b", "a ≠ 0", {{"one", {1, 1, 1, 0, 1, 1, 1}}}},
    {"1-a", "1-b", "1 − a ≠ 0", {{"one", {0, 0, 0, 1, 0, 0, 0}}}},
    {"a2", "b2", "a2 ≠ 0", {{"two", {1, 1, 1, 0, 1, 1, 1}}}},
    {"a-a2", "b-b2", "a − a2 ≠ 0", {{"one", {2, 2, 2, 0.7, 2, 2, 2}}, {"two", {1, 1, 1, 0.7, 1, 1, 1}}}},
    {"a*a2/3", "b*b2/3", "a*a2 ≠ 0", {{"two", {1, 1, 1, 0, 1, 1, 1}}}},
    {"a_1*b", "a*b_1", "a_1*b ≠ 0", {{"one", {1, 1, 0, 1, 1, 1, 1}}}},
    {"2-a^2", "2-b^2", "1 − 1/2*a^2 ≠ 0", {{"one", {1, 1, 1, std::sqrt(2.0), 1, 1, 1}}}},
    {"a",
     "b2",
     "β̃2′(1) and β̃1′(0) have the same sign",
     {{"one", {1, 1, 1, -0.5, 1, 1, 1}}, {"two", {1, 1, 1, 1, 1, 1, 1}}}},
};

TEST(BlendingPromises, NameTheConditionOnParametersUnderWhichThePathHasNoCorner) {
  for (const auto& [x, y, condition, failing] : conditional) {
    SCOPED_TRACE(condition);
    const BlendingData data = with_rates(x, y, {{"one", 0.5}, {"two", 0.25}});
    const BlendingFinding shape = finding(data, Promise::shape);
    EXPECT_GE(shape.order, 1);
    EXPECT_EQ(shape.provided, condition);
    EXPECT_NE(sentence_of(shape).find(std::string("wherever ") + condition), std::string::npos);

    const Keyframes keys = keyframes(random_walk(91, 7, Spacing::uneven, 1.0));
    const Method kept(family_of(data)), missed(family_of(data), {.parameters = failing});
    EXPECT_GE(shape_continuity_at_keys(make_curve(kept, keys).value()).order().value_or(-1), shape.order);
    EXPECT_EQ(std::ranges::count(codes_of(kept, keys), "corner_at_key"), 0);
    EXPECT_LE(shape_continuity_at_keys(make_curve(missed, keys).value()).order().value_or(0), 0);
    EXPECT_EQ(codes_of(missed, keys), std::vector<std::string>{"corner_at_key"});
  }
}

TEST(BlendingPromises, NeedNoConditionWhereTheBodyAlwaysMoves) {
  EXPECT_EQ(finding(with_rates("1/2", "1/2", {}), Promise::shape).provided, "");
  EXPECT_EQ(finding(with_rates("1/2", "1/2", {}), Promise::shape).order, 2);
  // To and fro, and to a rest on one side.
  EXPECT_EQ(finding(with_rates("1/2", "-1/2", {}), Promise::shape).order, 0);
  EXPECT_EQ(finding(with_rates("0", "1/2", {}), Promise::shape).order, 0);
}

TEST(BlendingPromises, AreNoneWhereACoefficientDividesByZero) {
  const BlendingData data{
      .name = "pole",
      .title = "Typed in",
      .rows = {{"1", "1+h/(h-h_1)/5", "1", "1", "1"}, {"0", "0", "0.5", "1", "1"}, {"0", "0", "0", "0", "0"}}};
  const BlendingFinding even = finding(data, Promise::continuity_even);
  EXPECT_EQ(even.order, -1);
  EXPECT_EQ(sentence_of(even),
            "There is no curve on evenly spaced keys: a coefficient divides by 0 where all lengths are the same.");
  const BlendingFinding uneven = finding(data, Promise::continuity_uneven);
  EXPECT_EQ(uneven.provided, "h-h_1 ≠ 0");
  const Method method(family_of(data));
  EXPECT_FALSE(make_curve(method, keyframes(random_walk(92, 6, Spacing::even))));
  // Around a loop of uneven ones, for the intervals beyond the ends of an open curve are mirrored.
  const Method loop(family_of(data), {.loop = Loop{.period = 10.0}});
  EXPECT_TRUE(make_curve(loop, keyframes({.times = {0.0, 1.0, 3.0, 4.5, 8.0},
                                          .orientations = random_walk(92, 5, Spacing::even).orientations})));
  // Sums of lengths are never 0.
  EXPECT_EQ(finding(with_rates("h_1/(h_1+h)", "h1/(h+h1)", {}), Promise::continuity_uneven).provided, "");
}

/// a to the power 2^61 - 1 and 2^61 - 31, which is a in the field of the prime of that size.
std::string to_the_first_prime() {
  std::string power = "a";
  for (int k = 0; k < 15; ++k) power = "(" + power + ")^16*a^15";
  return power;
}
std::string to_the_second_prime() {
  std::string power = "a^15";
  for (int k = 0; k < 13; ++k) power = "(" + power + ")^16*a^15";
  return "((" + power + ")^16)^2*a";
}

TEST(BlendingPromises, AreNotFooledByPowersThatFiniteFieldsDoNotSee) {
  const std::string first = "(" + to_the_first_prime() + "-a)", second = "(" + to_the_second_prime() + "-a)";
  for (const std::string& zero : {first, second, first + "*" + second}) {
    BlendingData data = with_rates("a", "b", {{"one", 0.5}});
    data.rows[1].back() = "1+" + zero;
    EXPECT_EQ(finding(data, Promise::interpolates).order, 0);
    EXPECT_EQ(finding(data, Promise::continuity_even).order, -1);
  }
}

TEST(BlendingPromises, HoldForLargeHonestPowers) {
  BlendingData data = with_rates("(a-1)^20*(a+1)^20", "(b-1)^20*(b+1)^20", {{"one", 0.5}});
  data.rows[1].back() = "1+(a+b)^20-(b+a)^20";
  EXPECT_EQ(finding(data, Promise::interpolates).order, 1);
  EXPECT_EQ(finding(data, Promise::continuity_even).order, 2);
}

TEST(BlendingPromises, SayThatACurveJumpsAndItIsMeasuredAndWarnedOf) {
  const BlendingData data{.name = "jumping", .title = "Typed in", .rows = {{"0", "h/h_1"}}, .first = 0};
  const BlendingFinding found = finding(data, Promise::continuity_uneven);
  EXPECT_EQ(found.order, -1);
  EXPECT_EQ(found.why, "β̃1(1) and 1 differ by 0.5 where the last but one interval before a key is twice the others");
  EXPECT_EQ(finding(data, Promise::interpolates).why, "the values at the keys depend on the lengths of the intervals");
  const Method method(family_of(data));
  const Keyframes keys =
      keyframes({.times = {0.0, 1.0, 2.0, 4.0, 5.0}, .orientations = random_walk(93, 5, Spacing::even).orientations});
  const AnyCurve curve = make_curve(method, keys).value();
  const Continuity measured = continuity_at_keys(curve);
  EXPECT_EQ(measured.order(), -1);
  EXPECT_EQ(measured.orientation.time, keys.times()[measured.orientation.key]);
  EXPECT_EQ(orders_at_keys(curve)[measured.orientation.key], -1);
  EXPECT_FALSE(shape_continuity_at_keys(curve).order());
  EXPECT_FALSE(continuities_at_keys(curve).of_shape.order());
  EXPECT_EQ(codes_of(method, keys), std::vector<std::string>{"jump_at_key"});
  EXPECT_TRUE(codes_of(method, keyframes(random_walk(93, 5, Spacing::even))).empty());
}

}}  // namespace orispline
