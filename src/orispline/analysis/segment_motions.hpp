// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include <orispline/batch/compiled_curve.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/curve/stretched_curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What is wanted of motions.
enum class MotionPart { angular_velocities, rates, all };

/// The motions of one segment at a few times together: by the kernel where it can, which is many times as fast as
/// single ones. Refers to the curve.
class SegmentMotions {
 public:
  static constexpr std::size_t most = 48;  ///< times together: planes that long begin where the kernel likes to store

  SegmentMotions(const AnyCurve& curve, std::size_t segment, MotionPart wanted) noexcept
      : curve_(curve), segment_(segment), wanted_(wanted), record_(batch::record_of<double>(curve, segment)) {}

  /// Whether the kernel makes them, with their rates.
  [[nodiscard]] bool are_by_kernel() const noexcept {
    return !std::holds_alternative<std::monostate>(record_) &&
           !std::holds_alternative<batch::SquadRecord<double>>(record_);
  }
  /// Whether the curve has nothing here.
  [[nodiscard]] bool is_gap() const noexcept { return !are_by_kernel() && orispline::is_gap(curve_, segment_); }

  /// Up to `most` times [s] of the segment.
  void evaluate(std::span<const double> times) noexcept {
    if (!are_by_kernel()) return evaluate_singly(times);
    const batch::Clock clock{.times = times.data(), .start = 0.0, .step = 0.0, .first = 0.0};
    batch::Target<double> target{
        .orientation = nullptr, .angular_velocity = angular_velocities_.data(), .planes = most};
    if (wanted_ == MotionPart::all) target.orientation = orientations_.data();
    if (wanted_ != MotionPart::angular_velocities) {
      target.angular_acceleration = angular_accelerations_.data();
      target.angular_jerk = angular_jerks_.data();
    }
    static_cast<void>(batch::by_kernel(record_, clock, times.size(), target));
  }

  // At the i-th of the times that were evaluated last; rates in the body frame.
  [[nodiscard]] Eigen::Quaterniond orientation(std::size_t i) const noexcept {
    return Eigen::Quaterniond(at<4>(i, orientations_));
  }
  [[nodiscard]] Eigen::Vector3d angular_velocity(std::size_t i) const noexcept { return at<3>(i, angular_velocities_); }
  [[nodiscard]] Eigen::Vector3d angular_acceleration(std::size_t i) const noexcept {
    return at<3>(i, angular_accelerations_);
  }
  [[nodiscard]] Eigen::Vector3d angular_jerk(std::size_t i) const noexcept { return at<3>(i, angular_jerks_); }
  [[nodiscard]] Motion motion(std::size_t i) const noexcept {
    Motion motion = rates(i);
    motion.orientation = orientation(i);
    return motion;
  }
  /// With its rates, without the orientation.
  [[nodiscard]] Motion rates(std::size_t i) const noexcept {
    return {.angular_velocity = angular_velocity(i),
            .angular_acceleration = angular_acceleration(i),
            .angular_jerk = angular_jerk(i)};
  }

 private:
  void evaluate_singly(std::span<const double> times) noexcept {
    for (std::size_t i = 0; i < times.size(); ++i) {
      const Motion m = curve_.motion_on(segment_, times[i]);
      put(m.orientation.coeffs(), i, orientations_);
      put(m.angular_velocity, i, angular_velocities_);
      put(m.angular_acceleration, i, angular_accelerations_);
      put(m.angular_jerk, i, angular_jerks_);
    }
  }

  template <std::size_t Components>
  using Planes = std::array<double, Components * most>;  // component after component

  template <class Vector, std::size_t Size>
  static void put(const Vector& v, std::size_t i, std::array<double, Size>& planes) noexcept {
    for (std::size_t k = 0; k < Size / most; ++k) planes[k * most + i] = v[static_cast<Eigen::Index>(k)];
  }
  template <int Components, std::size_t Size>
  [[nodiscard]] static Eigen::Matrix<double, Components, 1> at(std::size_t i,
                                                               const std::array<double, Size>& planes) noexcept {
    Eigen::Matrix<double, Components, 1> v;
    for (std::size_t k = 0; k < Size / most; ++k) v[static_cast<Eigen::Index>(k)] = planes[k * most + i];
    return v;
  }

  const AnyCurve& curve_;
  std::size_t segment_;
  MotionPart wanted_;
  batch::SegmentRecord<double> record_;
  Planes<4> orientations_;
  Planes<3> angular_velocities_, angular_accelerations_, angular_jerks_;
};

}}  // namespace orispline
