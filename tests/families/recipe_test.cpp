// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/method_text.hpp>

#include <gtest/gtest.h>

namespace orispline { namespace {

TEST(Recipe, NamesTheMethodWithoutWhatTheTrackStatesKeyByKey) {
  Track track;
  track.settings = {{"tension", {0.25, 0.75}}};
  track.recipe.signs = Signs::as_given;
  const Method method = method_from_text("tcb:tension=0.25,0.75:bias=0.5").value();
  const Recipe recipe = recipe_for(method, track);
  EXPECT_EQ(recipe.method, "tcb:bias=0.5");
  EXPECT_EQ(recipe.signs, Signs::as_given);
  EXPECT_EQ(text_of(method_of(recipe, "keys.csv").value().value()), "tcb:bias=0.5");
}

TEST(Recipe, GivesBackTheMethodBitForBit) {
  Method method = method_from_text("timed-c2:tension=0.1:closed").value();
  method.options.parameters["tension"] = {0.1 + 1e-17, 1.0 / 3.0};
  const auto read = method_of(recipe_for(method, {}), "").value().value();
  EXPECT_EQ(read.options.parameters, method.options.parameters);
  EXPECT_TRUE(read.options.loop);
  EXPECT_FALSE(method_of({}, "").value());
}

TEST(Recipe, BlamesItsLineForAMethodThatThereIsNot) {
  const auto unknown = method_of({.method = "auto:tension=1", .line = 4}, "keys.csv");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::bad_data);
  EXPECT_EQ(unknown.error().where.line, 4U);
  EXPECT_EQ(unknown.error().remedy, "recipe");
  EXPECT_TRUE(unknown.error().message.starts_with("the file says that its keys are for 'auto:tension=1': "))
      << unknown.error().message;
}

TEST(Recipe, SaysWhereTheCurveOfAnotherMethodIsAskedFor) {
  const Recipe recipe{.method = "slerp", .line = 1};
  EXPECT_EQ(describe(recipe_set_aside(recipe, "auto", "keys.csv").value()),
            "keys.csv:1: the file says that its keys are for slerp, and they are used for auto");
  EXPECT_FALSE(recipe_set_aside(recipe, "slerp", "keys.csv"));
  EXPECT_EQ(describe(recipe_set_aside({.method = "slerp"}, "auto", "").value()),
            "these keys are for slerp, and they are used for auto");
  EXPECT_FALSE(recipe_set_aside({}, "slerp", "keys.csv"));
}

}}  // namespace orispline
