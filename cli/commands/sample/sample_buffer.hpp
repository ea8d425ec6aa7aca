// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/base/decimal.hpp>
#include <orispline/batch/sample.hpp>
#include <orispline/io/sample_writer.hpp>

namespace orispline::cli {

/// Successive samples on their way to a file.
class SampleBuffer {
 public:
  explicit SampleBuffer(const io::SampleColumns& columns) : columns_(columns) {}

  /// Makes room for so many samples.
  void resize(std::size_t size);
  [[nodiscard]] std::size_t size() const noexcept { return times_.size(); }
  /// Where what the columns want goes.
  [[nodiscard]] Samples<double> room() noexcept;
  [[nodiscard]] std::span<double> times() noexcept { return times_; }      ///< on the curve [s]
  [[nodiscard]] std::span<double> offsets() noexcept { return offsets_; }  ///< as written, from the origin [s]
  [[nodiscard]] std::span<double> bands() noexcept { return bands_; }      ///< [rad]

  [[nodiscard]] double time(std::size_t k) const noexcept { return times_[k]; }
  [[nodiscard]] double offset(std::size_t k) const noexcept { return offsets_[k]; }
  [[nodiscard]] io::Sample sample(std::size_t k) const;

 private:
  io::SampleColumns columns_;
  std::vector<double> times_, offsets_, orientations_, angular_velocities_, angular_accelerations_, angular_jerks_,
      positions_, velocities_, accelerations_, bands_;
};

/// Rows of some samples of a buffer, as one thread makes them.
class BufferRows {
 public:
  explicit BufferRows(const io::SampleColumns& columns, io::MissingSamples missing = io::MissingSamples::refused)
      : rows_(columns, missing) {}

  /// Makes those of samples `begin` to before `end`.
  void make(const SampleBuffer& samples, std::size_t begin, std::size_t end, const TimeOrigin& origin,
            const Domain& domain);
  /// Writes what was made; the number of samples outside the curve.
  [[nodiscard]] Expected<std::size_t> write(io::SampleWriter& writer) const;

 private:
  io::SampleRows rows_;
  std::size_t held_ = 0;
  Expected<void> made_;
};

}  // namespace orispline::cli
