// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <orispline/analysis.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/jobs.hpp>
#include <orispline/math/so3.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "python_curve.hpp"
#include "text.hpp"

using namespace nanobind::literals;

namespace orispline::python {

const AngleTravelled& PythonCurve::travelled() const {
  std::call_once(travelled_once_, [this] { travelled_.emplace(pose().orientation); });
  return *travelled_;
}

namespace {

using MutableNumbers = nb::ndarray<double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using MutableRows3 = nb::ndarray<double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using MutableMatrices = nb::ndarray<double, nb::shape<-1, 3, 3>, nb::c_contig, nb::device::cpu>;
using Inertia = nb::ndarray<const double, nb::shape<3, 3>, nb::c_contig, nb::device::cpu>;

Eigen::Matrix3d matrix_of(const std::optional<Inertia>& inertia) {
  if (!inertia) return Eigen::Matrix3d::Identity();
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(inertia->data());
}

/// What is noteworthy of an inertia, as text and code; raises the error of one that is none.
std::vector<std::pair<std::string, std::string>> check_inertia(const Inertia& inertia) {
  std::vector<std::pair<std::string, std::string>> told;
  for (const Warning& warning : warnings_of(value_of(checked_inertia(matrix_of(inertia)))))
    told.emplace_back(describe(warning), warning.code);
  return told;
}

nb::dict energies_of(const PythonCurve& curve, const std::optional<Inertia>& inertia) {
  const Eigen::Matrix3d matrix = matrix_of(inertia);
  const Energies found = [&] {
    const nb::gil_scoped_release release;
    return energies(curve.pose().orientation, matrix);
  }();
  nb::dict result;
  result["acceleration"] = found.acceleration;
  result["jerk"] = found.jerk;
  if (inertia) result["torque"] = found.torque;
  return result;
}

nb::dict peaks_of(const PythonCurve& curve, const std::optional<Inertia>& inertia) {
  const Eigen::Matrix3d matrix = matrix_of(inertia);
  const Peaks found = [&] {
    const nb::gil_scoped_release release;
    return peaks(curve.pose().orientation, matrix);
  }();
  const auto parts = [](const Peak& peak) { return std::tuple(peak.value, peak.time, peak.bound); };
  nb::dict result;
  result["angular_velocity"] = parts(found.angular_velocity);
  result["angular_acceleration"] = parts(found.angular_acceleration);
  if (inertia) result["torque"] = parts(found.torque);
  return result;
}

nb::dict dictionary_of(const DistanceStatistics& found) {
  nb::dict result;
  result["count"] = found.count;
  result["rms"] = found.rms;
  result["mean"] = found.mean;
  result["largest"] = found.largest;
  result["largest_at"] = found.largest_at;
  result["median"] = found.median;
  result["percentile_95"] = found.percentile_95;
  result["percentile_99"] = found.percentile_99;
  return result;
}

nb::dict distance(const PythonCurve& curve, const Keys& reference) {
  const Keyframes& keys = reference.track->keys;
  return dictionary_of([&] {
    const nb::gil_scoped_release release;
    return distance_to_reference(curve.pose().orientation, {keys.times(), keys.orientations()});
  }());
}

nb::dict rate_error_of(const PythonCurve& curve, const Numbers& times, const Rows3& rates) {
  const auto rows = rows_of<Eigen::Vector3d>(std::optional(rates));
  return dictionary_of([&] {
    const nb::gil_scoped_release release;
    return rate_error(curve.pose().orientation, {span_of(times), rows});
  }());
}

nb::dict leave_out(const PythonCurve& curve) {
  auto found = [&] {
    const nb::gil_scoped_release release;
    const Track& track = *curve.keys().track;
    return jobs::check_without_gaps(track).and_then([&] { return leave_out_error(track.keys, curve.method()); });
  }();
  return dictionary_of(value_of(std::move(found)));
}

/// The key and the turn [rad], where there is one.
std::optional<std::pair<std::size_t, double>> overwound(const PythonCurve& curve) {
  const auto found = value_of(overwound_tangent(curve.method(), curve.keys().track->keys));
  if (!found) return std::nullopt;
  return std::pair(found->key, found->turn);
}

double whole_angle(const PythonCurve& curve) {
  const nb::gil_scoped_release release;
  return curve.travelled().total();
}

/// Numbers as `of` maps each of them: times to angles, or angles to times. NaN stays NaN.
template <class Of>
void map_numbers(const Numbers& from, const MutableNumbers& to, Of of) {
  const nb::gil_scoped_release release;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double number = from.data()[i];
    to.data()[i] = std::isnan(number) ? number : of(number);
  }
}

/// Of quaternions of any norm, row by row into `out`.
void matrices(const Rows4& quaternions, const MutableMatrices& out) {
  const nb::gil_scoped_release release;
  double* row = out.data();
  for (const double* q = quaternions.data(); q != quaternions.data() + quaternions.size(); q += 4, row += 9) {
    const double x = q[0], y = q[1], z = q[2], w = q[3], scale = 2.0 / (x * x + y * y + z * z + w * w);
    row[0] = 1.0 - scale * (y * y + z * z), row[1] = scale * (x * y - z * w), row[2] = scale * (x * z + y * w);
    row[3] = scale * (x * y + z * w), row[4] = 1.0 - scale * (x * x + z * z), row[5] = scale * (y * z - x * w);
    row[6] = scale * (x * z - y * w), row[7] = scale * (y * z + x * w), row[8] = 1.0 - scale * (x * x + y * y);
  }
}

/// The same as rotation vectors, up to half a turn long.
void rotation_vectors(const Rows4& quaternions, const MutableRows3& out) {
  const nb::gil_scoped_release release;
  for (std::size_t i = 0; i < quaternions.shape(0); ++i) {
    const Eigen::Map<const Eigen::Quaterniond> q(quaternions.data() + 4 * i);
    Eigen::Map<Eigen::Vector3d>(out.data() + 3 * i) =
        log<double>(q.w() < 0.0 ? Eigen::Quaterniond(-q.coeffs()) : Eigen::Quaterniond(q));
  }
}

/// What turns a body with these rates, into `out`.
void torques(const Rows3& angular_velocities, const Rows3& angular_accelerations, const Inertia& inertia,
             const MutableRows3& out) {
  const Eigen::Matrix3d matrix = matrix_of(inertia);
  const nb::gil_scoped_release release;
  const auto row = [](const auto& array, std::size_t i) {
    return Eigen::Map<const Eigen::Vector3d>(array.data() + 3 * i);
  };
  for (std::size_t i = 0; i < out.shape(0); ++i)
    Eigen::Map<Eigen::Vector3d>(out.data() + 3 * i) = torque(
        Motion{.angular_velocity = row(angular_velocities, i), .angular_acceleration = row(angular_accelerations, i)},
        matrix);
}

/// What shapes the curve: numbers, one or one per key, and words.
nb::dict settings_of(const PythonCurve& curve) {
  const FamilyInfo& family = *value_of(family_of_method(curve.method()));
  const CurveOptions& given = curve.method().options;
  nb::dict settings;
  for (const Parameter& parameter : family.parameters) {
    const auto found = given.parameters.find(parameter.name);
    const nb::str name = text(parameter.name);
    if (found == given.parameters.end()) settings[name] = parameter.initial;
    else if (found->second.size() == 1) settings[name] = found->second.front();
    else settings[name] = array_of(found->second.data(), found->second.size(), 0);
  }
  for (const Choice& choice : family.choices) {
    const auto found = given.choices.find(choice.name);
    const std::string_view word = found == given.choices.end() ? choice.words.front() : std::string_view(found->second);
    settings[text(choice.name)] = text(word);
  }
  return settings;
}

void bands_at(const PythonCurve& curve, double share, const Numbers& times, const MutableNumbers& out) {
  const jobs::Band band = value_of([&] {
    const nb::gil_scoped_release release;
    return jobs::band_of(*curve.keys().track, curve.method(), share);
  }());
  map_numbers(times, out, [&band](double t) { return jobs::band_at(band, t); });
}

}  // namespace

