// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/curve/motion.hpp>
#include <orispline/io/decimal.hpp>
#include <orispline/io/file_format.hpp>
#include <orispline/io/output_file.hpp>

namespace orispline::io {

/// The frame in which rates are written.
enum class Frame { body, world };

/// What a file of samples holds.
struct SampleColumns {
  FileFormat format = FileFormat::csv;
  bool positions = false;  ///< TUM always has them: zeros if there are none
  int derivatives = 0;     ///< highest order of the rates: 0 none, 1 ω, 2 and α, 3 and jerk; TUM has none
  Frame frame = Frame::body;
};

/// A moving body at one time.
struct Sample {
  double t = 0.0;  ///< since the epoch [s]
  Motion motion{};
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
};

/// Streams samples into a file, or to standard output for `-`.
///
/// Numbers are the shortest that read back as the same double; times are the exact sum of the epoch and the shortest
/// decimal of t. The file appears when `finish` succeeds.
class SampleWriter {
 public:
  /// Errors: bad_access; bad_argument for derivatives that the format cannot hold.
  [[nodiscard]] static Expected<SampleWriter> open(const std::string& path, const SampleColumns& columns,
                                                   const Decimal& epoch);

  /// Errors: bad_access; bad_data for a number that is not finite.
  [[nodiscard]] Expected<void> write(const Sample& sample);
  /// Completes the file; nothing may be written afterwards. Error: bad_access.
  [[nodiscard]] Expected<void> finish() { return file_.finish(); }
  /// The unfinished file beside the target; empty when there is none.
  [[nodiscard]] const std::string& part() const noexcept { return file_.part(); }

 private:
  SampleWriter(OutputFile file, const SampleColumns& columns, const Decimal& epoch)
      : file_(std::move(file)), columns_(columns), epoch_(epoch) {}

  OutputFile file_;
  SampleColumns columns_;
  Decimal epoch_;
  std::string row_;
};

}  // namespace orispline::io
