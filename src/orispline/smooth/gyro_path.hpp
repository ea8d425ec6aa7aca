// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <orispline/math/eigen.hpp>
#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Which rates of a gyro count: one entry for each of them.
using CountedRates = std::vector<bool>;

/// The rates of a gyro that count, and the orientations to which they lead from an arbitrary one, piece by piece: where
/// several in a row do not count, or are missing, the next piece begins.
class GyroPath {
 public:
  /// With this correction b added [rad/s].
  GyroPath(const GyroRates& gyro, const CountedRates& counts, const Eigen::Vector3d& correction);

  struct Point {
    Eigen::Quaterniond orientation;
    Eigen::Vector3d rate;           ///< [rad/s], b added
    Eigen::Matrix3d by_correction;  ///< the turn in the body frame by which it moves with b [s]
    double turned;                  ///< ∫|ω| dt [rad]
    std::size_t piece;
  };

  /// At a time of the gyro's clock [s]; nothing beside its rates and between two pieces.
  [[nodiscard]] std::optional<Point> at(double t) const;

  /// The rate there [rad/s], b added, by the cubic through the four rates about it.
  [[nodiscard]] std::optional<Eigen::Vector3d> rate_at(double t) const;
  /// The same, but nothing where a rate beside it is missing or does not count.
  [[nodiscard]] std::optional<Eigen::Vector3d> measured_at(double t) const;

  [[nodiscard]] const std::vector<double>& times() const noexcept { return times_; }
  /// Between rates that count [s].
  [[nodiscard]] double interval() const noexcept { return interval_; }

 private:
  [[nodiscard]] std::optional<std::size_t> interval_about(double t) const;
  [[nodiscard]] Eigen::Vector3d rate_in(std::size_t interval, double t) const;

  std::vector<std::size_t> rows_;  // of the gyro
  std::vector<double> times_;
  std::vector<Eigen::Vector3d> rates_;
  std::vector<Point> points_;
  double interval_ = 0.0;
};

}}  // namespace orispline
