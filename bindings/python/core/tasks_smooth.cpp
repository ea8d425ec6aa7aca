// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <string>
#include <vector>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <orispline/smooth.hpp>

#include "errors.hpp"
#include "interruption.hpp"
#include "tasks.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

namespace {

using Task = TaskResult<Smoothing>;

Task smoothed(const Keys& keys, const nb::dict& stated) {
  const auto options = options_in<SmoothOptions>(stated);
  return {keys, value_of(interruptible([&](const Progress& progress) { return smooth(*keys.track, options, progress); }))};
}

nb::dict members_of(const Task& task) {
  nb::dict members;
  put_members(members, task.result, task.track());
  return members;
}

/// Three columns; nothing where they were not asked for.
std::optional<FloatArray> sigmas_of(const Task& task, std::vector<Eigen::Vector3d> NodeSigmas::* which) {
  if (!task.result.sigmas) return std::nullopt;
  const std::vector<Eigen::Vector3d>& rows = (*task.result.sigmas).*which;
  return array_of(rows.front().data(), rows.size(), 3);
}

void write_report(const Task& task, const std::string& path, const std::string& date) {
  write_page(path, pages::smooth_page(task.track(), task.result, {.date = date}));
}

}  // namespace

void add_smooth(nb::module_& module) {
  nb::class_<Task>(module, "Smoothing")
      .def_prop_ro("keys", [](const Task& task) { return shared(task.result.track); })
      .def_prop_ro("method", [](const Task& task) { return text(text_of(task.result.method)); })
      .def("attributes", [](const Task& task) { return attributes_of(task.result); })
      .def("members", &members_of)
      .def_prop_ro("warnings", [](const Task& task) { return warnings_of(task.result.warnings); })
      .def_prop_ro("sigma", [](const Task& task) { return sigmas_of(task, &NodeSigmas::orientations); })
      .def_prop_ro("sigma_of_rates", [](const Task& task) { return sigmas_of(task, &NodeSigmas::angular_velocities); })
      .def("covers", [](const Task& task, double t) { return task.result.covers(t); }, "t"_a)
      .def("report", &write_report, "path"_a, "date"_a);
  module.def("smooth", &smoothed, "keys"_a, "options"_a);
}

}  // namespace orispline::python
