// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <orispline/base/decimal.hpp>
#include <orispline/io/output_file.hpp>
#include <orispline/io/sample_columns.hpp>
#include <orispline/io/sample_rows.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

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

  /// Writes the sample at a time [s]. Errors: bad_access; those of `SampleRows::append`.
  [[nodiscard]] Expected<void> write(const Decimal& time, const Sample& sample);
  /// Writes rows of the same columns. Errors: bad_access; those of `SampleRows::may_follow`.
  [[nodiscard]] Expected<void> write(const SampleRows& rows);
  /// Closes the file, which stays beside the target until finish(): so several files appear all or none. Nothing may be
  /// written afterwards. Error: bad_access.
  [[nodiscard]] Expected<void> close();
  /// Completes the file, closed or not; nothing may be written afterwards. Error: bad_access.
  [[nodiscard]] Expected<void> finish();
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
