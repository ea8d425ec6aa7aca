// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/table.hpp>

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/base/pieces.hpp>
#include <orispline/report/characters.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

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

/// The word of a row that is too long for the first column, which then stays empty.
std::string word_above(const Table& table, std::size_t row) {
  const std::size_t widest = table.columns.empty() ? 0 : table.columns.front().widest;
  if (widest == 0 || table.rows[row].empty() || !is_word(table.rows[row].front())) return {};
  const std::string& word = std::get<std::string>(table.rows[row].front());
  return characters(word) > widest ? word : std::string();
}

/// A column's texts from its head down; words are aligned with words.
struct Strip {
  std::vector<std::string> texts;
  std::size_t width = 0;
  bool words = false;
};

using Heads = std::vector<std::string> (*)(const Column& column);

std::vector<std::string> in_one_line(const Column& column) { return {column.name}; }

/// The name, and the unit below it.
std::vector<std::string> in_two_lines(const Column& column) {
  const std::size_t unit = column.name.find(" [");
  if (unit == std::string::npos) return {column.name, ""};
  return {column.name.substr(0, unit), column.name.substr(unit + 1)};
}

Strip strip_of(const Table& table, std::size_t i, Heads heads) {
  Strip strip{.texts = heads(table.columns[i])};
  std::size_t words = 0;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const auto& row = table.rows[r];
    const bool is_empty = i >= row.size() || (i == 0 && !word_above(table, r).empty());
    strip.texts.push_back(is_empty ? "" : text_of(row[i], table.columns[i]));
    words += i < row.size() && is_word(row[i]) ? 1 : 0;
  }
  strip.words = 2 * words > table.rows.size();
  for (const std::string& text : strip.texts) strip.width = std::max(strip.width, characters(text));
  return strip;
}

std::vector<Strip> strips_of(const Table& table, Heads heads) {
  std::vector<Strip> strips;
  for (std::size_t i = 0; i < table.columns.size(); ++i) strips.push_back(strip_of(table, i, heads));
  return strips;
}

std::string padded(const Strip& strip, std::size_t row) {
  const std::string& text = strip.texts[row];
  const std::string space(strip.width - characters(text), ' ');
  return strip.words ? text + space : space + text;
}

/// A line of the table, heads included.
std::string line_of(const std::vector<Strip>& strips, std::size_t row) {
  std::string line;
  for (const Strip& strip : strips) line += "  " + padded(strip, row);
  return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

/// A row with the word above it, where it has one.
std::string lines_of(const Table& table, const std::vector<Strip>& strips, std::size_t row, std::size_t head_lines) {
  const std::string above = word_above(table, row);
  return (above.empty() ? "" : "  " + above + "\n") + line_of(strips, head_lines + row);
}

std::size_t width_of(const std::vector<Strip>& strips) {
  std::size_t sum = 0;
  for (const Strip& strip : strips) sum += 2 + strip.width;
  return sum;
}

/// Words in lines of so many characters, which begin with these blanks; a longer word has a line of its own.
std::string wrapped(std::string_view text, std::size_t longest, std::string_view blanks) {
  std::string lines, line;
  for (const std::string_view word : pieces_of(text, ' ')) {
    if (!line.empty() && blanks.size() + characters(line) + 1 + characters(word) > longest) {
      lines.append(blanks).append(line).append("\n");
      line.clear();
    }
    line.append(line.empty() ? "" : " ").append(word);
  }
  return lines.append(blanks).append(line).append("\n");
}

/// Leaves columns out until the rest fits, or may not be left out; says which.
std::vector<std::string> narrowed(Table& table, std::size_t longest) {
  std::vector<std::string> left_out;
  while (width_of(strips_of(table, in_two_lines)) > longest) {
    const auto column = std::ranges::max_element(table.columns, {}, &Column::rank);
    if (column == table.columns.end() || column->rank == 0) break;
    const auto index = column - table.columns.begin();
    left_out.push_back(in_two_lines(*column).front());
    table.columns.erase(column);
    for (auto& row : table.rows)
      if (row.size() > static_cast<std::size_t>(index)) row.erase(row.begin() + index);
  }
  return left_out;
}

}  // namespace

std::string text_of(const Table& table) {
  const auto strips = strips_of(table, in_one_line);
  std::string text = table.title + "\n" + line_of(strips, 0);
  for (std::size_t row = 0; row < table.rows.size(); ++row) text += lines_of(table, strips, row, 1);
  for (const std::string& note : table.notes) text += "  " + note + "\n";
  return text;
}

std::string text_of(Table table, std::size_t longest, std::string_view left_out) {
  const bool fits = width_of(strips_of(table, in_one_line)) <= longest;
  const Heads heads = fits ? in_one_line : in_two_lines;
  if (const auto names = heads == in_two_lines ? narrowed(table, longest) : std::vector<std::string>(); !names.empty())
    table.notes.push_back(formatted("{} {}.", left_out, joined(names, ", ")));
  const auto strips = strips_of(table, heads);
  const std::size_t head_lines = heads == in_two_lines ? 2 : 1;
  std::string text = wrapped(table.title, longest, "");
  for (std::size_t line = 0; line < head_lines; ++line) text += line_of(strips, line);
  for (std::size_t row = 0; row < table.rows.size(); ++row) text += lines_of(table, strips, row, head_lines);
  for (const std::string& note : table.notes) text += wrapped(note, longest, "  ");
  return text;
}

}}}  // namespace orispline::report
