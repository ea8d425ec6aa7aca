// SPDX-License-Identifier: Apache-2.0
// Columns of inner quaternions: how they are read, refused and written.
#include <string>

#include <gtest/gtest.h>

#include <orispline/curve/keyframe.hpp>
#include <orispline/io/track_file.hpp>
#include <support/inner_quaternions.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

const std::string inner_header = "t,qw,qx,qy,qz,a_qw,a_qx,a_qy,a_qz,b_qw,b_qx,b_qy,b_qz\n";
const ReadOptions with_inner{.inner_quaternions = true};

Expected<KeyFile> inner_file(const std::string& content, const ReadOptions& options = with_inner) {
  return read_keys(test::TextFile(content).path(), options);
}

std::string inner_refusal(const std::string& content, const ReadOptions& options = with_inner) {
  const auto file = inner_file(content, options);
  return file ? "" : file.error().message;
}

TEST(InnerColumns, AreReadWhereTheyAreAskedFor) {
  const std::string content = inner_header + "0,1,0,0,0,0,1,0,0,0.6,0,0,0.8\n1,1,0,0,0,,,,,nan,nan,nan,nan\n";
  const auto file = inner_file(content);
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_EQ(file->data.inner_leaving[0].coeffs(), Eigen::Vector4d(1, 0, 0, 0));
  EXPECT_EQ(file->data.inner_arriving[0].coeffs(), Eigen::Vector4d(0, 0, 0.8, 0.6));
  EXPECT_TRUE(is_free_inner(file->data.inner_leaving[1]) && is_free_inner(file->data.inner_arriving[1]));
  EXPECT_TRUE(file->ignored_columns.empty());
  const auto without = inner_file(content, {});
  ASSERT_TRUE(without);
  EXPECT_TRUE(without->data.inner_leaving.empty());
  EXPECT_EQ(without->ignored_columns.size(), 8u);
}

TEST(InnerColumns, MayBeOfOneSideAndHaveOtherNames) {
  const auto file = inner_file(
      "t,qw,qx,qy,qz,b1,b2,b3,b4\n0,1,0,0,0,1,0,0,0\n",
      {.columns = {{"b_qw", "b1"}, {"b_qx", "b2"}, {"b_qy", "b3"}, {"b_qz", "b4"}}, .inner_quaternions = true});
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_TRUE(file->data.inner_leaving.empty());
  EXPECT_EQ(file->data.inner_arriving.size(), 1u);
}

TEST(InnerColumns, AreAllFourOrNone) {
  EXPECT_EQ(inner_refusal("t,qw,qx,qy,qz,a_qw,a_qx\n0,1,0,0,0,1,0\n"),
            "found a_qw, a_qx without a_qy, a_qz, wanted all four columns or none");
  EXPECT_EQ(
      inner_refusal(inner_header + "0,1,0,0,0,1,,0,0,1,0,0,0\n"),
      "found an empty cell, wanted a finite number, or none in all four cells of the inner quaternion to leave it "
      "free");
}

TEST(InnerColumns, HaveTheNormsThatOrientationsMayHave) {
  const std::string content = inner_header + "0,1,0,0,0,1.01,0,0,0,3,0,0,0\n";
  EXPECT_EQ(inner_refusal(content), "the quaternion has norm 3, wanted 1 within 0.02");
  const auto file = inner_file(content, {.inner_quaternions = true, .norms = Norms::any});
  ASSERT_TRUE(file);
  EXPECT_EQ(file->data.inner_leaving[0].w(), 1.0);
  EXPECT_EQ(file->data.inner_arriving[0].w(), 1.0);
  EXPECT_EQ(file->repairs.normalised, 2u);
}

TEST(InnerColumns, AreConjugatedAndSortedWithTheirKeys) {
  const auto file = inner_file("t,qw,qx,qy,qz,a_qw,a_qx,a_qy,a_qz\n1,1,0,0,0,0.6,0,0,0.8\n0,1,0,0,0,1,0,0,0\n",
                               {.conjugate = true, .inner_quaternions = true, .sort = true});
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_EQ(file->data.inner_leaving[0].w(), 1.0);
  EXPECT_EQ(file->data.inner_leaving[1].z(), -0.8);
}

/// The keys as the file has them that they are written to.
KeyframeData written_and_read(const Keyframes& keys, const SampleColumns& columns) {
  const Track track(keys);
  const test::ScratchDirectory directory;
  const std::string path = directory.file("keys.csv");
  auto out = OutputFile::open(path).value();
  EXPECT_TRUE(write_tracks(out, std::span(&track, 1), columns));
  EXPECT_TRUE(out.finish());
  const bool conjugate = columns.turning == Turning::world_to_body;
  return read_track(path, {.conjugate = conjugate, .inner_quaternions = true}).value().track.keys.data();
}

TEST(InnerColumns, AreWrittenSoThatTheyAreReadAgain) {
  using namespace testing_support;
  KeyframeData data = with_inner_quaternions(random_walk(431, 6, Spacing::uneven), 432);
  data.inner_leaving[2] = data.inner_arriving[4] = free_inner();
  const Keyframes keys = keyframes(data, Signs::shortest);
  for (const Turning turning : {Turning::body_to_world, Turning::world_to_body}) {
    const KeyframeData again = written_and_read(keys, {.turning = turning});
    ASSERT_EQ(again.inner_arriving.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_EQ(is_free_inner(again.inner_leaving[i]), i == 2);
      EXPECT_TRUE(i == 2 || again.inner_leaving[i].coeffs() == keys.inner_leaving()[i].coeffs());
      EXPECT_TRUE(i == 4 || again.inner_arriving[i].coeffs() == keys.inner_arriving()[i].coeffs());
    }
  }
}

TEST(InnerColumns, AreLackingInOtherFormats) {
  using namespace testing_support;
  Track track(keyframes(with_inner_quaternions(random_walk(433, 3, Spacing::even), 434)));
  track.recipe.method = "squad";
  EXPECT_FALSE(states_recipe(track, {.format = &tum_format}));
  const auto refused = check_columns({.format = &tum_format, .inner = {true, false}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "TUM has no columns for inner quaternions");
  const auto warning = recipe_not_stated(track, {.format = &npy_format}, "keys.npy");
  ASSERT_TRUE(warning);
  EXPECT_TRUE(states_recipe(track, {}));
}

}}  // namespace orispline::io
