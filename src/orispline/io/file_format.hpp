// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {
class Decimal;
struct KeyTable;
struct Track;
}}  // namespace orispline

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

class LineReader;
class OutputFile;
class RowNumbers;
class TextTable;
enum class Delimiter;
struct KeyFile;
struct ReadOptions;
struct Sample;
struct SampleColumns;
struct TableLayout;

/// Columns of numbers by name, one number per key.
using NumberColumns = std::map<std::string, std::vector<double>, std::less<>>;

/// The path that means standard input or standard output.
inline constexpr std::string_view standard_stream = "-";

/// What files of a format have room for beside times, positions and unit quaternions.
struct FormatHolds {
  bool forms = false;             ///< orientations in every form
  bool rates = false;             ///< angular rates, the rates of positions, and inner quaternions
  bool settings = false;          ///< columns of a method's parameters
  bool always_positions = false;  ///< zeros where the keys have none
  bool comments = false;          ///< lines from `#` on, such as one for the recipe of keys
};

/// How surely a text is of a format.
enum class Likeness {
  none,
  possible,  ///< worth naming where it is read as another one in vain
  likely,    ///< its rows look so
  certain,   ///< its header says so
};

/// How keys of a format are read; by `layout` or by `tracks`, or not at all.
struct FormatReading {
  /// Decided by the first row of a text and the comment above it. Null: nothing tells the format.
  Likeness (*likeness)(const TextTable&, const ReadOptions&) = nullptr;
  /// Of a table with a key in each row: what stands where, decided by its first row.
  Expected<TableLayout> (*layout)(const TextTable&, const ReadOptions&) = nullptr;
  std::optional<Delimiter> delimiter{};  ///< of such a table; absent: that of its first row
  /// Of all else: the tracks in it, one at least, read from its beginning.
  Expected<std::vector<KeyFile>> (*tracks)(LineReader, const ReadOptions&) = nullptr;
};

/// Times that are written as whole numbers, no two neighbours alike.
struct WholeTimes {
  int per_second = 0;  ///< as a power of ten
  std::string_view unit{};
};

/// How samples of a format are written, row by row; by `row` or by `rounded_row`, or not at all.
struct FormatWriting {
  /// What stands before the rows. Null: nothing.
  std::string (*header)(const SampleColumns&, std::size_t rows) = nullptr;
  bool counts_rows = false;  ///< there; the header has the same length for every number of rows
  /// What a row states behind its time, in its order.
  RowNumbers (*numbers)(const Sample&, const SampleColumns&) = nullptr;
  /// Appends a row to the bytes of a file: with the exact time in the unit of the file, or with a time [s].
  void (*row)(std::string& bytes, const Decimal& time, std::span<const double> numbers) = nullptr;
  void (*rounded_row)(std::string& bytes, double time, std::span<const double> numbers) = nullptr;
  std::optional<WholeTimes> whole_times{};
  /// The text of a file of keys with the columns of another one, and numbers in the place of some. Null: no tables.
  std::string (*table)(const KeyTable&, const NumberColumns&) = nullptr;
  /// Writes any number of tracks, one at least, as a whole. Null: a file holds one, in rows.
  Expected<void> (*tracks)(OutputFile&, std::span<const Track>, const SampleColumns&) = nullptr;
};

/// A format of files of keys and samples: all that is known of it elsewhere.
struct ORISPLINE_EXPORT FormatInfo {
  std::string_view id;       ///< the word that it is chosen by: `csv`
  std::string_view title;    ///< what people call it: `CSV`
  std::string_view file;     ///< with its article: `a CSV file`
  std::string_view summary;  ///< what it is, in a few words
  /// In small letters, with their dots. The first is that of files which are written.
  std::span<const std::string_view> extensions{};
  FormatHolds holds{};
  FormatReading reading{};
  FormatWriting writing{};

  [[nodiscard]] constexpr bool is_read() const noexcept { return reading.layout || reading.tracks; }
  [[nodiscard]] constexpr bool is_written() const noexcept { return writing.row || writing.rounded_row; }
  /// Whether written times are exact.
  [[nodiscard]] constexpr bool keeps_times() const noexcept { return writing.row && !writing.whole_times; }
  /// Whether a path ends in one of the extensions, in any case of letters.
  [[nodiscard]] bool has_extension_of(std::string_view path) const noexcept;
};

/// All formats, in the order in which they are shown. The first is taken where nothing tells another one.
[[nodiscard]] ORISPLINE_EXPORT std::span<const FormatInfo* const> formats() noexcept;
/// Formats that rooms above this one state, such as those of skeletons, come behind the others, each once. To be called
/// before other threads read or write files. What is added must live as long as the program.
ORISPLINE_EXPORT void add_formats(std::span<const FormatInfo* const> more);
[[nodiscard]] ORISPLINE_EXPORT std::vector<const FormatInfo*> formats_read();
[[nodiscard]] ORISPLINE_EXPORT std::vector<const FormatInfo*> formats_written();

/// The first format with the extension of the path; null if there is none.
[[nodiscard]] ORISPLINE_EXPORT const FormatInfo* format_of_extension(std::string_view path) noexcept;

/// The titles as a message names them: `CSV, TUM or EuRoC`.
[[nodiscard]] ORISPLINE_EXPORT std::string any_of(std::span<const FormatInfo* const> formats);

// THE list of formats. Each is stated by the file of this folder that has its name.

extern const FormatInfo csv_format, tum_format, euroc_format, npy_format;

inline constexpr std::array all_formats{&csv_format, &tum_format, &euroc_format, &npy_format};

}}}  // namespace orispline::io
