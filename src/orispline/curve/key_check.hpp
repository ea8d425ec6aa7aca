// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include <orispline/base/expected.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/math/eigen.hpp>

// What one key must be, whether it comes with all the others or alone. Errors are bad_data with the key's index;
// success allocates nothing.

namespace orispline { inline namespace ORISPLINE_ABI {

/// sin(half_turn_margin / 2)
inline constexpr double cosine_near_half_turn = 0.008726535498373935;

/// Chooses the signs of keys that come one after the other, and notices what there is to report of them.
struct KeyAlignment {
  KeyframeReport report{};
  bool negated = false;  ///< whether the key before was
  std::size_t keys = 0;

  /// The next unit orientation with its sign; `norm`: what it was divided by. `before`: the one before it, with its
  /// sign; null for the first.
  Eigen::Quaterniond next(Eigen::Quaterniond unit, double norm, Signs signs, const Eigen::Quaterniond* before) {
    const double norm_error = std::abs(norm - 1.0);
    report.largest_norm_error = std::max(report.largest_norm_error, norm_error);
    if (norm_error > unit_norm_tolerance) ++report.non_unit_keys;
    const double cosine = before ? unit.dot(*before) : 1.0;  // of half the angle between them
    const bool against_before = cosine < 0.0;
    if (signs == Signs::shortest && std::abs(cosine) <= cosine_near_half_turn)
      if (report.near_half_turns++ == 0) report.first_near_half_turn = keys - 1;
    ++keys;
    if (before && against_before != negated) ++report.sign_flips;
    negated = signs == Signs::shortest && against_before;
    if (negated) unit.coeffs() = -unit.coeffs();
    return unit;
  }
};

/// A time that is not finite, or that does not come after those of the keys before, at a step in range and comparable
/// with theirs. Of the times before the last ones count, as many as are seen together with this one.
[[nodiscard]] ORISPLINE_EXPORT std::optional<Error> check_time(std::size_t key, double time,
                                                               std::span<const double> before);

/// Whether times are finite and all steps between them in range and comparable: then no time is wrong, which is seen at
/// a glance. Otherwise one may be.
[[nodiscard]] ORISPLINE_EXPORT bool have_comparable_steps(std::span<const double> times) noexcept;

/// Whether the motion jumps to a key: it has the time of the one before it, but not of the two before it.
[[nodiscard]] inline bool is_jump(std::span<const double> times, std::size_t key) noexcept {
  return key > 0 && times[key] == times[key - 1] && (key == 1 || times[key] != times[key - 2]);
}

/// The first time of keys in a row that cannot follow those before it.
[[nodiscard]] ORISPLINE_EXPORT std::optional<Error> check_times(std::span<const double> times);

/// Whether two steps of keys that are seen together [s] are not too uneven.
[[nodiscard]] inline bool are_comparable(double a, double b) noexcept {
  return a <= widest_step_ratio * b && b <= widest_step_ratio * a;
}

/// The times of a stream's newest keys, as many as the next one is checked against.
class RecentTimes {
 public:
  void push(double time) noexcept {
    if (size_ == times_.size()) std::shift_left(times_.begin(), times_.end(), 1);
    else ++size_;
    times_[size_ - 1] = time;
  }
  void clear() noexcept { size_ = 0; }
  [[nodiscard]] std::span<const double> all() const noexcept { return std::span(times_).first(size_); }

 private:
  std::array<double, keys_seen_together - 1> times_{};
  std::size_t size_ = 0;
};

/// The norm of a key's quaternion, which `what` names; an error when it is not finite or farther than
/// `norm_error_limit` from 1.
[[nodiscard]] ORISPLINE_EXPORT Expected<double> checked_norm(std::size_t key, const Eigen::Quaterniond& q,
                                                             const char* what = "quaternion");

/// A quaternion of this norm, divided by it, and by what is left as long as that brings the norm nearer to 1. What
/// comes out stays as it is when it comes in again: keys that were written and read are the same bit for bit.
[[nodiscard]] ORISPLINE_EXPORT Eigen::Quaterniond normalised(Eigen::Quaterniond q, double norm) noexcept;

/// Whether every component of a vector is finite and no larger than `largest_component`.
[[nodiscard]] inline bool is_in_range(const Eigen::Vector3d& v) noexcept {
  return (v.array().abs() <= largest_component).all();
}

/// A vector that is not finite or too large; `what` names it, such as "position".
[[nodiscard]] ORISPLINE_EXPORT std::optional<Error> check_vector(std::size_t key, const char* what,
                                                                 const Eigen::Vector3d& v);

/// A rate that is not finite or too large, which may be free; one of which only some components are NaN is an error.
[[nodiscard]] ORISPLINE_EXPORT std::optional<Error> check_rate(std::size_t key, const char* what,
                                                               const Eigen::Vector3d& rate);

/// An inner quaternion of another norm than a key's, which may be free; one of which only some components are NaN is an
/// error.
[[nodiscard]] ORISPLINE_EXPORT std::optional<Error> check_inner(std::size_t key, const char* what,
                                                                const Eigen::Quaterniond& inner);

}}  // namespace orispline
