// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <variant>

#include <orispline/base/decimal.hpp>
#include <orispline/batch/kernel/record.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// One time of a grid.
struct Instant {
  double t;       ///< on the curve: since the epoch of its keys [s]
  double offset;  ///< since the start of the grid [s]
};

/// So many samples in a time, of 1 s by default: 30000 in 1001 s are 29.97 a second, without rounding.
struct SampleRate {
  double hertz = 0.0;
  double seconds = 1.0;

  [[nodiscard]] double per_second() const noexcept { return hertz / seconds; }
};

/// The even times of samples, computed one by one: a grid takes no memory.
///
/// The grid of a rate or a count begins at an exact decimal: sample k is at the double nearest to the sum of that and
/// its offset, the last one at the double nearest to the end where the grid meets it. A grid of steps has the times
/// k * step / parts + start, computed as written, and no end.
class ORISPLINE_EXPORT SampleGrid {
 public:
  struct Step {
    double seconds;
    double parts = 1.0;  ///< samples in it: thirtieths of a second are no doubles, but k / 30 is rounded once
  };
  /// From the start on as long as the end is not passed; a sample within 1e-9 of an interval of it is the end.
  using Rate = SampleRate;
  /// So many from the start to the end, both included.
  struct Count {
    std::size_t samples;
  };
  /// Where the end is none of the times of a rate: whether it is a sample all the same.
  enum class LastSample { before_end, at_end };
  /// Which grid is wanted of a curve: where start or end are absent they are the curve's own. [s], of the keys' epoch.
  struct Request {
    std::variant<Rate, Count> spacing;
    std::optional<Decimal> start{}, end{};
    LastSample last = LastSample::before_end;
  };
  /// More samples than that cannot be told apart by a double.
  static constexpr double most_samples = 9e15;

  /// A grid of steps, which are greater than 0.
  SampleGrid(double start, Step step);
  /// The grid of a curve whose end may not be known yet: then it is open, unless the request has an end.
  ///
  /// Errors (bad_argument, of `rate` or `count`): too many samples; several of a range that is a single time. A grid
  /// that ends before it starts has no samples.
  [[nodiscard]] static Expected<SampleGrid> make(const Request& request, double curve_start,
                                                 std::optional<double> curve_end);

  /// Whether it is that of a rate or a count.
  [[nodiscard]] bool is_range() const noexcept { return !std::holds_alternative<Step>(spacing_); }
  /// Absent while the grid is open.
  [[nodiscard]] std::optional<std::uint64_t> size() const noexcept;
  [[nodiscard]] Instant operator[](std::uint64_t k) const;
  /// The times of as many samples, from that one on: those of operator[].
  void fill(std::uint64_t first, std::span<double> times) const;
  /// Of sample k since the start [s].
  [[nodiscard]] double offset(std::uint64_t k) const noexcept;
  /// Of sample k [s]; infinite behind the last.
  [[nodiscard]] double time(std::uint64_t k) const;
  /// The first sample at that time or later, size() or most_samples if there is none.
  [[nodiscard]] std::uint64_t first_from(double t) const;
  /// The first sample later than that time.
  [[nodiscard]] std::uint64_t first_after(double t) const;
  /// So many of the first samples stay what they are, wherever from that time on an open grid will end.
  [[nodiscard]] std::uint64_t settled_until(double t) const noexcept;

 private:
  struct End {
    double time, span;  // of the keys' epoch; since the start
    std::uint64_t samples;
    std::optional<std::uint64_t> index{};  // of the sample that stands there, if one does
  };
  using Spacing = std::variant<Step, Rate, Count>;
  /// A start and a rate whose times are decimals of few digits: sample k is at (start + k step) / 10^places [s].
  struct Decimals {
    double start, step, power_of_ten;  // whole numbers
    double seconds;                    // of the rate, which is a quotient of whole numbers
  };

  SampleGrid(Spacing spacing, const Decimal& start, double seconds)
      : spacing_(spacing), start_(start), start_seconds_(seconds), decimals_(decimals_of(spacing, start)) {}
  [[nodiscard]] static std::optional<Decimals> decimals_of(const Spacing& spacing, const Decimal& start);
  [[nodiscard]] static Expected<End> end_of(const Request& request, const Decimal& start, const Decimal& end);
  [[nodiscard]] std::uint64_t guess(double t, std::uint64_t limit) const noexcept;
  template <class Reached>
  [[nodiscard]] std::uint64_t first_that(double t, Reached reached) const;
  [[nodiscard]] std::optional<batch::EvenTimes> even_until(std::uint64_t last) const;
  [[nodiscard]] std::optional<batch::DecimalTimes> decimal_times() const;
  void fill_by_decades(const batch::DecimalTimes& wanted, std::uint64_t first, std::span<double> times) const;

  Spacing spacing_;
  TimeOrigin start_;      // of the keys' epoch
  double start_seconds_;  // the same to a double
  std::optional<End> end_{};
  std::optional<Decimals> decimals_;
};

/// Samples `first` … `end - 1` of a grid.
struct SampleRange {
  std::uint64_t first = 0, end = 0;
  [[nodiscard]] std::uint64_t size() const noexcept { return end > first ? end - first : 0; }
};

}}  // namespace orispline
