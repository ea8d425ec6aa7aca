// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include <orispline/batch/sample.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

/// The error (bad_argument) of spans or planes that do not belong together, or are for another number of samples.
template <class T>
[[nodiscard]] std::optional<Error> check_room(const Samples<T>& out, std::size_t wanted);

/// The error (bad_argument) of room for positions that the keys do not have.
template <class T>
[[nodiscard]] std::optional<Error> check_positions(const PoseCurve& curve, const Samples<T>& out);

/// Where the components of sample `at` begin; null for an empty span.
template <class T>
[[nodiscard]] T* place_of(std::span<T> span, Layout layout, std::size_t components, std::size_t at) noexcept {
  return span.empty() ? nullptr : span.data() + (layout == Layout::planar ? at : components * at);
}

/// The distance between the planes of samples, 0 where their components lie side by side.
template <class T>
[[nodiscard]] std::ptrdiff_t plane_distance(const Samples<T>& out) noexcept {
  if (out.layout != Layout::planar) return 0;
  return static_cast<std::ptrdiff_t>(out.plane == 0 ? out.size() : out.plane);
}

/// One sample's components to a span of `out`; an empty span is not wanted.
template <int Components, class T, class Vector>
void put(const Samples<T>& out, std::span<T> to, std::size_t at, const Vector& v) noexcept {
  T* place = place_of(to, out.layout, Components, at);
  if (!place) return;
  const std::ptrdiff_t next = out.layout == Layout::planar ? plane_distance(out) : 1;
  for (int k = 0; k < Components; ++k) place[k * next] = static_cast<T>(v[k]);
}

/// Where the kernels write orientations with their rates, from sample `at` on.
template <class T>
[[nodiscard]] Target<T> target_of(const Samples<T>& out, std::size_t at) noexcept {
  return {.orientation = place_of(out.orientations, out.layout, 4, at),
          .angular_velocity = place_of(out.angular_velocities, out.layout, 3, at),
          .angular_acceleration = place_of(out.angular_accelerations, out.layout, 3, at),
          .angular_jerk = place_of(out.angular_jerks, out.layout, 3, at),
          .planes = plane_distance(out)};
}

/// One sample's angular rates, as far as they are wanted.
template <class T>
void put_rates(const Samples<T>& out, std::size_t at, const Motion& motion) noexcept {
  put<3>(out, out.angular_velocities, at, motion.angular_velocity);
  put<3>(out, out.angular_accelerations, at, motion.angular_acceleration);
  put<3>(out, out.angular_jerks, at, motion.angular_jerk);
}

/// One sample's orientation with its rates, as far as they are wanted.
template <class T>
void put(const Samples<T>& out, std::size_t at, const Motion& motion) noexcept {
  put<4>(out, out.orientations, at, motion.orientation.coeffs());
  put_rates(out, at, motion);
}

/// One sample's position with its rates, as far as they are wanted.
template <class T>
void put(const Samples<T>& out, std::size_t at, const LinearMotion& motion) noexcept {
  put<3>(out, out.positions, at, motion.position);
  put<3>(out, out.velocities, at, motion.velocity);
  put<3>(out, out.accelerations, at, motion.acceleration);
  put<3>(out, out.linear_jerks, at, motion.jerk);
}

/// Samples outside the domain, at rest; or all NaN, for times that are not numbers.
template <class T>
void put_held(const Samples<T>& out, std::size_t at, std::size_t count,
              const Eigen::Quaterniond& orientation) noexcept {
  Motion motion{.orientation = orientation};
  if (orientation.coeffs().hasNaN())
    motion.angular_velocity = motion.angular_acceleration = motion.angular_jerk = orientation.coeffs().head<3>();
  for (std::size_t k = 0; k < count; ++k) put(out, at + k, motion);
}

/// The time of the k-th sample of a run.
[[nodiscard]] inline double time_of(const Clock& clock, std::size_t k) noexcept {
  return clock.times ? clock.times[k] : (clock.first + static_cast<double>(k)) * clock.step + clock.start;
}

}}}  // namespace orispline::batch
