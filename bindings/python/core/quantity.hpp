// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/batch/pose_sampler.hpp>

#include "python_curve.hpp"

namespace orispline::python {

/// What is asked of a curve at a time, in the order that Python numbers it.
enum class What { orientation, angular_velocity, angular_acceleration, angular_jerk, position, velocity, acceleration };

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
  RateFrame frame_;
  Extrapolation beyond_;
  Work work_;
  std::vector<T> orientations_, angular_velocities_, angular_accelerations_;
};

}  // namespace orispline::python
