// SPDX-License-Identifier: Apache-2.0
// Parameters and end rules at the door: what a family accepts, and the words in which it refuses.
#include <limits>
#include <ostream>

#include <gtest/gtest.h>

#include <orispline/base/formatted.hpp>
#include <orispline/families/registry.hpp>
#include <support/not_finite.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

struct BadOptions {
  const char* name;
  const char* family;
  CurveOptions options;
  std::size_t keys;
  ErrorCode code;
  std::string message;  ///< as `describe` puts it
};

void PrintTo(const BadOptions& test, std::ostream* out) { *out << test.name; }

class OptionsRefuse : public testing::TestWithParam<BadOptions> {};

TEST_P(OptionsRefuse, WithWhatWasFoundAndWhatWasWanted) {
  const auto& bad = GetParam();
  const auto curve = make_curve({bad.family, bad.options}, keyframes(random_walk(241, bad.keys, Spacing::even)));
  ASSERT_FALSE(curve);
  EXPECT_EQ(curve.error().code, bad.code);
  EXPECT_EQ(describe(curve.error()), bad.message);
}

std::string names_of_families() {
  std::vector<std::string_view> names;
  for (const FamilyInfo& family : families_info()) names.push_back(family.name);
  return joined(names, ", ");
}

CurveOptions tension(std::vector<double> values) { return {.parameters = {{"tension", std::move(values)}}}; }
CurveOptions start_at(EndRule rule) { return {.start = {.rule = rule}}; }
CurveOptions end_at(EndRule rule) { return {.end = {.rule = rule}}; }

using testing_support::nan;
using enum ErrorCode;

