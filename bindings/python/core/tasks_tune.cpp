// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <orispline/tune.hpp>

#include "errors.hpp"
#include "interruption.hpp"
#include "tasks.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

namespace {

/// With the objective, which the result does not know.
struct TuneTask : TaskResult<Tuning> {
  Objective objective{};
};

TuneTask tuned(const Keys& keys, const std::string& method, const std::optional<Keys>& reference,
               const std::optional<Numbers>& reference_times, const nb::dict& stated) {
  auto options = options_in<TuneOptions>(stated);
  const Track beside = reference ? at_times(*reference, reference_times) : Track();
  const double shift = (beside.epoch - keys.track->epoch).to_double();
  std::vector<double> times(beside.keys.times().begin(), beside.keys.times().end());
  for (double& t : times) t += shift;
  if (reference) options.reference = {times, beside.keys.orientations()};
  const Method start = value_of(method_from_text(method));
  return {{keys, value_of(interruptible([&](const Progress& progress) {
             return tune(*keys.track, start, options, progress);
           }))},
          options.objective};
}

const std::vector<double>& values_of(const Tuning& tuning, const std::string& parameter) {
  return tuning.method.options.parameters.find(parameter)->second;
}

nb::dict members_of(const TuneTask& task) {
  nb::dict members;
  members["method"] = text(task.result.method.name);
  members["objective"] = text(word_of(task.objective));
  members["unit"] = text(unit_of(task.objective));
  members["keys"] = task.track().keys.size();
  put_members(members, task.result, task.track());
  std::vector<double> times(task.track().keys.times().begin(), task.track().keys.times().end());
  for (double& t : times) t += task.track().epoch.to_double();
  members["t"] = times;
  for (const std::string& name : task.result.parameters) members[text(name)] = values_of(task.result, name);
  return members;
}

nb::dict attributes_of_tuning(const TuneTask& task) {
  nb::dict attributes = attributes_of(task.result), values;
  for (const std::string& name : task.result.parameters) {
    const auto& numbers = values_of(task.result, name);
    values[text(name)] = array_of(numbers.data(), numbers.size(), 0);
  }
  attributes["parameters"] = values;
  attributes["objective"] = text(word_of(task.objective));
  attributes["unit"] = text(unit_of(task.objective));
  return attributes;
}

}  // namespace

void add_tune(nb::module_& module) {
  nb::class_<TuneTask>(module, "Tuning")
      .def_prop_ro("keys", [](const TuneTask& task) { return shared(task.result.track); })
      .def_prop_ro("method", [](const TuneTask& task) { return text(text_of(task.result.method)); })
      .def_prop_ro("warnings", [](const TuneTask& task) { return warnings_of(task.result.warnings); })
      .def("attributes", &attributes_of_tuning)
      .def("members", &members_of);
  module.def("tune", &tuned, "keys"_a, "method"_a, "reference"_a.none(), "reference_times"_a.none(), "options"_a);
}

}  // namespace orispline::python
