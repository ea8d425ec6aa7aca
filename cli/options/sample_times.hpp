// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <orispline/base/warning.hpp>
#include <orispline/batch/sample_grid.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/io/times_file.hpp>

namespace orispline::cli {

/// Which times the user wants, as typed.
struct TimeOptions {
  std::optional<std::string> rate, count, list, from, to;
  bool include_end = false;
  bool yes = false;  ///< to any number of samples
};

struct TimesFile {
  std::string path;
  io::ReadOptions reading{};  ///< that were stated for INPUT
};

/// Where samples begin or end: in the file's own time, or `+0` since the first key.
struct TimeBound {
  Decimal time;
  bool since_first_key = false;
};

/// The times that samples are wanted at, understood.
struct TimeRequest {
  std::variant<SampleGrid::Rate, SampleGrid::Count, TimesFile> spacing;
  std::optional<TimeBound> from, to;
  SampleGrid::LastSample last = SampleGrid::LastSample::before_end;
  bool any_number = false;  ///< of samples: else 1e9 at most
};

/// The request with both ends in the file's own time, whose first key is at `key_epoch`.
[[nodiscard]] TimeRequest anchored(TimeRequest request, const Decimal& key_epoch);

/// Error (bad_argument): so many samples can hardly be meant.
[[nodiscard]] Expected<void> check_number(const TimeRequest& request, double samples);

/// `outside_curve`: what is asked for by --from and --to begins before or ends after the curve.
[[nodiscard]] std::vector<Warning> range_warnings(const TimeRequest& request, const Decimal& key_epoch,
                                                  const Domain& domain);

/// `clock`: for frames and times of ISO 8601; its frames are the rate where no other times are asked for.
[[nodiscard]] Expected<TimeRequest> time_request(const TimeOptions& options, const io::Clock& clock = {});

// What follows takes an anchored request.

/// The grid that is wanted of keys with that epoch; absent for a file of times.
[[nodiscard]] std::optional<SampleGrid::Request> grid_request(const TimeRequest& request, const Decimal& key_epoch);

/// Errors (bad_argument) of times that end before they start, as far as it is known where the curve does.
[[nodiscard]] Expected<void> check_range(const TimeRequest& request, const Decimal& key_epoch, double curve_start,
                                         std::optional<double> curve_end);

/// The times of the samples, computed one by one or listed.
class SampleTimes {
 public:
  /// Errors: bad_argument for a grid that ends before it starts or never ends; those of a times file.
  ///
  /// `key_epoch`: what the times of the curve are relative to. `domain`: of the curve, what a grid covers by default.
  [[nodiscard]] static Expected<SampleTimes> make(const TimeRequest& request, const Decimal& key_epoch,
                                                  const Domain& domain);
  /// Of a grid that has been made already, for a curve that starts there.
  SampleTimes(const Decimal& key_epoch, const SampleGrid::Request& request, double curve_start, const SampleGrid& grid);

  [[nodiscard]] std::size_t size() const noexcept;
  /// What offsets are relative to, exact.
  [[nodiscard]] const TimeOrigin& origin() const noexcept { return origin_; }
  [[nodiscard]] Instant operator[](std::size_t k) const;

  /// Of reading the times.
  [[nodiscard]] std::vector<Warning> warnings() const;

  /// The error for the first time that a file of skeletons cannot have after the one before it: it holds keys in single
  /// precision from the first key of the curve on.
  [[nodiscard]] std::optional<Error> fault_as_keys() const;

  /// The error for the first time that the curve does not cover.
  [[nodiscard]] std::optional<Error> outside(const Domain& domain) const;

 private:
  struct List {
    std::string path;
    io::TimesList list;
  };

  SampleTimes(const Decimal& key_epoch, List list)
      : key_epoch_(key_epoch), origin_(key_epoch), times_(std::move(list)) {}

  Decimal key_epoch_;
  TimeOrigin origin_;
  std::variant<SampleGrid, List> times_;
};

}  // namespace orispline::cli
