// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/recipe_line.hpp>

#include <array>
#include <string>

#include <gtest/gtest.h>

#include <orispline/io/key_reader.hpp>
#include <orispline/io/track_file.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::content_of;
using test::ScratchDirectory;
using test::text_of;
using test::TextFile;

constexpr std::string_view recipe_rows = "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.6,0,0.8,0\n";
constexpr std::string_view what_is_wanted =
    " in the comment that names the method of the keys, wanted method=NAME, and signs=as-given or signs=shortest, "
    "gap=SECONDS and jumps, each once";

TEST(RecipeLine, IsReadAsItWasWritten) {
  for (const Signs signs : {Signs::shortest, Signs::as_given}) {
    const Recipe recipe{.method = "timed-c2:tension=0.25,1:ends=rest", .signs = signs};
    std::string line = recipe_line(recipe);
    ASSERT_TRUE(line.ends_with('\n'));
    line.pop_back();
    const auto read = recipe_in(line).value().value();
    EXPECT_EQ(read.method, recipe.method);
    EXPECT_EQ(read.signs, signs);
  }
  EXPECT_EQ(recipe_line({.method = "squad", .signs = Signs::as_given}), "# orispline: method=squad signs=as-given\n");
  EXPECT_EQ(recipe_line({.signs = Signs::as_given}), "");
  EXPECT_EQ(recipe_line({.signs = Signs::as_given, .counts_turns = true}), "# orispline: signs=as-given\n");
  EXPECT_EQ(recipe_line({.method = "slerp", .gap = 0.5}), "# orispline: method=slerp gap=0.5\n");
  EXPECT_EQ(recipe_in("# orispline: gap=0.5 method=slerp").value()->gap, 0.5);
  EXPECT_EQ(recipe_line({.method = "slerp", .jumps = true}), "# orispline: method=slerp jumps\n");
  EXPECT_TRUE(recipe_in("# orispline: jumps").value()->jumps);
  EXPECT_EQ(recipe_in("# orispline: signs=as-given").value()->signs, Signs::as_given);
}

TEST(RecipeLine, LeavesCommentsOfOthersAlone) {
  for (const std::string_view comment : {"#", "# ", "# orispline", "# by orispline: method=slerp", "#timestamp [ns]"})
    EXPECT_FALSE(recipe_in(comment).value()) << comment;
  EXPECT_EQ(recipe_in("#orispline:\tsigns=shortest  method=slerp ").value()->method, "slerp");
}

TEST(RecipeLine, RefusesWordsThatItDoesNotKnow) {
  const auto refused = [](std::string_view words) { return recipe_in("# orispline: " + std::string(words)).error(); };
  for (const std::string_view word :
       {"method=", "signs=", "signs=both", "gap=", "gap=0", "gap=-1", "band=0.9", "slerp", "jumps=1"})
    EXPECT_EQ(refused("method=auto " + std::string(word)).message,
              "found '" + std::string(word) + "'" + std::string(what_is_wanted));
  EXPECT_EQ(refused("method=auto method=auto").message, "found 'method=auto'" + std::string(what_is_wanted));
  EXPECT_EQ(refused("signs=shortest").message, "found 'orispline: signs=shortest'" + std::string(what_is_wanted));
  EXPECT_EQ(refused("signs=both").remedy, "recipe");
}

TEST(RecipeLine, RefusesBlendingFunctionsThatAreNone) {
  for (const std::string_view comment : {"# orispline:blending=", "#orispline: blending=", "# orispline:blending={}",
                                         "# orispline: method=mine blending=1"}) {
    const auto read = recipe_in(comment);
    ASSERT_FALSE(read) << comment;
    EXPECT_TRUE(read.error().message.starts_with("the blending functions of the keys: ")) << read.error().message;
  }
}

TEST(KeyInput, KnowsTheRecipeBeforeTheKeysAreRead) {
  const TextFile file("\n# by hand\n  # orispline: method=squad signs=as-given\n# two keys\n" +
                      std::string(recipe_rows));
  auto input = KeyInput::open(file.path()).value();
  EXPECT_EQ(input.recipe().method, "squad");
  EXPECT_EQ(input.recipe().signs, Signs::as_given);
  EXPECT_EQ(input.recipe().line, 3U);
  const auto track = read_track(std::move(input), {}).value().track;
  EXPECT_EQ(track.keys.size(), 2U);
  EXPECT_EQ(track.lines, (std::vector<std::uint32_t>{6, 7}));
  EXPECT_EQ(track.recipe.method, "squad");
}

