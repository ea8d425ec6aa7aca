// SPDX-License-Identifier: Apache-2.0
// However a file is cut into pieces, its keys, repairs and errors are those of the file.
#include <orispline/io/key_columns.hpp>
#include <orispline/io/key_reader.hpp>

#include <random>

#include <gtest/gtest.h>

#include "text_file.hpp"

namespace orispline::io { namespace {

using test::TextFile;

template <class List>
void append(List& list, const List& more) {
  list.insert(list.end(), more.begin(), more.end());
}

/// The file in pieces of that many keys at random, put together again.
Expected<KeyFile> in_pieces(const std::string& path, const ReadOptions& options, std::uint64_t seed) {
  auto reader = KeyReader::open(path, options);
  if (!reader) return tl::unexpected(reader.error());
  std::mt19937_64 random(seed);
  KeyFile all;
  while (!reader->is_at_end()) {
    const std::size_t most = 1 + random() % 7;
    auto piece = reader->next(most);
    if (!piece) return piece;
    EXPECT_TRUE(options.sort || piece->data.times.size() == most || reader->is_at_end());
    for (auto list : {&KeyframeData::positions, &KeyframeData::angular_velocities})
      append(all.data.*list, piece->data.*list);
    append(all.data.times, piece->data.times);
    append(all.data.orientations, piece->data.orientations);
    append(all.lines, piece->lines);
    append(all.exact_times, piece->exact_times);
    append(all.table.rows, piece->table.rows);
    for (const auto& [name, values] : piece->parameters) append(all.parameters[name], values);
    all.path = piece->path;
    all.format = piece->format;
    all.epoch = piece->epoch;
    all.repairs = piece->repairs;
    all.table.names = piece->table.names;
    all.ignored_columns = piece->ignored_columns;
  }
  return all;
}

void expect_same(const KeyFile& file, const KeyFile& whole) {
  EXPECT_EQ(file.path, whole.path);
  EXPECT_EQ(file.format, whole.format);
  EXPECT_EQ(file.epoch, whole.epoch);
  EXPECT_EQ(file.data.times, whole.data.times);
  EXPECT_TRUE(file.data.orientations == whole.data.orientations);
  EXPECT_TRUE(file.data.positions == whole.data.positions);
  EXPECT_TRUE(file.data.angular_velocities == whole.data.angular_velocities);
  EXPECT_EQ(file.lines, whole.lines);
  EXPECT_EQ(file.exact_times, whole.exact_times);
  EXPECT_EQ(file.table.names, whole.table.names);
  EXPECT_EQ(file.table.rows, whole.table.rows);
  EXPECT_EQ(file.parameters, whole.parameters);
  EXPECT_EQ(file.repairs.duplicates_dropped, whole.repairs.duplicates_dropped);
  EXPECT_EQ(file.repairs.invalid_dropped, whole.repairs.invalid_dropped);
  EXPECT_EQ(file.repairs.rows_moved, whole.repairs.rows_moved);
  EXPECT_EQ(file.ignored_columns, whole.ignored_columns);
}

/// Rows with duplicates, invalid ones and comments among them.
std::string faulty_rows(const char* header, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::string text = header;
  double time = 1700000000.0;
  for (int i = 0; i < 60; ++i) {
    if (random() % 4 != 0) time += 0.125;
    const char* w = random() % 9 == 0 ? "nan" : "1";
    text += std::to_string(time) + "," + w + ",0,0,0,1,2," + std::to_string(i) + ",0.5,0,0,0.25,x\n";
    if (random() % 11 == 0) text += "# a comment\n\n";
  }
  return text;
}

constexpr const char* full_header = "t,qw,qx,qy,qz,px,py,pz,wx,wy,wz,tension,note\n";

TEST(KeyReader, GivesTheKeysOfTheFileHoweverItIsCut) {
  const TextFile file(faulty_rows(full_header, 51));
  for (const bool sort : {false, true}) {
    const ReadOptions options{.drop_duplicates = true,
                              .drop_invalid = true,
                              .sort = sort,
                              .keep_exact_times = true,
                              .keep_table = true,
                              .parameters = {"tension"}};
    const auto whole = read_keys(file.path(), options);
    ASSERT_TRUE(whole) << describe(whole.error());
    ASSERT_GT(whole->repairs.duplicates_dropped, 3u);
    ASSERT_GT(whole->repairs.invalid_dropped, 3u);
    for (std::uint64_t seed = 0; seed < 20; ++seed) expect_same(in_pieces(file.path(), options, seed).value(), *whole);
  }
}

TEST(KeyReader, FindsTheErrorsOfTheFileHoweverItIsCut) {
  const std::string good = "t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n2,1,0,0,0\n3,1,0,0,0\n4,1,0,0,0\n5,1,0,0,0\n";
  for (const char* bad : {"5,1,0,0,0\n", "4.5,1,0,0,0\n", "6,1,0,0\n", "6,1,0,zero,0\n", "6,nan,0,0,0\n",
                          "5.0000000000000000001,1,0,0,0\n", "6,\"1,0,0,0\n", "6,1,0,0,0,7\n"}) {
    const TextFile file(good + bad + "9,1,0,0,0\n");
    const auto whole = read_keys(file.path());
    ASSERT_FALSE(whole) << bad;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const auto pieces = in_pieces(file.path(), {}, seed);
      ASSERT_FALSE(pieces) << bad;
      EXPECT_EQ(describe(pieces.error()), describe(whole.error()));
      EXPECT_EQ(pieces.error().where.key, whole.error().where.key);
    }
  }
  for (const char* empty : {"", "t,qw,qx,qy,qz\n", "t,qw,qx,qy,qz\n0,nan,0,0,0\n"}) {
    const TextFile file(empty);
    const ReadOptions options{.drop_invalid = true};
    EXPECT_EQ(describe(in_pieces(file.path(), options, 1).error()), describe(read_keys(file.path(), options).error()));
  }
}

TEST(KeyReader, KnowsTheColumnsBeforeTheKeysAreRead) {
  const TextFile file(faulty_rows(full_header, 52));
  const auto reader = KeyReader::open(file.path(), {.parameters = {"tension"}});
  ASSERT_TRUE(reader);
  ASSERT_TRUE(reader->columns());
  EXPECT_TRUE(reader->columns()->position && reader->columns()->rates[0] && !reader->columns()->rates[1]);
  ASSERT_EQ(reader->columns()->parameters.size(), 1u);
  EXPECT_EQ(reader->columns()->parameters[0].name, "tension");
  EXPECT_FALSE(reader->is_at_end());
}

TEST(KeyReader, CountsTheBytesThatItReads) {
  const TextFile file(faulty_rows(full_header, 53));
  auto reader = KeyReader::open(file.path(), {.drop_duplicates = true, .drop_invalid = true}).value();
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(reader.bytes_read(), faulty_rows(full_header, 53).size());
}

}}  // namespace orispline::io
