// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <optional>
#include <string>

#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/vector.h>

#include <orispline/streams.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "keys.hpp"
#include "method_text.hpp"
#include "sample_memory.hpp"
#include "text.hpp"

using namespace nanobind::literals;

namespace orispline::python {

namespace {

using Four = nb::ndarray<const double, nb::shape<4>, nb::c_contig, nb::device::cpu>;
using Three = nb::ndarray<const double, nb::shape<3>, nb::c_contig, nb::device::cpu>;

/// `with_keys`: the settings that come with the keys.
OnlineCurve online_curve(const MethodText& stated, const std::vector<std::string>& with_keys, std::size_t capacity,
                         const std::string& signs) {
  Method method = stated.method();
  for (const std::string& name : with_keys) method.options.parameters.insert({name, {}});
  return value_of(OnlineCurve::make(method, capacity, signs == "as-given" ? Signs::as_given : Signs::shortest));
}

std::optional<Eigen::Vector3d> vector_of(const std::optional<Three>& numbers) {
  return numbers ? std::optional<Eigen::Vector3d>(numbers->data()) : std::nullopt;
}

std::optional<Eigen::Quaterniond> quaternion_of(const std::optional<Four>& numbers) {
  return numbers ? std::optional<Eigen::Quaterniond>(numbers->data()) : std::nullopt;
}

void append(OnlineCurve& curve, double time, const Four& orientation, const std::optional<Three>& position,
            const std::optional<Three>& angular_velocity, const std::optional<Three>& angular_acceleration,
            const std::optional<Three>& angular_jerk, const std::optional<Four>& inner_leaving,
            const std::optional<Four>& inner_arriving, const std::map<std::string, double>& settings) {
  value_of(curve.append({.time = time,
                         .orientation = Eigen::Quaterniond(orientation.data()),
                         .position = vector_of(position),
                         .angular_velocity = vector_of(angular_velocity),
                         .angular_acceleration = vector_of(angular_acceleration),
                         .angular_jerk = vector_of(angular_jerk),
                         .inner_leaving = quaternion_of(inner_leaving),
                         .inner_arriving = quaternion_of(inner_arriving),
                         .settings = {settings.begin(), settings.end()}}));
}

std::optional<std::pair<double, double>> available(const OnlineCurve& curve) {
  const auto domain = curve.available();
  return domain ? std::optional(std::pair(domain->start, domain->end)) : std::nullopt;
}

/// Orientations, and where there is room for them rates and positions, into memory of NumPy.
void fill(const OnlineCurve& curve, const Numbers& times, const Memory<double>& orientations,
          const std::optional<Memory<double>>& angular_velocities,
          const std::optional<Memory<double>>& angular_accelerations,
          const std::optional<Memory<double>>& angular_jerks, const std::optional<Memory<double>>& positions,
          const std::optional<Memory<double>>& velocities, const std::optional<Memory<double>>& accelerations) {
  const Samples<double> out = samples_in<double>(orientations, angular_velocities, angular_accelerations, angular_jerks,
                                                 positions, velocities, accelerations);
  const auto done = [&] {
    const nb::gil_scoped_release release;
    return curve.sample(span_of(times), out);
  }();
  value_of(done);
}

}  // namespace

void add_online(nb::module_& module) {
  module.def("online_methods", [] {
    nb::list list;
    for (const std::string_view name : OnlineCurve::methods()) list.append(text(name));
    return list;
  });
  nb::class_<OnlineCurve>(module, "OnlineCurve")
      .def(nb::new_(&online_curve), "method"_a, "with_keys"_a, "capacity"_a, "signs"_a)
      .def("append", &append, "time"_a, "orientation"_a, "position"_a.none(), "angular_velocity"_a.none(),
           "angular_acceleration"_a.none(), "angular_jerk"_a.none(), "inner_leaving"_a.none(),
           "inner_arriving"_a.none(), "settings"_a)
      .def("finish", [](OnlineCurve& curve) { value_of(curve.finish()); })
      .def("reset", &OnlineCurve::reset)
      .def("available", &available)
      .def("fill", &fill, "times"_a, "orientations"_a.noconvert(),
           "angular_velocities"_a.noconvert().none() = nb::none(),
           "angular_accelerations"_a.noconvert().none() = nb::none(), "angular_jerks"_a.noconvert().none() = nb::none(),
           "positions"_a.noconvert().none() = nb::none(), "velocities"_a.noconvert().none() = nb::none(),
           "accelerations"_a.noconvert().none() = nb::none())
      .def_prop_ro("has_positions", &OnlineCurve::has_positions)
      .def_prop_ro("look_ahead", &OnlineCurve::look_ahead)
      .def("__len__", [](const OnlineCurve& curve) { return static_cast<std::size_t>(curve.keys()); });
}

}  // namespace orispline::python
