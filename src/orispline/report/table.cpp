// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/table.hpp>

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/report/characters.hpp>

namespace orispline::inline ORISPLINE_ABI::report {
namespace {

bool is_word(const Cell& cell) { return std::holds_alternative<std::string>(cell); }

std::string text_of(const Cell& cell, const Column& column) {
  if (is_word(cell)) return std::get<std::string>(cell);
  const double number = std::get<double>(cell);
  switch (column.notation) {
    case Notation::fixed:
      return formatted("{:.{}f}", number, column.digits);
    case Notation::scientific:
      return formatted("{:.{}e}", number, column.digits);
    case Notation::shortest:
      break;
  }
  return formatted("{:.{}g}", number, column.digits);
}

/// A column's texts from its head down; words are aligned with words.
struct Strip {
  std::vector<std::string> texts;
  std::size_t width = 0;
  bool words = false;
};

Strip strip_of(const Table& table, std::size_t i) {
  Strip strip{.texts = {table.columns[i].name}};
  std::size_t words = 0;
  for (const auto& row : table.rows) {
    strip.texts.push_back(i < row.size() ? text_of(row[i], table.columns[i]) : "");
    words += i < row.size() && is_word(row[i]) ? 1 : 0;
  }
  strip.words = 2 * words > table.rows.size();
  for (const std::string& text : strip.texts) strip.width = std::max(strip.width, characters(text));
  return strip;
}

std::string padded(const Strip& strip, std::size_t row) {
  const std::string& text = strip.texts[row];
  const std::string space(strip.width - characters(text), ' ');
  return strip.words ? text + space : space + text;
}

}  // namespace

std::string text_of(const Table& table) {
  std::vector<Strip> strips;
  for (std::size_t i = 0; i < table.columns.size(); ++i) strips.push_back(strip_of(table, i));
  std::string text = table.title + "\n";
  for (std::size_t row = 0; row <= table.rows.size(); ++row) {
    std::string line;
    for (const Strip& strip : strips) line += "  " + padded(strip, row);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  for (const std::string& note : table.notes) text += "  " + note + "\n";
  return text;
}

}  // namespace orispline::inline ORISPLINE_ABI::report
