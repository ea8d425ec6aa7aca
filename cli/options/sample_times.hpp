// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <orispline/curve/curve.hpp>
#include <orispline/io/time_origin.hpp>
#include <orispline/io/times_file.hpp>

namespace orispline::cli {

/// Which times the user wants, as typed.
struct TimeOptions {
  std::optional<std::string> rate, count, list, from, to;
};

struct Rate {
  double hertz = 0.0;
};
struct Count {
  std::size_t samples = 0;
};
struct TimesFile {
  std::string path;
};

/// The same, understood. `from` and `to` are in the file's own time.
struct TimeRequest {
  std::variant<Rate, Count, TimesFile> spacing;
  std::optional<Decimal> from, to;
};

[[nodiscard]] Expected<TimeRequest> time_request(const TimeOptions& options);

/// One time of a row of samples.
struct Instant {
  double t;       ///< on the curve: since the epoch of the keys [s]
  double offset;  ///< as written: since the epoch of the samples [s]
};

/// The times of the samples, computed one by one: a grid takes no memory.
class SampleTimes {
 public:
  /// Errors: bad_argument for a grid that ends before it starts or never ends; those of a times file.
  ///
  /// `key_epoch`: what the times of the curve are relative to. `domain`: of the curve, what a grid covers by default.
  [[nodiscard]] static Expected<SampleTimes> make(const TimeRequest& request, const Decimal& key_epoch,
                                                  const Domain& domain);

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  /// What offsets are relative to, exact.
  [[nodiscard]] const io::TimeOrigin& origin() const noexcept { return origin_; }
  [[nodiscard]] Instant operator[](std::size_t k) const;

  /// The error for the first time that the curve does not cover.
  [[nodiscard]] std::optional<Error> outside(const Domain& domain) const;

 private:
  struct Grid {
    std::variant<Rate, Count> spacing;
    io::TimeOrigin start;  // since the epoch of the keys
    double end, span;
    std::optional<std::size_t> index_of_end{};  // of the sample that stands at the end, if one does
    [[nodiscard]] double offset(std::size_t k, std::size_t size) const;
  };
  struct List {
    std::string path;
    io::TimesList list;
  };

  template <class Times>
  SampleTimes(const Decimal& key_epoch, const Decimal& epoch, std::size_t size, Times times)
      : key_epoch_(key_epoch), origin_(epoch), size_(size), times_(std::in_place_type<Times>, std::move(times)) {}
  [[nodiscard]] static Expected<SampleTimes> grid(const TimeRequest& request, const Decimal& key_epoch,
                                                  const Domain& domain);

  Decimal key_epoch_;
  io::TimeOrigin origin_;
  std::size_t size_;
  std::variant<Grid, List> times_;
};

}  // namespace orispline::cli
