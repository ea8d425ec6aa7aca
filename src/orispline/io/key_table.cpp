// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/key_table.hpp>

#include <algorithm>
#include <array>

#include <orispline/base/number_text.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

/// In quotes where it holds what separates cells or rows, or looks like a comment.
std::string cell_of(std::string_view text) {
  if (text.find_first_of(",;\t\"\r\n") == std::string_view::npos && !text.starts_with('#')) return std::string(text);
  std::string cell = "\"";
  for (const char c : text) cell.append(c == '"' ? 2 : 1, c);
  return cell + "\"";
}

std::string number_cell(double value) {
  std::array<char, shortest_text_room> text;
  return {text.data(), write_shortest_text(text.data(), value)};
}

/// Empty where a row or a column ends before it, as in a table that a caller made.
std::string cell_at(const std::vector<std::string>& row, std::size_t i) {
  return i < row.size() ? cell_of(row[i]) : std::string();
}
std::string cell_at(const std::vector<double>& column, std::size_t key) {
  return key < column.size() ? number_cell(column[key]) : std::string();
}

}  // namespace

std::string csv_with_columns(const KeyTable& table, const NumberColumns& columns) {
  std::vector<std::string_view> added;
  for (const auto& [name, values] : columns)
    if (std::ranges::find(table.names, name) == table.names.end()) added.push_back(name);
  std::string text;
  const auto end_cell = [&text](bool last) { text += last ? '\n' : ','; };
  const std::size_t width = table.names.size() + added.size();
  for (std::size_t i = 0; i < width; ++i) {
    text += i < table.names.size() ? cell_of(table.names[i]) : cell_of(added[i - table.names.size()]);
    end_cell(i + 1 == width);
  }
  for (std::size_t key = 0; key < table.rows.size(); ++key)
    for (std::size_t i = 0; i < width; ++i) {
      const std::string_view name = i < table.names.size() ? table.names[i] : added[i - table.names.size()];
      const auto column = columns.find(name);
      text += column == columns.end() ? cell_at(table.rows[key], i) : cell_at(column->second, key);
      end_cell(i + 1 == width);
    }
  return text;
}

}}}  // namespace orispline::io
