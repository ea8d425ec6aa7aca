// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/batch/sample.hpp>

#include "python_curve.hpp"

namespace orispline::python {

/// What is asked of a curve at a time, in the order that the face numbers it.
enum class What { orientation, angular_velocity, angular_acceleration, angular_jerk, position, velocity, acceleration };

/// Samples that are made together: so many as are still in the cache of a thread when they are looked at again, or as
/// keep all threads busy. 0 threads: one per core.
[[nodiscard]] std::size_t samples_at_a_time(unsigned threads);

/// Samples at times in any order; outside the curve as asked for.
template <class T>
[[nodiscard]] Expected<void> sample_into(const PythonCurve& curve, std::span<const double> times, const Samples<T>& out,
                                         Extrapolation beyond, unsigned threads);

/// Turns rates of the body into those of the world, as math/frames has it.
template <class T>
void turn_to_world(const Samples<T>& samples, std::size_t count);

/// One quantity of a curve, with what must be made beside it.
template <class T>
class Quantity {
 public:
  /// Raises the error of positions that the keys do not have.
  Quantity(const PythonCurve& curve, int asked, bool world, int beyond, unsigned threads);

  /// Numbers of a sample.
  [[nodiscard]] std::size_t width() const noexcept { return what_ == What::orientation ? 4 : 3; }

  /// At times in any order, to `memory`: the bits are the same whatever other times there are.
  [[nodiscard]] Expected<void> at(std::span<const double> times, T* memory);

 private:
  [[nodiscard]] Expected<void> part(std::span<const double> times, T* memory);

  const PythonCurve& curve_;
  What what_;
  bool turns_;
  Extrapolation beyond_;
  unsigned threads_;
  std::vector<T> orientations_, angular_velocities_, angular_accelerations_;
};

}  // namespace orispline::python
