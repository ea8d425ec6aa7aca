// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include <orispline/batch/compiled_curve.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/curve/stretched_curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The motions of one segment at a few times together: by the kernel where it can, which is many times as fast as
/// single ones. Refers to the curve.
class SegmentMotions {
 public:
  static constexpr std::size_t most = 40;  ///< times together

  SegmentMotions(const AnyCurve& curve, std::size_t segment) noexcept
      : curve_(curve), segment_(segment), record_(batch::record_of<double>(curve, segment)) {}

  /// Up to `most` times [s] of the segment.
  void evaluate(std::span<const double> times) noexcept {
    const batch::Clock clock{.times = times.data(), .start = 0.0, .step = 0.0, .first = 0.0};
    const batch::Target<double> target{.orientation = orientations_.front().data(),
                                       .angular_velocity = angular_velocities_.front().data(),
                                       .angular_acceleration = angular_accelerations_.front().data(),
                                       .angular_jerk = angular_jerks_.front().data()};
    if (batch::by_kernel(record_, clock, times.size(), target) == batch::Written::all) return;
    for (std::size_t i = 0; i < times.size(); ++i) {
      const Motion m = curve_.motion_on(segment_, times[i]);
      angular_velocities_[i] = m.angular_velocity;
      angular_accelerations_[i] = m.angular_acceleration;
      angular_jerks_[i] = m.angular_jerk;
    }
  }

  // At the i-th of the times that were evaluated last, in the body frame.
  [[nodiscard]] const Eigen::Vector3d& angular_velocity(std::size_t i) const noexcept { return angular_velocities_[i]; }
  [[nodiscard]] const Eigen::Vector3d& angular_acceleration(std::size_t i) const noexcept {
    return angular_accelerations_[i];
  }
  [[nodiscard]] const Eigen::Vector3d& angular_jerk(std::size_t i) const noexcept { return angular_jerks_[i]; }
  /// With its rates, without the orientation.
  [[nodiscard]] Motion rates(std::size_t i) const noexcept {
    return {.angular_velocity = angular_velocities_[i],
            .angular_acceleration = angular_accelerations_[i],
            .angular_jerk = angular_jerks_[i]};
  }

 private:
  static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double));

  const AnyCurve& curve_;
  std::size_t segment_;
  batch::SegmentRecord<double> record_;
  std::array<Eigen::Vector4d, most> orientations_;  // which the kernel writes too
  std::array<Eigen::Vector3d, most> angular_velocities_, angular_accelerations_, angular_jerks_;
};

}}  // namespace orispline
