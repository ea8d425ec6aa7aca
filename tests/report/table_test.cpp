// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/table.hpp>

#include <gtest/gtest.h>

#include <orispline/report/characters.hpp>

namespace orispline::report { namespace {

TEST(Table, AlignsWordsToTheLeftAndNumbersToTheRight) {
  const Table table{
      .title = "Speeds",
      .columns = {{"curve"}, {"|ω| [rad/s]", Notation::fixed, 2}, {"error", Notation::scientific, 1}, {"n"}},
      .rows = {{"slerp", 1.0, 0.00123, 5.0}, {"β = 1/12", 12.345, 0.0, "–"}},
      .notes = {"A note.", "Another."}};
  EXPECT_EQ(text_of(table),
            "Speeds\n"
            "  curve     |ω| [rad/s]    error  n\n"
            "  slerp            1.00  1.2e-03  5\n"
            "  β = 1/12        12.35  0.0e+00  –\n"
            "  A note.\n"
            "  Another.\n");
}

TEST(Table, LeavesMissingCellsEmptyAndNoBlanksAtTheEnd) {
  const Table table{.title = "t", .columns = {{"a"}, {"b"}, {"c"}}, .rows = {{"word", "x"}, {1.5}}};
  EXPECT_EQ(text_of(table),
            "t\n"
            "     a  b  c\n"
            "  word  x\n"
            "   1.5\n");
}

TEST(Table, PrintsShortestNumbersWithTheDigitsAskedFor) {
  const Table table{.title = "t", .columns = {{"a", Notation::shortest, 3}}, .rows = {{1.28456}, {0.25}, {123456.0}}};
  EXPECT_EQ(text_of(table), "t\n         a\n      1.28\n      0.25\n  1.23e+05\n");
}

Table speeds() {
  return {.title = "Speeds of some curves on a file",
          .columns = {{"curve"}, {"RMS [°]"}, {.name = "time [s]", .rank = 2}, {.name = "∫|α|² [rad²/s³]", .rank = 1}},
          .rows = {{"slerp", 1.25, 0.5, 17.0}, {"odd", "–", "–", "–"}},
          .notes = {"A note of a few words.", "odd has no curve: found 1 key, wanted 2"}};
}

TEST(Table, ThatFitsIsLeftAsItIs) { EXPECT_EQ(text_of(speeds(), 200, "Left out:"), text_of(speeds())); }

TEST(Table, PutsUnitsBelowAndWrapsNotesWhereThereIsLittleRoom) {
  EXPECT_EQ(text_of(speeds(), 36, "Left out:"),
            "Speeds of some curves on a file\n"
            "  curve   RMS  time      ∫|α|²\n"
            "          [°]   [s]  [rad²/s³]\n"
            "  slerp  1.25   0.5         17\n"
            "  odd       –     –          –\n"
            "  A note of a few words.\n"
            "  odd has no curve: found 1 key,\n"
            "  wanted 2\n");
}

TEST(Table, PutsALongWordAboveItsRow) {
  Table table = speeds();
  table.columns[0].widest = 8;
  table.rows[0][0] = "slerp along a far way";
  EXPECT_EQ(text_of(table, 36, "Left out:"),
            "Speeds of some curves on a file\n"
            "  curve   RMS  time      ∫|α|²\n"
            "          [°]   [s]  [rad²/s³]\n"
            "  slerp along a far way\n"
            "         1.25   0.5         17\n"
            "  odd       –     –          –\n"
            "  A note of a few words.\n"
            "  odd has no curve: found 1 key,\n"
            "  wanted 2\n");
  EXPECT_NE(text_of(table).find("\n  slerp along a far way\n            1.25 "), std::string::npos) << text_of(table);
}

TEST(Table, LeavesOutTheHighestRankFirstAndSaysSo) {
  EXPECT_EQ(text_of(speeds(), 28, "Left out:"),
            "Speeds of some curves on a\n"
            "file\n"
            "  curve   RMS      ∫|α|²\n"
            "          [°]  [rad²/s³]\n"
            "  slerp  1.25         17\n"
            "  odd       –          –\n"
            "  A note of a few words.\n"
            "  odd has no curve: found 1\n"
            "  key, wanted 2\n"
            "  Left out: time.\n");
  const std::string least = text_of(speeds(), 8, "Left out:");
  EXPECT_NE(least.find("  slerp  1.25\n"), std::string::npos) << least;  // of no rank
  EXPECT_NE(least.find("time,\n  ∫|α|².\n"), std::string::npos) << least;
}

TEST(Characters, AreCountedAsTheyAreSeen) {
  EXPECT_EQ(characters(""), 0U);
  EXPECT_EQ(characters("abc"), 3U);
  EXPECT_EQ(characters("|ω| ≤ 1°"), 8U);
  EXPECT_EQ(characters("R(v\u0302)"), 4U);  // v with a hat above it
}

}}  // namespace orispline::report
