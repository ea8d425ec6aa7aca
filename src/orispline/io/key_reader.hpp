// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <memory>
#include <string>

#include <orispline/io/key_file.hpp>
#include <orispline/io/key_input.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

struct KeyColumns;
struct KeyRowsSource;

/// Reads the keys of a file of one track in pieces where they are rows of a table.
class ORISPLINE_EXPORT KeyReader {
 public:
  /// Reads as far as the first row, which decides how the others are read; keys of another kind all at once. Errors:
  /// those of read_keys().
  [[nodiscard]] static Expected<KeyReader> open(Input input, const ReadOptions& options = {});
  /// Reads in the same way from a file that was opened before.
  [[nodiscard]] static Expected<KeyReader> open(KeyInput input, const ReadOptions& options);
  KeyReader(KeyRowsSource source, const ReadOptions& options);
  KeyReader(KeyReader&& other) noexcept;
  KeyReader& operator=(KeyReader&& other) noexcept;
  ~KeyReader();

  /// Of the curve that the keys are for.
  [[nodiscard]] const Recipe& recipe() const noexcept { return recipe_; }

  [[nodiscard]] const FormatInfo& format() const noexcept { return *format_; }
  /// Which column holds what; null where the keys are no rows.
  [[nodiscard]] const KeyColumns* columns() const noexcept;

  /// Whether orientations and positions are of different rows, so that the keys come all at once; to be asked before
  /// any is taken. Reads as far as the first row that has both. Errors: those of read_keys().
  [[nodiscard]] Expected<bool> holds_two_tracks();

  /// The next keys, `most` of them, fewer at the end only; the epoch is that of the file, the repairs are those so far.
  /// Rows that are to be sorted or chosen from, and keys that are no rows, come all at once. Errors: those of
  /// read_keys().
  [[nodiscard]] Expected<KeyFile> next(std::size_t most = std::numeric_limits<std::size_t>::max());
  [[nodiscard]] bool is_at_end() const noexcept { return is_at_end_; }
  /// Of the file, so far.
  [[nodiscard]] std::size_t bytes_read() const noexcept;

 private:
  struct Source;

  explicit KeyReader(KeyFile file);

  std::unique_ptr<Source> source_;
  Recipe recipe_;
  const FormatInfo* format_;
  bool is_at_end_ = false;
};

}}}  // namespace orispline::io
