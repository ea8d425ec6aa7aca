// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <orispline/jobs.hpp>

#include "errors.hpp"
#include "tasks.hpp"
#include "text.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

namespace {

using jobs::MeanOutcome;

/// Of the rows of one track, or of several that are one set.
jobs::MeanRequest request_of(const std::vector<Keys>& keys, const MeanOptions& options) {
  if (keys.size() == 1) return {.rows = keys.front().track, .options = options};
  std::vector<Track> tracks;
  for (const Keys& one : keys) tracks.push_back(*one.track);
  return value_of(jobs::mean_of_all(tracks, options));
}

MeanOutcome mean_found(const std::vector<Keys>& keys, const std::optional<Numbers>& weights, const nb::dict& stated) {
  jobs::MeanRequest request = request_of(keys, options_in<MeanOptions>(stated));
  if (weights) {
    Track weighted = *request.rows;
    const auto numbers = span_of(*weights);
    weighted.settings[std::string(jobs::weight_name)] = {numbers.begin(), numbers.end()};
    request.rows = std::make_shared<const Track>(std::move(weighted));
  }
  return value_of([&] {
    const nb::gil_scoped_release release;
    return jobs::mean(std::move(request));
  }());
}

nb::dict attributes_of_window(const MeanWindow& window) {
  const Mean& found = window.mean;
  nb::dict attributes = attributes_of(found);
  attributes["time"] = window.time;
  attributes["orientation"] = array_of(found.orientation.coeffs().data(), 4, 0);
  attributes["position"] = found.position ? nb::object(array_of(found.position->data(), 3, 0)) : nb::none();
  attributes["farthest"] = found.farthest;
  attributes["farthest_position"] = found.farthest_position ? nb::cast(*found.farthest_position) : nb::none();
  return attributes;
}

nb::list windows_of(const MeanOutcome& outcome) {
  nb::list windows;
  for (const MeanWindow& window : outcome.windows) windows.append(attributes_of_window(window));
  return windows;
}

}  // namespace

void add_mean(nb::module_& module) {
  auto outcome_class = nb::class_<MeanOutcome>(module, "Mean");
  outcome_class.def("windows", &windows_of);
  add_words(outcome_class);
  module.def("mean", &mean_found, "keys"_a, "weights"_a.none(), "options"_a);
}

}  // namespace orispline::python
