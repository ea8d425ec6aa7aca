// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
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
  [[nodiscard]] bool has_sample(std::size_t k) const noexcept { return !std::isnan(orientations_[4 * k]); }

 private:
  io::SampleColumns columns_;
  std::vector<double> times_, offsets_, orientations_, angular_velocities_, angular_accelerations_, angular_jerks_,
      positions_, velocities_, accelerations_, bands_;
};

/// Samples that there is no row for.
enum class LeftOut { no, yes };
/// What stands for samples in gaps of the keys.
enum class GapRows {
  none,  ///< the keys have no gaps
  left_out,
  empty
};

struct RowPolicy {
  io::MissingSamples missing = io::MissingSamples::refused;
  LeftOut outside = LeftOut::no;
  GapRows gaps = GapRows::none;
};

/// Samples of which something else than a plain row was made.
struct RowCounts {
  std::size_t outside = 0;  ///< the curve
  std::size_t in_gaps = 0;

  RowCounts& operator+=(const RowCounts& more) noexcept {
    outside += more.outside;
    in_gaps += more.in_gaps;
    return *this;
  }
};

/// Rows of some samples of a buffer, as one thread makes them.
class BufferRows {
 public:
  explicit BufferRows(const io::SampleColumns& columns, const RowPolicy& policy = {})
      : rows_(columns, policy.missing), policy_(policy) {}

  /// Makes those of samples `begin` to before `end`, of which those without an orientation within the domain lie in
  /// gaps.
  void make(const SampleBuffer& samples, std::size_t begin, std::size_t end, const TimeOrigin& origin,
            const Domain& domain);
  /// Writes what was made.
  [[nodiscard]] Expected<RowCounts> write(io::SampleWriter& writer) const;

 private:
  io::SampleRows rows_;
  RowPolicy policy_;
  RowCounts counts_;
  Expected<void> made_;
};

}  // namespace orispline::cli
