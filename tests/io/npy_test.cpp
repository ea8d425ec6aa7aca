// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/io/key_file.hpp>
#include <orispline/io/sample_writer.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using namespace std::string_view_literals;
using test::content_of;
using test::ScratchDirectory;
using test::text_of;
using test::TextFile;

/// What stands in a NumPy file of doubles.
struct Array {
  std::size_t rows = 0, columns = 0;
  std::vector<double> values{};  // row by row
};

double little_endian_double(std::string_view bytes) {
  std::uint64_t bits = 0;
  for (std::size_t i = 8; i-- > 0;) bits = bits << 8 | static_cast<unsigned char>(bytes[i]);
  return std::bit_cast<double>(bits);
}

/// Reads a file by NumPy Enhancement Proposal 1; nothing for what is no C-ordered matrix of little-endian doubles.
std::optional<Array> array_in(std::string_view file) {
  if (!file.starts_with("\x93NUMPY\x01\x00"sv) || file.size() < 10) return std::nullopt;
  const std::size_t length = static_cast<unsigned char>(file[8]) + 256u * static_cast<unsigned char>(file[9]);
  std::string_view dictionary = file.substr(10, length), data = file.substr(10 + length);
  constexpr auto beginning = "{'descr': '<f8', 'fortran_order': False, 'shape': ("sv;
  if ((10 + length) % 64 != 0 || !dictionary.ends_with('\n') || !dictionary.starts_with(beginning)) return std::nullopt;
  Array array;
  const char* const end = dictionary.data() + dictionary.size();
  const auto rows = std::from_chars(dictionary.data() + beginning.size(), end, array.rows);
  const auto columns = std::from_chars(rows.ptr + 2, end, array.columns);
  if (!std::string_view(columns.ptr, end).starts_with("), }")) return std::nullopt;
  if (data.size() != 8 * array.rows * array.columns) return std::nullopt;
  for (; !data.empty(); data.remove_prefix(8)) array.values.push_back(little_endian_double(data));
  return array;
}

const Sample moving_sample{
    .motion = {.orientation = quaternion_wxyz(0.5, -0.5, 0.5, -0.5),
               .angular_velocity = {1, 2, 3},
               .angular_acceleration = {4, 5, 6},
               .angular_jerk = {7, 8, 9}},
    .linear_motion = {.position = {10, 20, 30}, .velocity = {11, 12, 13}, .acceleration = {14, 15, 16}}};

/// The array that is written for the same sample at the times.
Array written_array(SampleColumns columns, const std::vector<std::string>& times,
                    const Sample& sample = moving_sample) {
  columns.format = &npy_format;
  const ScratchDirectory directory;
  const std::string path = directory.file("out.npy");
  auto writer = SampleWriter::open(path, columns);
  EXPECT_TRUE(writer);
  for (const std::string& time : times) EXPECT_TRUE(writer->write(Decimal::parse(time).value(), sample));
  EXPECT_TRUE(writer->finish());
  const auto array = array_in(content_of(path));
  EXPECT_TRUE(array);
  return array.value_or(Array{});
}

TEST(Npy, HasAHeaderOf128BytesForAnyNumberOfRows) {
  for (const std::size_t rows : {std::size_t{0}, std::size_t{12345}, std::numeric_limits<std::size_t>::max()}) {
    const std::string header = npy_format.writing.header(
        {.positions = true, .derivatives = 3, .position_derivatives = 2, .settings = {"a", "b", "c", "d", "e"}}, rows);
    EXPECT_EQ(header.size(), 128u);
    EXPECT_NE(header.find("'shape': (" + std::to_string(rows) + ", 28), }"), std::string::npos) << header;
  }
}

TEST(Npy, HoldsTheColumnsOfTheCsvInTheirOrder) {
  const SampleColumns all{.positions = true, .derivatives = 3, .position_derivatives = 2};
  const Array array = written_array(all, {"0.25"});
  const std::vector<double> row{0.25, 0.5, -0.5, 0.5, -0.5, 10, 20, 30, 1,  2,  3, 4,
                                5,    6,   7,    8,   9,    11, 12, 13, 14, 15, 16};
  EXPECT_EQ(array.rows, 1u);
  EXPECT_EQ(array.columns, column_names(all).size());
  EXPECT_EQ(array.values, row);
}

TEST(Npy, HoldsOtherFormsOfOrientation) {
  const Sample level{.motion = {.orientation = quaternion_wxyz(0.0, 0.0, 0.0, 1.0)}};
  const Array array = written_array({.form = {.representation = Representation::matrix}}, {"1"}, level);
  EXPECT_EQ(array.values, (std::vector<double>{1, -1, 0, 0, 0, -1, 0, 0, 0, 1}));
}

TEST(Npy, IsACompleteFileWithoutAnyRow) {
  const Array array = written_array({.derivatives = 1}, {});
  EXPECT_EQ(array.rows, 0u);
  EXPECT_EQ(array.columns, 8u);
}

TEST(Npy, CountsRowsOfSeveralBlocks) {
  const std::vector<std::string> times(20000, "3.5");
  const Array array = written_array({.derivatives = 2}, times);
  ASSERT_EQ(array.rows, times.size());
  EXPECT_EQ(array.values[std::size_t{19999} * 11], 3.5);
  EXPECT_EQ(array.values.back(), 6.0);
}

TEST(Npy, KeepsEveryBitOfADouble) {
  Sample sample;
  sample.linear_motion.position = {std::numeric_limits<double>::denorm_min(), -0.0, std::numeric_limits<double>::max()};
  const Array array = written_array({.positions = true}, {"0"}, sample);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(array.values[static_cast<std::size_t>(5 + i)]),
              std::bit_cast<std::uint64_t>(sample.linear_motion.position[i]));
}

TEST(Npy, RoundsATimeToTheNearestDouble) {
  const Array array = written_array({}, {"1403636580.838555648", "0.1"});
  EXPECT_EQ(array.values[0], 1403636580.838555648);
  EXPECT_EQ(array.values[5], 0.1);
}

TEST(Npy, IsWrittenToAPipeWhenTheRowsAreStated) {
  ::testing::internal::CaptureStdout();
  auto writer = SampleWriter::open("-", {.format = &npy_format}, 1);
  const bool complete = writer && writer->write(Decimal(), moving_sample) && writer->finish();
  const auto array = array_in(::testing::internal::GetCapturedStdout());
  EXPECT_TRUE(complete);
  ASSERT_TRUE(array);
  EXPECT_EQ(array->rows, 1u);
}

TEST(Npy, RefusesNumbersThatAreNotFinite) {
  const ScratchDirectory directory;
  auto writer = SampleWriter::open(directory.file("out.npy"), {.format = &npy_format, .positions = true});
  ASSERT_TRUE(writer);
  Sample sample;
  sample.linear_motion.position.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(writer->write(Decimal::parse("11.5").value(), sample).error().message,
            "the sample at time 11.5 has a number that is not finite");
}

TEST(Npy, IsNoFileOfKeys) {
  EXPECT_EQ(text_of(read_keys(TextFile("", "keys.npy").path()).error()),
            "keys.npy: keys are not read from NumPy files, wanted " + any_of(formats_read()));
}

}}  // namespace orispline::io
