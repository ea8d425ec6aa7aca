// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How far something has gone, and how fast it goes.
struct Advance {
  double length, speed;
};

/// From rest to rest, or from speed to speed without an ease: v rises as v (3u² - 2u³) over the ease, stays, and falls
/// in the same way, so that the acceleration does not jump. Where the length is too short for it, v is less and the
/// eases meet.
class EvenLaw {
 public:
  /// In the units of the lengths, `speed` and `length` above 0; `ease` [s], 0 for none.
  EvenLaw(double length, double speed, double ease) noexcept
      : length_(length), speed_(speed * ease <= length ? speed : length / ease), ease_(ease), asked_(speed) {}

  [[nodiscard]] double duration() const noexcept { return length_ / speed_ + ease_; }
  /// Whether it gets as fast as it shall.
  [[nodiscard]] bool is_reached() const noexcept { return speed_ >= asked_; }

  /// `t` [s], from 0 to duration().
  [[nodiscard]] Advance at(double t) const noexcept {
    const double left = duration() - t;
    if (t < ease_) return eased(t);
    if (left < ease_) return {length_ - eased(left).length, eased(left).speed};
    return {speed_ * (t - 0.5 * ease_), speed_};
  }

  /// The time [s] at which it has gone that far, from 0 to its length; by bisection while it is eased.
  [[nodiscard]] double time_of(double length) const noexcept {
    const double eased_length = 0.5 * speed_ * ease_;
    if (length > length_ - eased_length) return duration() - eased_time_of(length_ - length);
    return length < eased_length ? eased_time_of(length) : length / speed_ + 0.5 * ease_;
  }

 private:
  [[nodiscard]] Advance eased(double t) const noexcept {
    const double u = std::max(t, 0.0) / ease_;
    return {speed_ * ease_ * u * u * u * (1.0 - 0.5 * u), speed_ * u * u * (3.0 - 2.0 * u)};
  }
  [[nodiscard]] double eased_time_of(double length) const noexcept {
    double low = 0.0, high = ease_;
    while (true) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) return middle;
      (eased(middle).length < length ? low : high) = middle;
    }
  }

  double length_, speed_, ease_, asked_;
};

}}  // namespace orispline
