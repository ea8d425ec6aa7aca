// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <orispline/curve/motion.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/io/decimal.hpp>
#include <orispline/io/file_format.hpp>
#include <orispline/io/frame.hpp>
#include <orispline/io/orientation_form.hpp>
#include <orispline/io/output_file.hpp>

namespace orispline::io {

/// What a file of samples holds.
struct SampleColumns {
  FileFormat format = FileFormat::csv;
  OrientationForm form{};        ///< of CSV; TUM and EuRoC have quaternions
  bool positions = false;        ///< TUM and EuRoC always have them: zeros if there are none
  int derivatives = 0;           ///< highest order of the angular rates: 0 none, 1 ω, 2 and α, 3 and jerk; CSV only
  int position_derivatives = 0;  ///< highest order of the rates of position: 0 none, 1 velocity, 2 and acceleration
  Frame frame = Frame::body;
};

/// A moving body.
struct Sample {
  Motion motion{};
  Travel travel{};
};

/// Streams samples into a file, or to standard output for `-`.
///
/// Numbers are the shortest that read back as the same double. Times are exact, but for EuRoC, whose times are rounded
/// to whole nanoseconds. The file appears when `finish` succeeds.
///
/// Columns of CSV: time, orientation, position, angular rates, rates of position.
class SampleWriter {
 public:
  /// Errors: bad_access; bad_argument for what the format cannot hold.
  [[nodiscard]] static Expected<SampleWriter> open(const std::string& path, const SampleColumns& columns);

  /// Writes the sample at a time [s]. Errors: bad_access; bad_data for a number that is not finite, and for two EuRoC
  /// samples in succession that fall on the same nanosecond.
  [[nodiscard]] Expected<void> write(const Decimal& time, const Sample& sample);
  /// Completes the file; nothing may be written afterwards. Error: bad_access.
  [[nodiscard]] Expected<void> finish() { return file_.finish(); }
  /// The unfinished file beside the target; empty when there is none.
  [[nodiscard]] const std::string& part() const noexcept { return file_.part(); }

 private:
  SampleWriter(OutputFile file, const SampleColumns& columns) : file_(std::move(file)), columns_(columns) {}
  [[nodiscard]] Expected<Decimal> next_nanosecond(const Decimal& time);

  OutputFile file_;
  SampleColumns columns_;
  std::optional<Decimal> last_nanosecond_;
  std::string row_;
};

}  // namespace orispline::io
