// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <orispline/base/decimal.hpp>
#include <orispline/io/output_file.hpp>
#include <orispline/io/sample_columns.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

inline constexpr std::size_t written_block = std::size_t{256} << 10;  ///< [bytes] of rows, best written at a time

/// What may be NaN in rows.
enum class MissingSamples {
  refused,
  written,    ///< samples at times for which there are none
  free_rates  ///< rates and inner quaternions that keys leave free
};

/// Rows of samples as their file holds them, gathered in memory: several threads may each make some, unless Euler
/// angles run on from row to row.
class ORISPLINE_EXPORT SampleRows {
 public:
  /// The columns are those that `check_columns` accepts.
  explicit SampleRows(const SampleColumns& columns, MissingSamples missing = MissingSamples::refused)
      : columns_(columns), missing_(missing) {}

  /// Appends the sample at a time [s]. Errors (bad_data), after which nothing is appended: a number that is not finite,
  /// unless it is that of a sample or a rate which may be missing; two samples in succession that fall on the same
  /// time, where the format rounds times.
  [[nodiscard]] Expected<void> append(const Decimal& time, const Sample& sample);
  /// Appends a sample at an offset [s] from an origin.
  [[nodiscard]] Expected<void> append(const TimeOrigin& origin, double offset, const Sample& sample);

  /// Appends a row with a time and nothing else, such as one in a gap; NaN where the format has no empty cells.
  void append_empty(const TimeOrigin& origin, double offset);

  /// Whether these rows may follow the others. Error (bad_data): they begin with the time that the others end with,
  /// where the format rounds times.
  [[nodiscard]] Expected<void> may_follow(const SampleRows& others) const;

  [[nodiscard]] std::string_view bytes() const noexcept { return bytes_; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  /// Takes the rows out; what is appended next is still behind them.
  void clear() noexcept;
  /// Takes the place behind the others, as if they had been appended here and taken out.
  void continue_after(const SampleRows& others) noexcept;

 private:
  [[nodiscard]] bool may_write(const RowNumbers& numbers, const Sample& sample) const noexcept;
  [[nodiscard]] Expected<Decimal> next_whole(const Decimal& time);
  [[nodiscard]] RowNumbers numbers_of(const Sample& sample);

  SampleColumns columns_;
  MissingSamples missing_;
  std::string bytes_;
  std::size_t size_ = 0;
  std::optional<Eigen::Vector3d> angles_;            // of the last row [rad], where they run on
  std::optional<Decimal> first_whole_, last_whole_;  // in units of the format, where it has some
};

/// Streams samples into a file, or to standard output for `-`.
///
/// Numbers are the shortest that read back as the same double. Times are exact, or rounded as the format says. The file
/// appears when `finish` succeeds.
class ORISPLINE_EXPORT SampleWriter {
 public:
  /// `rows`: how many samples will be written. Only formats whose header counts them ask (NumPy), and only where the
  /// file is a pipe or a device: it cannot be written again there.
  ///
  /// Errors: bad_access; bad_argument for what the format cannot hold.
  [[nodiscard]] static Expected<SampleWriter> open(const std::string& path, const SampleColumns& columns,
                                                   std::size_t rows = 0);
  /// The same with a file that is open, such as one in memory.
  [[nodiscard]] static Expected<SampleWriter> open(OutputFile file, const SampleColumns& columns, std::size_t rows = 0);

  /// Writes the sample at a time [s]. Errors: bad_access; those of `SampleRows::append`.
  [[nodiscard]] Expected<void> write(const Decimal& time, const Sample& sample);
  /// Writes rows of the same columns. Errors: bad_access; those of `SampleRows::may_follow`.
  [[nodiscard]] Expected<void> write(const SampleRows& rows);
  /// Closes the file, which stays beside the target until finish(): so several files appear all or none. Nothing may be
  /// written afterwards. Error: bad_access.
  [[nodiscard]] Expected<void> close();
  /// Completes the file, closed or not; nothing may be written afterwards. Error: bad_access.
  [[nodiscard]] Expected<void> finish();
  /// What was written, of a file in memory that is finished.
  [[nodiscard]] std::string bytes() && noexcept { return std::move(file_).bytes(); }
  /// The unfinished file beside the target; empty when there is none.
  [[nodiscard]] const std::string& part() const noexcept { return file_.part(); }

 private:
  SampleWriter(OutputFile file, const SampleColumns& columns, std::size_t rows)
      : file_(std::move(file)), columns_(columns), stated_rows_(rows), pending_(columns) {}
  [[nodiscard]] Expected<void> write_pending();

  OutputFile file_;
  SampleColumns columns_;
  std::size_t stated_rows_, rows_ = 0;
  bool closed_ = false;
  SampleRows pending_;  // not written yet
};

}}}  // namespace orispline::io
