// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <orispline/base/warning.hpp>
#include <orispline/batch/sample_grid.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/extrapolation.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// Where samples begin or end: in the keys' own time, or `+0` since the first key.
struct TimeBound {
  Decimal time;
  bool since_first_key = false;
};

/// Times in any order, as a file states them.
struct ListedTimes {
  std::string file{};                  ///< its name
  std::vector<double> times{};         ///< since the epoch of the keys [s]
  std::vector<std::uint32_t> lines{};  ///< 1-based line of each
  std::vector<Warning> warnings{};     ///< of reading
};
/// Reads them, once the epoch of the keys is known.
using ReadTimes = std::function<Expected<ListedTimes>(const Decimal& epoch)>;

/// The times that samples are wanted at.
struct TimeRequest {
  std::variant<SampleGrid::Rate, SampleGrid::Count, ReadTimes> spacing;
  std::optional<TimeBound> from, to;
  SampleGrid::LastSample last = SampleGrid::LastSample::before_end;
  bool any_number = false;  ///< of samples: else 1e9 at most
  std::string cure{};       ///< what lets any number pass, in the words of who asks
};

/// The request with both ends in the keys' own time, whose first key is at `key_epoch`.
[[nodiscard]] TimeRequest anchored(TimeRequest request, const Decimal& key_epoch);

/// Error (bad_argument): so many samples can hardly be meant.
[[nodiscard]] Expected<void> check_number(const TimeRequest& request, double samples);

/// `outside_curve`: what is asked for by `from` and `to` begins before or ends after the curve.
[[nodiscard]] std::vector<Warning> range_warnings(const TimeRequest& request, const Decimal& key_epoch,
                                                  const Domain& domain);

// What follows takes an anchored request.

/// The grid that is wanted of keys with that epoch; absent for times that are listed.
[[nodiscard]] std::optional<SampleGrid::Request> grid_request(const TimeRequest& request, const Decimal& key_epoch);

/// Errors (bad_argument) of times that end before they start, as far as it is known where the curve does.
[[nodiscard]] Expected<void> check_range(const TimeRequest& request, const Decimal& key_epoch, double curve_start,
                                         std::optional<double> curve_end);

/// The times of the samples, computed one by one or listed.
class SampleTimes {
 public:
  /// Errors: bad_argument for a grid that ends before it starts or never ends; those of reading a list.
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
  /// As many of them, from that one on: those of operator[].
  void fill(std::size_t first, std::span<double> times, std::span<double> offsets) const;

  /// Of reading the times.
  [[nodiscard]] std::vector<Warning> warnings() const;

  /// The error for the first time that a file of skeletons cannot have after the one before it: it holds keys in single
  /// precision from the first key of the curve on.
  [[nodiscard]] std::optional<Error> fault_as_keys() const;

  /// The error for the first time that the curve does not cover.
  [[nodiscard]] std::optional<Error> outside(const Domain& domain) const;

 private:
  SampleTimes(const Decimal& key_epoch, ListedTimes list)
      : key_epoch_(key_epoch), origin_(key_epoch), times_(std::move(list)) {}

  Decimal key_epoch_;
  TimeOrigin origin_;
  std::variant<SampleGrid, ListedTimes> times_;
};

/// Times that suit a curve, and what is to be said of them.
struct TimesOnCurve {
  SampleTimes times;
  std::vector<Warning> warnings{};
};

/// The times of a request for a curve of keys with that epoch. Errors: those of SampleTimes::make(), and where samples
/// outside the curve are an error, the first of them.
[[nodiscard]] Expected<TimesOnCurve> times_on_curve(const TimeRequest& request, const Decimal& key_epoch,
                                                    const Domain& domain, Extrapolation extrapolation);

}}}  // namespace orispline::jobs
