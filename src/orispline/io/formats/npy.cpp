// SPDX-License-Identifier: Apache-2.0
// NumPy files (.npy, version 1.0) of doubles: little-endian, C order, shape (rows, columns).
// Format: NumPy Enhancement Proposal 1.
#include <algorithm>
#include <bit>

#include <orispline/base/formatted.hpp>
#include <orispline/io/file_format.hpp>
#include <orispline/io/sample_columns.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace { namespace npy {

constexpr std::array<std::string_view, 1> extensions{".npy"};

/// It has 128 bytes whatever the numbers are, so that it can be written again once the rows are counted.
std::string header(const SampleColumns& columns, std::size_t rows) {
  using namespace std::string_view_literals;
  constexpr std::size_t size = 128, size_of_length = 2;  // [bytes] the data are aligned to 64
  constexpr auto magic_and_version = "\x93NUMPY\x01\x00"sv;
  constexpr std::size_t length = size - magic_and_version.size() - size_of_length;  // below 256: its high byte is 0
  const std::string dictionary =
      formatted("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}", rows, column_names(columns).size());
  std::string header(magic_and_version);
  header += {static_cast<char>(length), '\0'};
  return header + formatted("{:<{}}\n", dictionary, length - 1);
}

using DoubleBytes = std::array<char, sizeof(double)>;

DoubleBytes little_endian(double value) {
  auto bytes = std::bit_cast<DoubleBytes>(value);
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(bytes);
  return bytes;
}

void row(std::string& bytes, double time, std::span<const double> numbers) {
  std::array<DoubleBytes, 1 + RowNumbers::most> row;
  row[0] = little_endian(time);
  std::ranges::transform(numbers, row.begin() + 1, little_endian);
  bytes.append(row.front().data(), (1 + numbers.size()) * sizeof(double));
}

}  // namespace npy

}  // namespace

constinit const FormatInfo npy_format{
    .id = "npy",
    .title = "NumPy",
    .file = "a NumPy file",
    .summary = "an array of doubles with the columns of a CSV",
    .extensions = npy::extensions,
    .holds = {.forms = true, .rates = true, .settings = true},
    .writing = {.header = npy::header, .counts_rows = true, .numbers = named_numbers, .rounded_row = npy::row}};

}}}  // namespace orispline::io