TEST(KeyInput, PassesOverTheRecipeWhereItIsIgnored) {
  const TextFile file("# orispline: what is this\n" + std::string(recipe_rows));
  EXPECT_EQ(text_of(read_keys(file.path()).error()),
            "keys.csv:1: found 'what'" + std::string(what_is_wanted) + " (option recipe)");
  const auto bare = read_track(file.path(), {.recipe = RecipeUse::ignored}).value();
  EXPECT_TRUE(bare.track.recipe.is_empty());
  EXPECT_EQ(bare.track.keys.size(), 2U);
}

TEST(KeyInput, TakesOneRecipeAboveTheRows) {
  const std::string line = "# orispline: method=slerp\n";
  const TextFile twice(line + line + std::string(recipe_rows)), below(std::string(recipe_rows) + line);
  EXPECT_EQ(text_of(read_keys(twice.path()).error()),
            "keys.csv:2: a second comment names the method of the keys, wanted one at most (option recipe)");
  EXPECT_TRUE(read_keys(below.path()).value().recipe.is_empty());
}

TEST(KeyInput, SignsOfTheRecipeAreHonouredUnlessOthersAreGiven) {
  const std::string turned = "t,qw,qx,qy,qz\n0,1,0,0,0\n1,-0.6,0,-0.8,0\n";
  const TextFile file("# orispline: method=slerp signs=as-given\n" + turned);
  const auto w_of = [&](std::optional<Signs> signs) {
    return read_track(file.path(), {}, signs).value().track.keys.orientations()[1].w();
  };
  EXPECT_EQ(w_of(std::nullopt), -0.6);
  EXPECT_EQ(w_of(Signs::shortest), 0.6);
  EXPECT_EQ(read_track(file.path(), {}, Signs::shortest).value().track.recipe.signs, Signs::shortest);
}

TEST(WriteTracks, StatesTheRecipeInEveryFormatWithComments) {
  Track track = read_track(TextFile(std::string(recipe_rows)).path()).value().track;
  track.recipe.method = "timed-c2:ends=rest";
  const ScratchDirectory directory;
  std::size_t stated = 0;
  for (const FormatInfo* const format : formats_written()) {
    const std::string path = directory.file("keys" + std::string(format->extensions.front()));
    auto file = OutputFile::open(path).value();
    ASSERT_TRUE(write_tracks(file, {&track, 1}, {.format = format}));
    ASSERT_TRUE(file.finish());
    const auto unstated = recipe_not_stated(track, {.format = format}, path);
    EXPECT_EQ(content_of(path).starts_with("# orispline: method=timed-c2:ends=rest\n"), !unstated) << format->id;
    if (unstated) {
      EXPECT_EQ(
          describe(*unstated),
          path + ": " + std::string(format->file) +
              " has no comments, so it does not say that its keys are for timed-c2:ends=rest; name the method where "
              "the keys are read");
      continue;
    }
    ++stated;
    const auto again = read_track(path, {.format = format}).value();
    EXPECT_EQ(again.track.recipe.method, track.recipe.method) << format->id;
    EXPECT_EQ(again.track.keys.size(), 2U);
  }
  EXPECT_EQ(stated, 3U);
}

TEST(WriteTracks, StatesNoRecipeWhoseCurveTheFileCannotGive) {
  Track track = read_track(TextFile("t,qw,qx,qy,qz,wx,wy,wz\n0,1,0,0,0,1,2,3\n").path()).value().track;
  track.recipe.method = "hermite-c1";
  EXPECT_TRUE(states_recipe(track, {}));
  EXPECT_EQ(recipe_not_stated(track, {.format = &tum_format}, "k.tum")->message,
            "a TUM file has no columns for rates, so it does not say that its keys are for hermite-c1; name the method "
            "where the keys are read");
  track.keys = track.keys.with_rates({}).value();
  EXPECT_TRUE(states_recipe(track, {.format = &tum_format}));
  track.settings = {{"tension", {0.5}}};
  EXPECT_FALSE(states_recipe(track, {.format = &tum_format}));
  EXPECT_TRUE(states_recipe(track, {}));
  track.recipe = {};
  EXPECT_FALSE(recipe_not_stated(track, {.format = &npy_format}, "k.npy"));
}

}}  // namespace orispline::io
