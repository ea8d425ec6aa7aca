// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/curve_of_keys.hpp>

#include <gtest/gtest.h>

#include <orispline/families/blending/blending_family.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/jobs/retime.hpp>

namespace orispline::jobs { namespace {

Recipe recipe_of(std::string method) { return {.method = std::move(method), .line = 2}; }

TEST(ChosenMethod, IsTheOneThatTheUserNames) {
  const auto chosen = chosen_method(Method("slerp"), recipe_of("timed-c2"), "keys.csv", {});
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->method.name, "slerp");
  EXPECT_EQ(chosen->by, NamedBy::user);
  ASSERT_EQ(chosen->warnings.size(), 1u);
  EXPECT_EQ(chosen->warnings.front().code, "recipe_set_aside");
}

TEST(ChosenMethod, IsElseTheOneThatTheKeysAreFor) {
  const auto chosen = chosen_method(std::nullopt, recipe_of("timed-c2:ends=rest"), "keys.csv", {});
  ASSERT_TRUE(chosen);
  EXPECT_EQ(text_of(chosen->method), "timed-c2:ends=rest");
  EXPECT_EQ(chosen->by, NamedBy::keys);
  EXPECT_TRUE(chosen->warnings.empty());
}

TEST(ChosenMethod, SetsAsideOtherBlendingFunctionsOfTheSameName) {
  const auto family = [](const char* middle) {
    return BlendingFamily::make({.name = "mine", .title = "", .rows = {{"0", middle, "1"}}}).value();
  };
  const Method stated(family("2/5")), same(family("2/5")), other(family("3/5"));
  Track keys;
  keys.recipe = recipe_for(stated, keys);
  EXPECT_TRUE(chosen_method(same, keys, {}).value().warnings.empty());
  const auto chosen = chosen_method(other, keys, {});
  ASSERT_EQ(chosen->warnings.size(), 1u);
  EXPECT_EQ(chosen->warnings.front().message,
            "these keys are for mine, and they are used for other blending functions of that name");
}

TEST(ChosenMethod, IsElseTheUsualOne) {
  const auto chosen = chosen_method(std::nullopt, Recipe(), "keys.csv", {.name = "squad"});
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->method.name, "squad");
  EXPECT_EQ(chosen->by, NamedBy::nobody);
  EXPECT_TRUE(chosen->warnings.empty());
}

TEST(ChosenMethod, SetsAsideOneOfTheKeysThatDoesNotFit) {
  const auto chosen = chosen_method(std::nullopt, recipe_of("hermite-c1"), "keys.csv", usual_retimed);
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->method.name, default_method);
  ASSERT_EQ(chosen->warnings.size(), 1u);
  EXPECT_EQ(chosen->warnings.front().where.line, 2u);
}

TEST(ChosenMethod, IsShapedUnlessTheUserNamesIt) {
  const Shaping with_rests = [](Method method, NamedBy) { return with_ends(std::move(method), "rest"); };
  EXPECT_EQ(text_of(chosen_method(std::nullopt, recipe_of("timed-c2"), "", {}, with_rests)->method),
            "timed-c2:ends=rest");
  EXPECT_EQ(text_of(chosen_method(Method("timed-c2"), Recipe(), "", {}, with_rests)->method), "timed-c2");
}

TEST(ChosenMethod, BlamesTheFileForARecipeThatCannotBeRead) {
  const auto chosen = chosen_method(std::nullopt, recipe_of("nosuch"), "keys.csv", {});
  ASSERT_FALSE(chosen);
  EXPECT_EQ(chosen.error().code, ErrorCode::bad_data);
  EXPECT_EQ(chosen.error().where.file, "keys.csv");
  EXPECT_EQ(chosen.error().where.line, 2u);
}

TEST(ChosenMethod, IsThatOfKeysWhoseColumnsHaveItsSettings) {
  Track keys(*Keyframes::make({.times = {0.0, 1.0}, .orientations = {2, Eigen::Quaterniond::Identity()}}));
  keys.recipe = recipe_of("quintic");
  keys.settings = {{"tension", {0.5, 0.25}}};
  EXPECT_TRUE(chosen_method(method_from_text("quintic:tension=0.5,0.25").value(), keys, {})->warnings.empty());
  EXPECT_EQ(chosen_method(method_from_text("sextic").value(), keys, {})->warnings.size(), 1u);
}

TEST(Placed, SaysTheFileUnlessTheUserIsAtFault) {
  Track keys(*Keyframes::make({.times = {0.0, 1.0}, .orientations = {2, Eigen::Quaterniond::Identity()}}));
  keys.name = "keys.csv";
  keys.lines = {3, 5};
  EXPECT_EQ(placed(keys, {.code = ErrorCode::bad_data, .message = "", .where = {.key = 1}}).where.line, 5u);
  EXPECT_EQ(placed(keys, {.code = ErrorCode::bad_data, .message = ""}).where.file, "keys.csv");
  EXPECT_EQ(placed(keys, {.code = ErrorCode::bad_argument, .message = ""}).where.file, "");
  keys.name.clear();
  EXPECT_EQ(placed(keys, {.code = ErrorCode::bad_data, .message = "", .where = {.key = 1}}).where.line, std::nullopt);
}

}}  // namespace orispline::jobs
