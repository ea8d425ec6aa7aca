// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/file_format.hpp>

#include <algorithm>
#include <array>

namespace orispline::io {
namespace {

char lower(char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool ends_in(std::string_view path, std::string_view extension) {
  return path.size() > extension.size() &&
         std::equal(extension.rbegin(), extension.rend(), path.rbegin(), [](char a, char b) { return a == lower(b); });
}

}  // namespace

std::string_view title_of(FileFormat format) noexcept {
  constexpr std::array<std::string_view, 4> titles{"CSV", "TUM", "EuRoC", "NumPy"};
  return titles[static_cast<std::size_t>(format)];
}

std::optional<FileFormat> format_of_extension(std::string_view path) noexcept {
  if (ends_in(path, ".csv")) return FileFormat::csv;
  if (ends_in(path, ".tum")) return FileFormat::tum;
  if (ends_in(path, ".npy")) return FileFormat::npy;
  return std::nullopt;
}

}  // namespace orispline::io
