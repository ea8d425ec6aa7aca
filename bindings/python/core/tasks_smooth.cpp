// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nanobind/stl/optional.h>

#include <orispline/jobs.hpp>

#include "errors.hpp"
#include "interruption.hpp"
#include "tasks.hpp"
#include "text.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

namespace {

using jobs::SmoothOutcome;

/// The rates of a gyro at times of their own; null without any.
std::shared_ptr<const GyroRates> gyro_of(const std::optional<Numbers>& times, const std::optional<Rows3>& rates) {
  if (!times || !rates) return nullptr;
  const std::span<const double> seconds = span_of(*times);
  return std::make_shared<const GyroRates>(GyroRates{.times = {seconds.begin(), seconds.end()},
                                                     .rates = rows_of<Eigen::Vector3d>(rates),
                                                     .clock = GyroRates::Clock::own});
}

SmoothOutcome smoothed(const Keys& keys, const nb::dict& stated, const std::optional<Numbers>& times,
                       const std::optional<Rows3>& rates) {
  jobs::SmoothRequest request{
      .recording = keys.track, .options = options_in<SmoothOptions>(stated), .gyro = gyro_of(times, rates)};
  return value_of(interruptible([&](const Progress& progress) { return jobs::smooth(std::move(request), progress); }));
}

/// Three columns; nothing where they were not asked for.
std::optional<FloatArray> sigmas_of(const SmoothOutcome& outcome, std::vector<Eigen::Vector3d> NodeSigmas::*which) {
  if (!outcome.smoothing.sigmas) return std::nullopt;
  const std::vector<Eigen::Vector3d>& rows = (*outcome.smoothing.sigmas).*which;
  return array_of(rows.front().data(), rows.size(), 3);
}

}  // namespace

void add_smooth(nb::module_& module) {
  auto outcome_class = nb::class_<SmoothOutcome>(module, "Smoothing");
  outcome_class.def_prop_ro("keys", [](const SmoothOutcome& outcome) { return shared(outcome.smoothing.track); })
      .def_prop_ro("method", [](const SmoothOutcome& outcome) { return MethodText::of(outcome.smoothing.method); })
      .def("attributes", [](const SmoothOutcome& outcome) { return attributes_of(outcome.smoothing); })
      .def_prop_ro("sigma", [](const SmoothOutcome& outcome) { return sigmas_of(outcome, &NodeSigmas::orientations); })
      .def_prop_ro("sigma_of_rates",
                   [](const SmoothOutcome& outcome) { return sigmas_of(outcome, &NodeSigmas::angular_velocities); })
      .def(
          "covers", [](const SmoothOutcome& outcome, double t) { return outcome.smoothing.covers(t); }, "t"_a);
  add_words(outcome_class);
  add_page(outcome_class);
  module.def("smooth", &smoothed, "keys"_a, "options"_a, "times"_a = nb::none(), "rates"_a = nb::none());
}

}  // namespace orispline::python
