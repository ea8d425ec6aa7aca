// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/key_table.hpp>

#include <gtest/gtest.h>

#include <orispline/io/key_file.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

TEST(KeyTable, TakesTheNamesOfColumnsThatHaveCells) {
  const test::TextFile file("t,qw,qx,qy,qz,\n0,1,0,0,0,\n1,0.8,0.6,0,0,\n");
  const auto keys = read_keys(file.path(), {.keep_table = true});
  ASSERT_TRUE(keys) << test::text_of(keys.error());
  EXPECT_EQ(csv_with_columns(keys->table, {{"tension", {1.0, 0.5}}}),
            "t,qw,qx,qy,qz,tension\n0,1,0,0,0,1\n1,0.8,0.6,0,0,0.5\n");
}

TEST(KeyTable, FillsRowsThatAreTooShort) {
  const KeyTable table{.names = {"t", "note"}, .rows = {{"0"}, {}, {"2", "x", "beyond"}}};
  EXPECT_EQ(csv_with_columns(table, {}), "t,note\n0,\n,\n2,x\n");
}

TEST(KeyTable, FillsColumnsThatAreTooShort) {
  const KeyTable table{.names = {"t", "bias"}, .rows = {{"0", "9"}, {"1", "9"}}};
  EXPECT_EQ(csv_with_columns(table, {{"bias", {0.25}}, {"tension", {}}}), "t,bias,tension\n0,0.25,\n1,,\n");
}

TEST(KeyTable, PutsNamesAndCellsWithSeparatorsInQuotes) {
  const KeyTable table{.names = {"t", "a,b"}, .rows = {{"0", "say \"so\""}, {"1", "two\nlines"}}};
  EXPECT_EQ(csv_with_columns(table, {{"c;d", {1.0, 2.0}}}),
            "t,\"a,b\",\"c;d\"\n0,\"say \"\"so\"\"\",1\n1,\"two\nlines\",2\n");
}

TEST(KeyTable, IsReadAsItWasWritten) {
  const KeyTable table{
      .names = {"#1", "t", "qw", "qx", "qy", "qz", "a;\"b\",c"},
      .rows = {{"# not a comment", "0", "1", "0", "0", "0", "\""}, {"", "1", "1", "0", "0", "0", "\"\"x\"\" y\"\""}}};
  const test::TextFile file(csv_with_columns(table, {}));
  const auto keys = read_keys(file.path(), {.keep_table = true});
  ASSERT_TRUE(keys) << test::text_of(keys.error());
  EXPECT_EQ(keys->table.names, table.names);
  EXPECT_EQ(keys->table.rows, table.rows);
}

}}  // namespace orispline::io
