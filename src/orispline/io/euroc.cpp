// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/euroc.hpp>

#include <algorithm>
#include <array>

namespace orispline::io {
namespace {

constexpr std::string_view blanks = " \t";

/// A name without blanks around it and without the unit behind it. Time alone may only be in nanoseconds.
std::string_view plain_name(std::string_view cell) {
  const std::size_t begin = std::min(cell.find_first_not_of(blanks), cell.size());
  cell.remove_prefix(begin);
  if (cell.starts_with("timestamp [ns]") || cell.starts_with("timestamp_ns")) return "timestamp";
  if (cell.starts_with("timestamp [")) return cell;
  return cell.substr(0, cell.find_first_of(" \t["));
}

/// The names of `euroc_header`, plain.
constexpr std::array<std::string_view, euroc_columns> plain_names{"timestamp", "p_RS_R_x", "p_RS_R_y", "p_RS_R_z",
                                                                  "q_RS_w",    "q_RS_x",   "q_RS_y",   "q_RS_z"};

}  // namespace

bool names_euroc(std::span<const std::string_view> cells) noexcept {
  return cells.size() >= plain_names.size() &&
         std::equal(plain_names.begin(), plain_names.end(), cells.begin(),
                    [](std::string_view name, std::string_view cell) { return plain_name(cell) == name; });
}

bool names_euroc(std::string_view header) noexcept {
  header.remove_prefix(std::min(header.find_first_not_of("# \t"), header.size()));
  std::array<std::string_view, euroc_columns> cells;
  for (std::string_view& cell : cells) {
    cell = header.substr(0, header.find(','));
    header.remove_prefix(std::min(cell.size() + 1, header.size()));
  }
  return names_euroc(cells);
}

}  // namespace orispline::io
