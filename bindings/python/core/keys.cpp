// SPDX-License-Identifier: Apache-2.0
#include "keys.hpp"

#include <map>
#include <string>

#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include "arrays.hpp"
#include "errors.hpp"
#include "text.hpp"

using namespace nanobind::literals;

namespace orispline::python {

namespace {

using Settings = std::map<std::string, std::vector<double>>;

Keys made(const Numbers& times, const Rows4& orientations, const std::optional<Rows3>& positions,
          const std::optional<Rows3>& angular_velocities, const std::optional<Rows3>& angular_accelerations,
          const std::optional<Rows3>& angular_jerks, const std::optional<Rows4>& inner_leaving,
          const std::optional<Rows4>& inner_arriving, const Settings& settings, const std::string& signs, bool jumps) {
  KeyframeData data{.times = {times.data(), times.data() + times.size()},
                    .orientations = rows_of<Eigen::Quaterniond>(orientations),
                    .positions = rows_of<Eigen::Vector3d>(positions),
                    .angular_velocities = rows_of<Eigen::Vector3d>(angular_velocities),
                    .angular_accelerations = rows_of<Eigen::Vector3d>(angular_accelerations),
                    .angular_jerks = rows_of<Eigen::Vector3d>(angular_jerks),
                    .inner_leaving = rows_of<Eigen::Quaterniond>(inner_leaving),
                    .inner_arriving = rows_of<Eigen::Quaterniond>(inner_arriving),
                    .jumps = jumps};
  const Signs how = signs == "as-given" ? Signs::as_given : Signs::shortest;
  const auto keys = [&] {
    const nb::gil_scoped_release release;
    return Keyframes::make(std::move(data), how);
  }();
  Track track(value_of(keys));
  track.recipe.signs = how;
  track.recipe.jumps = jumps;
  track.settings = {settings.begin(), settings.end()};
  for (const auto& [name, values] : track.settings)
    if (values.size() != track.keys.size())
      raise({ErrorCode::bad_argument,
             "found " + std::to_string(values.size()) + " values, wanted one per key, " +
                 std::to_string(track.keys.size()),
             {},
             name});
  return {std::make_shared<const Track>(std::move(track))};
}

std::optional<FloatArray> column_of(std::span<const Eigen::Vector3d> rows) {
  if (rows.empty()) return std::nullopt;
  return array_of(rows.front().data(), rows.size(), 3);
}

std::optional<FloatArray> column_of(std::span<const Eigen::Quaterniond> rows) {
  if (rows.empty()) return std::nullopt;
  return array_of(rows.front().coeffs().data(), rows.size(), 4);
}

nb::typed<nb::dict, nb::str, double> report_of(const Keys& keys) {
  const KeyframeReport& report = keys.track->keys.report();
  nb::typed<nb::dict, nb::str, double> result;
  result["sign_flips"] = report.sign_flips;
  result["non_unit_keys"] = report.non_unit_keys;
  result["largest_norm_error"] = report.largest_norm_error;
  result["near_half_turns"] = report.near_half_turns;
  return result;
}

}  // namespace

void add_keys(nb::module_& module) {
  nb::class_<Keys>(module, "Keys")
      .def(nb::new_(&made), "times"_a, "orientations"_a, "positions"_a.none(), "angular_velocities"_a.none(),
           "angular_accelerations"_a.none(), "angular_jerks"_a.none(), "inner_leaving"_a.none(),
           "inner_arriving"_a.none(), "settings"_a, "signs"_a, "jumps"_a = false)
      .def("__len__", [](const Keys& keys) { return keys.track->keys.size(); })
      .def_prop_ro("times",
                   [](const Keys& keys) {
                     const auto times = keys.track->keys.times();
                     return array_of(times.data(), times.size(), 0);
                   })
      .def_prop_ro("orientations",
                   [](const Keys& keys) {
                     const auto rows = keys.track->keys.orientations();  // at least one
                     return array_of(rows.front().coeffs().data(), rows.size(), 4);
                   })
      .def_prop_ro("positions", [](const Keys& keys) { return column_of(keys.track->keys.positions()); })
      .def_prop_ro("angular_velocities",
                   [](const Keys& keys) { return column_of(keys.track->keys.angular_velocities()); })
      .def_prop_ro("angular_accelerations",
                   [](const Keys& keys) { return column_of(keys.track->keys.angular_accelerations()); })
      .def_prop_ro("angular_jerks", [](const Keys& keys) { return column_of(keys.track->keys.angular_jerks()); })
      .def_prop_ro("inner_leaving", [](const Keys& keys) { return column_of(keys.track->keys.inner_leaving()); })
      .def_prop_ro("inner_arriving", [](const Keys& keys) { return column_of(keys.track->keys.inner_arriving()); })
      .def_prop_ro("settings",
                   [](const Keys& keys) { return Settings(keys.track->settings.begin(), keys.track->settings.end()); })
      .def_prop_ro("report", &report_of);
}

}  // namespace orispline::python
