// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <orispline/batch/sample.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/jobs/band.hpp>
#include <orispline/jobs/sample_times.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// What rows have beside a time and an orientation.
struct RowColumns {
  int derivatives = 0;           ///< highest order of the angular rates: 0 none, 1 ω, 2 and α, 3 and jerk
  bool positions = false;        ///< in the world frame
  int position_derivatives = 0;  ///< highest order of their rates: 0 none, 1 velocity, 2 and acceleration
  bool band = false;             ///< a radius of where the true motion may be
};

/// Successive samples with their times.
class SampleBlock {
 public:
  explicit SampleBlock(const RowColumns& columns) : columns_(columns) {}

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
  /// Whether there is a sample, as there is none in a gap.
  [[nodiscard]] bool has_sample(std::size_t k) const noexcept { return !std::isnan(orientations_[4 * k]); }
  // What there is no column for is zero.
  [[nodiscard]] Motion motion(std::size_t k) const;
  [[nodiscard]] LinearMotion linear_motion(std::size_t k) const;
  [[nodiscard]] double band(std::size_t k) const noexcept { return bands_.empty() ? 0.0 : bands_[k]; }

 private:
  RowColumns columns_;
  std::vector<double> times_, offsets_, orientations_, angular_velocities_, angular_accelerations_, angular_jerks_,
      positions_, velocities_, accelerations_, bands_;
};

/// What is sampled: a curve, the motion of a joint, or keys that come in pieces. It gives its samples one after the
/// other, in memory that does not grow with their number.
class SampleSource {
 public:
  SampleSource() = default;
  SampleSource(const SampleSource&) = delete;
  SampleSource& operator=(const SampleSource&) = delete;
  virtual ~SampleSource() = default;

  /// Makes the next samples, `most` at most, the same on any number of threads; none behind the last one.
  [[nodiscard]] virtual Expected<void> next(SampleBlock& block, std::size_t most, Work work) = 0;
  /// How many there are in all, once that is known; this and what follows may be asked when samples have been made.
  [[nodiscard]] virtual std::optional<std::uint64_t> size() const = 0;
  /// What offsets are relative to.
  [[nodiscard]] virtual const TimeOrigin& origin() const = 0;
  /// Of the curve, as far as it is known.
  [[nodiscard]] virtual Domain domain() const = 0;
};

/// How a curve in memory is sampled.
struct CurveSampling {
  Extrapolation extrapolation = Extrapolation::hold;
  const Band* band = nullptr;  ///< where the columns have one
};

/// Samples of a curve, such as the motion of a joint. It refers to the curve and the times.
class CurveSamples final : public SampleSource {
 public:
  CurveSamples(const PoseCurve& curve, const SampleTimes& times, const CurveSampling& sampling = {})
      : curve_(curve), times_(times), sampling_(sampling) {}

  [[nodiscard]] Expected<void> next(SampleBlock& block, std::size_t most, Work work) override;
  [[nodiscard]] std::optional<std::uint64_t> size() const override { return times_.size(); }
  [[nodiscard]] const TimeOrigin& origin() const override { return times_.origin(); }
  [[nodiscard]] Domain domain() const override { return curve_.orientation.domain(); }

 private:
  const PoseCurve& curve_;
  const SampleTimes& times_;
  CurveSampling sampling_;
  std::size_t next_ = 0;
};

/// What becomes of samples outside the curve: rows like all others, or none.
enum class OutsideRows { made, left_out };
/// What stands for samples in gaps of the keys.
enum class GapRows {
  none,  ///< the keys have no gaps
  left_out,
  empty
};

struct RowPolicy {
  OutsideRows outside = OutsideRows::made;
  GapRows gaps = GapRows::none;
  std::size_t threads = 1;
  bool in_turn = false;  ///< a row depends on the one before it, as of angles that run on
};

/// Samples that were taken, and those of them of which something else than a plain row was made.
struct RowCounts {
  std::size_t samples = 0;
  std::size_t outside = 0;  ///< the curve
  std::size_t in_gaps = 0;
  std::size_t without_band = 0;  ///< rows of which the keys do not tell where the true motion may be

  /// That were made of them.
  [[nodiscard]] std::size_t rows(const RowPolicy& policy) const noexcept {
    return samples - (policy.outside == OutsideRows::left_out ? outside : 0) -
           (policy.gaps == GapRows::left_out ? in_gaps : 0);
  }
};

/// Where rows go. They are made in buffers on several threads, each of which has its own.
class RowSink {
 public:
  RowSink() = default;
  RowSink(const RowSink&) = delete;
  RowSink& operator=(const RowSink&) = delete;
  virtual ~RowSink() = default;

  /// So many buffers, all of them empty.
  virtual void clear(std::size_t buffers) = 0;
  /// Makes the row of a sample behind those in a buffer, or one that has a time alone.
  [[nodiscard]] virtual Expected<void> add(std::size_t buffer, const TimeOrigin& origin, const SampleBlock& samples,
                                           std::size_t k) = 0;
  virtual void add_empty(std::size_t buffer, const TimeOrigin& origin, double offset) = 0;
  /// Takes the rows of a buffer, the buffers in their order.
  [[nodiscard]] virtual Expected<void> write(std::size_t buffer, const SampleSource& source) = 0;
  /// Called when the rows of so many samples have been written.
  virtual void written(std::size_t samples) = 0;
};

/// Takes all samples and makes their rows. Rows before a bad one are written. Errors: those of the source and the sink.
[[nodiscard]] Expected<RowCounts> sample_rows(SampleSource& source, const RowColumns& columns, const RowPolicy& policy,
                                              RowSink& sink);

}}}  // namespace orispline::jobs
