// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <optional>
#include <string>

#include <nanobind/nanobind.h>

#include <orispline/batch/compiled_curve.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/curve/pose_curve.hpp>

#include "keys.hpp"

namespace orispline::python {

/// A curve as Python holds it, with its keys and its method.
class PythonCurve {
 public:
  /// Of a method in its text form. Raises the errors of make_pose_curve().
  PythonCurve(Keys keys, const std::string& method_text);

  [[nodiscard]] const Keys& keys() const noexcept { return keys_; }
  [[nodiscard]] const Method& method() const noexcept { return method_; }
  [[nodiscard]] const PoseCurve& pose() const noexcept { return *pose_; }
  [[nodiscard]] Domain domain() const noexcept { return pose_->orientation.domain(); }

  /// For times in no order: made when it is first asked for.
  [[nodiscard]] const CompiledCurve<double>& compiled() const;

 private:
  Keys keys_;
  Method method_;
  Expected<PoseCurve> pose_;
  mutable std::once_flag once_;
  mutable std::optional<CompiledCurve<double>> compiled_;
};

/// The even times of a rate or a count.
void add_grids(nanobind::class_<PythonCurve>& curve_class);

}  // namespace orispline::python
