// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>

#include <orispline/batch/sample_grid.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/io/times_file.hpp>

namespace orispline::cli {

/// Which times the user wants, as typed.
struct TimeOptions {
  std::optional<std::string> rate, count, list, from, to;
};

struct TimesFile {
  std::string path;
};

/// The same, understood. `from` and `to` are in the file's own time.
struct TimeRequest {
  std::variant<SampleGrid::Rate, SampleGrid::Count, TimesFile> spacing;
  std::optional<Decimal> from, to;
};

[[nodiscard]] Expected<TimeRequest> time_request(const TimeOptions& options);

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
