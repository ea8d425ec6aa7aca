// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/suggestion.hpp>

#include <array>

#include <gtest/gtest.h>

namespace orispline { namespace {

constexpr std::array<std::string_view, 6> words{"auto", "squad", "timed-c2", "timed-c3", "hermite-c1", "--rate"};

TEST(Suggestion, CountsLettersToChange) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("squadd", "squad"), 1u);
  EXPECT_EQ(edit_distance("sqaud", "squad"), 1u);  // neighbours exchanged
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("SQUAD", "squad"), 0u);
  EXPECT_EQ(edit_distance("ca", "abc"), 3u);  // no letter is changed twice
}

TEST(Suggestion, IsTheNearestWordIfOneIsNear) {
  EXPECT_EQ(nearest_word("squadd", words), "squad");
  EXPECT_EQ(nearest_word("timedc2", words), "timed-c2");
  EXPECT_EQ(nearest_word("timed-c", words), "timed-c2");  // the first of two
  EXPECT_EQ(nearest_word("Auto", words), "auto");
  EXPECT_EQ(nearest_word("--ratte", words), "--rate");
  EXPECT_EQ(nearest_word("bogus", words), std::nullopt);
  EXPECT_EQ(nearest_word("x", words), std::nullopt);
  EXPECT_EQ(nearest_word("", words), std::nullopt);
  EXPECT_EQ(nearest_word(std::string(1000, 'a'), words), std::nullopt);
}

TEST(Suggestion, IsSaidInOneSentence) {
  EXPECT_EQ(unknown_word("method", "squadd", words), "unknown method 'squadd'; did you mean 'squad'?");
  EXPECT_EQ(unknown_word("method", "x\n", words),
            "unknown method 'x?', wanted one of auto, squad, timed-c2, timed-c3, hermite-c1, --rate");
}

}}  // namespace orispline