void add_analysis(nb::module_& module, nb::class_<PythonCurve>& curve_class) {
  module.def("check_inertia", &check_inertia, "inertia"_a);
  module.def("matrices", &matrices, "quaternions"_a, "out"_a.noconvert());
  module.def("rotation_vectors", &rotation_vectors, "quaternions"_a, "out"_a.noconvert());
  module.def("torques", &torques, "angular_velocities"_a, "angular_accelerations"_a, "inertia"_a, "out"_a.noconvert());
  curve_class.def_prop_ro("settings", &settings_of)
      .def("energies", &energies_of, "inertia"_a.none())
      .def("peaks", &peaks_of, "inertia"_a.none())
      .def("distance", &distance, "reference"_a)
      .def("rate_error", &rate_error_of, "times"_a, "rates"_a)
      .def("leave_out", &leave_out)
      .def("overwound_tangent", &overwound)
      .def("whole_angle", &whole_angle)
      .def(
          "angles_at",
          [](const PythonCurve& curve, const Numbers& times, const MutableNumbers& out) {
            map_numbers(times, out, [&](double t) { return curve.travelled().at(t); });
          },
          "times"_a, "out"_a.noconvert())
      .def(
          "times_at",
          [](const PythonCurve& curve, const Numbers& angles, const MutableNumbers& out) {
            map_numbers(angles, out, [&](double angle) { return curve.travelled().time_at(angle); });
          },
          "angles"_a, "out"_a.noconvert())
      .def("bands_at", &bands_at, "share"_a, "times"_a, "out"_a.noconvert());
}

}  // namespace orispline::python
