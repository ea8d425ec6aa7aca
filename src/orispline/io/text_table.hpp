// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/decimal.hpp>
#include <orispline/io/line_reader.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// What stands between two cells of a line.
enum class Delimiter { comma, semicolon, tab, blanks };

/// The first of semicolon, comma, tab that occurs in the line outside of quotes; blanks if none does.
[[nodiscard]] Delimiter delimiter_of(std::string_view line);

/// The number in a cell: `nan` and `inf` in any case of letters are not finite, an empty cell is NaN, numbers below the
/// range of a double are 0.
///
/// Errors (bad_data): not a number (hexadecimal, decimal comma, text after it), out of range.
[[nodiscard]] Expected<double> number_of(std::string_view cell);

/// The exact number in a cell; nothing where `number_of` is not finite.
[[nodiscard]] Expected<std::optional<Decimal>> decimal_of(std::string_view cell);

/// Cells of a row without the empty ones at its end.
[[nodiscard]] std::size_t width_of(std::span<const std::string_view> cells) noexcept;

/// Whether the first row of a table names columns: its first cell that is not empty is no number.
[[nodiscard]] bool is_header(std::span<const std::string_view> row);

/// Streams the rows of a text table: lines split into cells, without `#` comments and blank lines.
class TextTable {
 public:
  [[nodiscard]] static Expected<TextTable> open(Input input);
  /// The table in the lines that were not read yet.
  explicit TextTable(LineReader lines) : lines_(std::move(lines)) {}

  /// Moves to the next row; false after the last one. Error: of `LineReader::next`, or a quote that is not closed.
  ///
  /// The first row decides the delimiter unless `set_delimiter` did.
  [[nodiscard]] Expected<bool> next();
  void set_delimiter(Delimiter delimiter) noexcept { delimiter_ = delimiter; }

  /// All lines from the first on, if they were kept; else no more than those that were not read yet.
  [[nodiscard]] LineReader from_its_beginning() &&;
  /// Lets the lines go that were kept.
  void forget() noexcept { lines_.forget(); }

  /// Cells of the row, without the blanks and the quotes around them; valid until the next call of `next`.
  [[nodiscard]] std::span<const std::string_view> cells() const noexcept { return cells_; }
  [[nodiscard]] std::optional<Delimiter> delimiter() const noexcept { return delimiter_; }
  /// The last comment before the first row that states no recipe, with its `#`; empty if there is none.
  [[nodiscard]] std::string_view comment() const noexcept { return comment_; }
  /// Its cells, `# t,qw,…` or `#HEADER: "t", …`, if they name as many columns as the row has cells; else none. At the
  /// first row only, and where that names no columns itself.
  [[nodiscard]] std::vector<std::string_view> header_in_comment() const;
  [[nodiscard]] const std::string& path() const noexcept { return lines_.path(); }
  [[nodiscard]] std::size_t line() const noexcept { return lines_.line(); }
  [[nodiscard]] std::size_t bytes_read() const noexcept { return lines_.bytes_read(); }

  /// The place of a cell of the row, or of the whole row.
  [[nodiscard]] Where here(std::optional<std::size_t> cell = std::nullopt) const;

 private:
  [[nodiscard]] Expected<bool> split(std::string_view line);
  /// What a quoted cell says; blanks at its ends do not count.
  [[nodiscard]] std::string_view unquoted(std::string_view cell);

  LineReader lines_;
  std::optional<Delimiter> delimiter_;
  std::vector<std::string_view> cells_;
  std::deque<std::string> with_doubled_quotes_;  ///< that cells refer to, which stay where they are
  std::string comment_;
};

}}}  // namespace orispline::io
