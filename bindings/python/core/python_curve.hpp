// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include <nanobind/nanobind.h>

#include <orispline/analysis.hpp>
#include <orispline/batch/pose_sampler.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/curve/path.hpp>

#include "keys.hpp"
#include "method_text.hpp"

namespace orispline::python {

/// A curve as Python holds it, with its keys and its method.
class PythonCurve {
 public:
  /// Raises the errors of a method that there is not, and of make_pose_curve().
  PythonCurve(Keys keys, const MethodText& stated);
  /// A curve made of curves, on the clock of these keys; it has no method.
  PythonCurve(Keys keys, PoseSampler sampler) : keys_(std::move(keys)), sampler_(std::move(sampler)) {}

  [[nodiscard]] const Keys& keys() const noexcept { return keys_; }
  [[nodiscard]] const Method& method() const noexcept { return method_; }
  [[nodiscard]] const PoseSampler& sampler() const noexcept { return *sampler_; }
  [[nodiscard]] const PoseCurve& pose() const noexcept { return sampler_->curve(); }
  [[nodiscard]] Domain domain() const noexcept { return pose().orientation.domain(); }

  /// The arc length, made when it is first asked for. Not to be asked with the GIL.
  [[nodiscard]] const AngleTravelled& travelled() const;

 private:
  Keys keys_;
  Method method_{};
  Expected<PoseSampler> sampler_;
  mutable std::once_flag travelled_once_;
  mutable std::optional<AngleTravelled> travelled_;
};

/// The even times of a rate or a count.
void add_grids(nanobind::module_& module, nanobind::class_<PythonCurve>& curve_class);
/// Its samples, at those or at any times.
void add_fills(nanobind::class_<PythonCurve>& curve_class);
/// Curves made of curves.
void add_compositions(nanobind::module_& module, nanobind::class_<PythonCurve>& curve_class);
/// What it is worth: energies, peaks, distances.
void add_analysis(nanobind::module_& module, nanobind::class_<PythonCurve>& curve_class);
/// Curves turned into polynomials.
void add_baked(nanobind::module_& module, nanobind::class_<PythonCurve>& curve_class);
/// Drawings, pages, and what is drawn elsewhere.
void add_pictures(nanobind::module_& module, nanobind::class_<PythonCurve>& curve_class);

}  // namespace orispline::python
