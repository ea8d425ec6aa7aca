// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/text_table.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>

#include <fast_float/fast_float.h>

#include <orispline/base/quoted.hpp>
#include <orispline/io/recipe_line.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// The character of a delimiter; of blanks the first.
constexpr char character_of(Delimiter delimiter) { return ",;\t "[static_cast<std::size_t>(delimiter)]; }

// Blanks are few: plain loops are faster than the searches of string_view for several characters.

std::string_view without_leading_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  return text;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return without_leading_blanks(text);
}

/// Length of the cell that a text begins with, up to the delimiter or the end.
std::size_t cell_length(std::string_view text, Delimiter delimiter) {
  if (delimiter != Delimiter::blanks) return std::min(text.find(character_of(delimiter)), text.size());
  return static_cast<std::size_t>(std::find_if(text.begin(), text.end(), is_blank) - text.begin());
}

/// Where the quotes that a text begins with end; doubled ones stand for one in the cell. npos if they do not.
std::size_t closing_quote(std::string_view text) {
  std::size_t at = text.find('"', 1);
  while (at < text.size() && text.substr(at + 1).starts_with('"')) at = text.find('"', at + 2);
  return at;
}

/// The characters outside of quotes that begin a cell and are closed.
std::string without_quoted(std::string_view line) {
  std::string rest;
  for (bool begins_cell = true; !line.empty();) {
    const std::size_t closing = begins_cell && line.front() == '"' ? closing_quote(line) : std::string_view::npos;
    const char c = line.front();
    if (closing == std::string_view::npos) rest += c;
    begins_cell = closing == std::string_view::npos && (c == ',' || c == ';' || is_blank(c));
    line.remove_prefix(closing == std::string_view::npos ? 1 : closing + 1);
  }
  return rest;
}

bool begins_like_number(std::string_view cell) {
  return std::string_view("+-.0123456789").find(cell.front()) != std::string_view::npos;
}

bool is_word(std::string_view number) {
  return number.find_first_of("0123456789") == std::string_view::npos || number.find('(') != std::string_view::npos;
}

}  // namespace

Delimiter delimiter_of(std::string_view line) {
  const std::string text = without_quoted(trimmed(line));
  for (const Delimiter delimiter : {Delimiter::semicolon, Delimiter::comma, Delimiter::tab})
    if (text.find(character_of(delimiter)) != std::string::npos) return delimiter;
  return Delimiter::blanks;
}

std::size_t width_of(std::span<const std::string_view> cells) noexcept {
  while (!cells.empty() && cells.back().empty()) cells = cells.first(cells.size() - 1);
  return cells.size();
}

bool is_header(std::span<const std::string_view> row) {
  const auto first = std::find_if(row.begin(), row.end(), [](std::string_view cell) { return !cell.empty(); });
  return first != row.end() && !begins_like_number(*first) && !number_of(*first);
}

Expected<double> number_of(std::string_view cell) {
  if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::string_view text = cell;
  if (text.starts_with('+')) text.remove_prefix(1);  // fast_float takes no plus sign
  double value = 0.0;
  const auto [end, status] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  const bool two_signs = text.size() < cell.size() && text.starts_with('-');
  if (two_signs || status == std::errc::invalid_argument || end != text.data() + text.size())
    return failure(ErrorCode::bad_data, "found " + in_quotes(cell) + ", wanted a number such as -1.5e-3");
  if (std::isinf(value) && !is_word(text))
    return failure(ErrorCode::bad_data, "found " + in_quotes(cell) + ", wanted a number below 1.8e308 in size");
  return value;
}

Expected<std::optional<Decimal>> decimal_of(std::string_view cell) {
  Expected<Decimal> number = Decimal::parse(cell);
  if (number) return *number;
  const Expected<double> rounded = number_of(cell);
  if (rounded && (cell.empty() || is_word(cell))) return std::nullopt;
  return tl::unexpected(std::move(number.error()));
}

Expected<TextTable> TextTable::open(Input input) {
  return LineReader::open(std::move(input)).map([](LineReader&& lines) { return TextTable(std::move(lines)); });
}

Expected<bool> TextTable::next() {
  for (;;) {
    const auto line = lines_.next();
    if (!line) return tl::unexpected(line.error());
    if (!*line) return false;
    const std::string_view text = without_leading_blanks(**line);
    if (cells_.empty() && text.starts_with('#') && !is_recipe_line(text)) comment_ = text;
    if (text.empty() || text.starts_with('#')) continue;
    if (!delimiter_) delimiter_ = delimiter_of(text);
    return split(**line);
  }
}

std::vector<std::string_view> TextTable::header_in_comment() const {
  constexpr std::string_view label = "HEADER:";
  if (is_header(cells_)) return {};
  std::string_view text = comment_;
  text.remove_prefix(std::min(text.find_first_not_of("# \t"), text.size()));
  if (text.starts_with(label)) text.remove_prefix(label.size());
  const Delimiter delimiter = delimiter_of(text);
  std::vector<std::string_view> cells;
  for (text = trimmed(without_leading_blanks(text)); !text.empty(); text = without_leading_blanks(text)) {
    const std::string_view whole = text.substr(0, cell_length(text, delimiter));
    text.remove_prefix(std::min(whole.size() + 1, text.size()));
    const std::size_t begin = std::min(whole.find_first_not_of(" \t\""), whole.size());
    cells.push_back(whole.substr(begin, whole.find_last_not_of(" \t\"") + 1 - begin));
  }
  return is_header(cells) && cells.size() == width_of(cells_) ? cells : std::vector<std::string_view>();
}

LineReader TextTable::from_its_beginning() && {
  lines_.rewind();
  return std::move(lines_);
}

/// Fills the cells; an empty text after a delimiter is a cell, blanks as delimiters count once.
Expected<bool> TextTable::split(std::string_view line) {
  cells_.clear();
  with_doubled_quotes_.clear();
  if (delimiter_ == Delimiter::blanks) line = trimmed(line);
  for (bool more = true; more;) {
    if (delimiter_ != Delimiter::tab) line = without_leading_blanks(line);
    std::size_t quoted_length = 0;
    if (line.starts_with('"')) {
      const std::size_t closing = closing_quote(line);
      if (closing == std::string_view::npos)
        return failure(ErrorCode::bad_data, "found a quote that is not closed", here(cells_.size()));
      quoted_length = closing + 1;
    }
    const std::size_t length = quoted_length + cell_length(line.substr(quoted_length), *delimiter_);
    std::string_view cell = trimmed(line.substr(0, length));
    if (quoted_length > 0 && cell.size() == quoted_length) cell = unquoted(cell);
    cells_.push_back(cell);
    more = length < line.size();
    line.remove_prefix(more ? length + 1 : length);
  }
  return true;
}

std::string_view TextTable::unquoted(std::string_view cell) {
  cell = trimmed(cell.substr(1, cell.size() - 2));
  if (cell.find("\"\"") == std::string_view::npos) return cell;
  std::string& text = with_doubled_quotes_.emplace_back();
  for (std::size_t i = 0; i < cell.size(); i += cell.substr(i).starts_with("\"\"") ? 2 : 1) text += cell[i];
  return text;
}

Where TextTable::here(std::optional<std::size_t> cell) const {
  return {path(), line(), cell ? std::optional(*cell + 1) : std::nullopt, std::nullopt};
}

}}}  // namespace orispline::io