INSTANTIATE_TEST_SUITE_P(
    Bad, OptionsRefuse,
    testing::Values(
        BadOptions{"UnknownFamily",
                   "nothing",
                   {},
                   4,
                   bad_argument,
                   "unknown method 'nothing', wanted one of " + names_of_families()},
        BadOptions{
            "MisspeltFamily", "quintik", {}, 4, bad_argument, "unknown method 'quintik'; did you mean 'quintic'?"},
        BadOptions{"UnknownParameter",
                   "timed-c2",
                   {.parameters = {{"bias", {1.0}}}},
                   4,
                   bad_argument,
                   "timed-c2: unknown parameter 'bias', wanted one of tension, tension2"},
        BadOptions{"ParameterOfAFamilyWithout", "slerp", tension({0.5}), 4, bad_argument,
                   "slerp: unknown parameter 'tension': this method has no parameters"},
        BadOptions{"NoValues", "quintic", tension({}), 4, bad_argument,
                   "quintic: found 0 values of tension, wanted 1 or one per key (4)"},
        BadOptions{"TooFewValues", "quintic", tension({0.5, 0.5, 0.5}), 4, bad_argument,
                   "quintic: found 3 values of tension, wanted 1 or one per key (4)"},
        BadOptions{"TooManyValues", "quintic", tension({0.5, 0.5, 0.5, 0.5, 0.5}), 4, bad_argument,
                   "quintic: found 5 values of tension, wanted 1 or one per key (4)"},
        BadOptions{"ValueAboveTheRange", "quintic", tension({100.5}), 4, bad_argument,
                   "quintic: tension is 100.5, wanted -100 to 100"},
        BadOptions{"ValueBelowTheRangeAtAKey", "sextic", tension({0, 0, -101, 0}), 4, bad_argument,
                   "key 2: sextic: tension is -101, wanted -100 to 100"},
        BadOptions{"ValueNotANumber", "timed-c1", tension({nan}), 4, bad_argument,
                   "timed-c1: tension is nan, wanted -100 to 100"},
        BadOptions{"ValueInfinite", "timed-c1", tension({0, std::numeric_limits<double>::infinity(), 0, 0}), 4,
                   bad_argument, "key 1: timed-c1: tension is inf, wanted -100 to 100"},
        BadOptions{"EndRuleOfAnotherFamily", "squad", start_at(EndRule::natural), 4, bad_argument,
                   "squad: unknown end rule 'natural', wanted one of key, phantom"},
        BadOptions{
            "EndRuleOfAnotherFamilyAtTheEnd", "quintic", end_at(EndRule::phantom), 4, bad_argument,
            "quintic: unknown end rule 'phantom', wanted one of repeat, natural, quadratic, cubic, clamped, rest"},
        BadOptions{"TooFewKeysForQuadraticEnds", "timed-c2", start_at(EndRule::quadratic), 2, bad_data,
                   "timed-c2: ends 'quadratic' need 3 keys, found 2"},
        BadOptions{"TooFewKeysForCubicEnds", "timed-c2", end_at(EndRule::cubic), 3, bad_data,
                   "timed-c2: ends 'cubic' need 4 keys, found 3"},
        BadOptions{"EndRateNotFinite",
                   "timed-c2",
                   {.start = {EndRule::clamped, {nan, 0, 0}}},
                   4,
                   bad_argument,
                   "timed-c2: an end rate is not finite, wanted finite numbers"},
        BadOptions{"EndRateTooLarge",
                   "atbi",
                   {.end = {EndRule::clamped, {0, -1e300, 0}}},
                   4,
                   bad_argument,
                   "atbi: an end rate has a component of 1e+300 rad/s, wanted 1e+18 at most"},
        BadOptions{"EndRateWithoutClamping",
                   "timed-c2",
                   {.end = {EndRule::rest, {1, 2, 3}}},
                   4,
                   bad_argument,
                   "timed-c2: an end rate needs the end rule clamped, found rest"},
        BadOptions{"EndRateOfAFamilyWithoutEnds",
                   "slerp",
                   {.start = {EndRule::none, {1, 2, 3}}},
                   4,
                   bad_argument,
                   "slerp: an end rate needs the end rule clamped, found none"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Options, NameTheEndRulesOfAFamily) {
  const FamilyInfo& squad = *find_family("squad").value();
  EXPECT_EQ(end_rule_by_name(squad, "phantom").value(), EndRule::phantom);
  const auto unknown = end_rule_by_name(squad, "soft");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().message, "squad: unknown end rule 'soft', wanted one of key, phantom");
}

TEST(Options, AreRefusedByAFamilyWithoutEndRules) {
  const Keyframes keys = keyframes(random_walk(242, 3, Spacing::even));
  const auto curve = make_curve({"slerp", start_at(EndRule::natural)}, keys);
  ASSERT_FALSE(curve);
  EXPECT_EQ(curve.error().code, ErrorCode::bad_argument);
}

TEST(Options, HaveNegativeAndZeroTensions) {
  const Keyframes keys = keyframes(random_walk(243, 4, Spacing::even));
  EXPECT_TRUE(make_curve({"quintic", tension({-0.1, 0.2, 0.0, -3.0})}, keys));
}

TEST(Options, AreCheckedEvenForASingleKey) {
  const Keyframes one = keyframes(random_walk(244, 1, Spacing::even));
  EXPECT_TRUE(make_curve({"timed-c2", tension({0.3})}, one));
  EXPECT_FALSE(make_curve({"timed-c2", tension({1e9})}, one));
  EXPECT_FALSE(make_curve({"timed-c2", {.parameters = {{"bias", {1.0}}}}}, one));
}

TEST(Settings, HoldEveryParameterAndTheChosenEnds) {
  const FamilyInfo& family = *find_family("timed-c3").value();
  const FamilySettings settings = settle(family, {.end = {.rule = EndRule::rest}}, 4).value();
  EXPECT_EQ(settings.parameters.size(), 3u);
  EXPECT_EQ(settings.per_key("tension")[3], 0.5);
  EXPECT_EQ(settings.per_key("tension2")[0], 1.0);
  EXPECT_EQ(settings.per_key("tension3")[1], 0.0);
  EXPECT_EQ(settings.start.rule, EndRule::natural);
  EXPECT_EQ(settings.end.rule, EndRule::rest);
}

TEST(PerKey, GivesOneValueToAllOrEachItsOwn) {
  EXPECT_EQ(PerKey({0.7})[12], 0.7);
  EXPECT_EQ(PerKey({0.1, 0.2, 0.3})[2], 0.3);
}

}}  // namespace orispline
