// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/npy_header.hpp>

#include <string_view>

#include <orispline/base/formatted.hpp>

namespace orispline::io {

std::string npy_header(std::size_t rows, std::size_t columns) {
  using namespace std::string_view_literals;
  constexpr std::size_t size = 128, size_of_length = 2;  // [bytes] the data are aligned to 64
  constexpr auto magic_and_version = "\x93NUMPY\x01\x00"sv;
  constexpr std::size_t length = size - magic_and_version.size() - size_of_length;  // below 256: its high byte is 0
  const std::string dictionary =
      formatted("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}", rows, columns);
  std::string header(magic_and_version);
  header += {static_cast<char>(length), '\0'};
  return header + formatted("{:<{}}\n", dictionary, length - 1);
}

}  // namespace orispline::io
