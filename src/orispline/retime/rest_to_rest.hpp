// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The fastest motion along a way, from rest to rest, within limits of speed, acceleration and jerk: the jerk is at its
/// limit, or the acceleration is, or the speed. Shares of the way are from 0 to 1.
class RestToRest {
 public:
  /// The way divided by each limit [s], [s²], [s³]; 0 where there is no limit. One of them at least is above 0.
  explicit RestToRest(const std::array<double, 3>& way) noexcept
      : acceleration_(way[1]),
        jerk_(way[2]),
        speed_(std::min(1.0 / way[0], speed_between_ramps())),
        ramp_(ramp_to(speed_)) {}

  [[nodiscard]] double duration() const noexcept { return 1.0 / speed_ + ramp_; }

  /// The time [s] at which it has gone that share.
  [[nodiscard]] double time_of(double share) const noexcept {
    if (share > 0.5) return duration() - time_of(1.0 - share);
    if (share > 0.5 * speed_ * ramp_) return share / speed_ + 0.5 * ramp_;
    double low = 0.0, high = ramp_;
    while (true) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) return middle;
      (share_on_ramp(middle) < share ? low : high) = middle;
    }
  }

 private:
  /// Whether the acceleration gets to its limit on the way to a speed.
  [[nodiscard]] bool reaches_acceleration(double speed) const noexcept {
    return acceleration_ > 0.0 && speed * acceleration_ * acceleration_ >= jerk_;
  }
  /// How long it takes to get that fast [s].
  [[nodiscard]] double ramp_to(double speed) const noexcept {
    if (reaches_acceleration(speed)) return speed * acceleration_ + jerk_ / acceleration_;
    return 2.0 * std::sqrt(speed * jerk_);
  }
  /// What it gets to without a limit of the speed, where the second ramp follows on the first; infinite without ramps.
  [[nodiscard]] double speed_between_ramps() const noexcept {
    using elementary::exponential, elementary::natural_logarithm;
    const double by_jerk =
        jerk_ > 0.0 ? exponential(natural_logarithm(0.25 / jerk_) / 3.0) : std::numeric_limits<double>::infinity();
    if (!reaches_acceleration(by_jerk)) return by_jerk;
    const double b = jerk_ / acceleration_;
    return (std::sqrt(b * b + 4.0 * acceleration_) - b) / (2.0 * acceleration_);
  }
  [[nodiscard]] double share_on_ramp(double t) const noexcept {
    if (t > 0.5 * ramp_) return speed_ * (t - 0.5 * ramp_) + share_on_ramp(ramp_ - t);
    const double rise = reaches_acceleration(speed_) ? jerk_ / acceleration_ : 0.5 * ramp_;  // of the acceleration [s]
    const double risen = std::min(t, rise), rest = t - risen;
    const double share = jerk_ > 0.0 ? risen * risen * risen / (6.0 * jerk_) : 0.0;
    if (!(rest > 0.0)) return share;
    return share + rest * (rise > 0.0 ? 0.5 * rise * rise / jerk_ : 0.0) + 0.5 * rest * rest / acceleration_;
  }

  double acceleration_, jerk_;  ///< the way divided by their limits
  double speed_;                ///< the largest, in shares of the way per second
  double ramp_;                 ///< [s]
};

}}  // namespace orispline
