// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <orispline/jobs.hpp>
#include <orispline/smooth.hpp>

#include "errors.hpp"
#include "interruption.hpp"
#include "tasks.hpp"
#include "text.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

namespace {

using jobs::ReduceOutcome;

std::vector<ReduceOutcome> reduced(const std::vector<Keys>& recordings,
                                   const std::optional<std::vector<MethodText>>& methods, const nb::dict& options,
                                   const std::optional<nb::dict>& smoothing, unsigned threads) {
  jobs::ReduceRequest request{.recordings = {}, .options = options_in<ReduceOptions>(options), .threads = threads};
  for (const Keys& keys : recordings) request.recordings.push_back(keys.track);
  if (methods) {
    request.methods.clear();
    for (const MethodText& one : *methods) request.methods.push_back(one.method());
  }
  if (smoothing) {
    request.smoothing = options_in<SmoothOptions>(*smoothing);
    value_of(check(*request.smoothing));
  }
  std::vector<ReduceOutcome> outcomes;
  for (auto& outcome : interruptible([&](const Progress& progress) { return jobs::reduce(request, progress); }))
    outcomes.push_back(value_of(std::move(outcome)));
  return outcomes;
}

nb::dict attributes_of_reduction(const ReduceOutcome& outcome) {
  nb::dict attributes = attributes_of(outcome.chosen());
  attributes["samples"] = outcome.chosen().samples;
  const auto* raw = outcome.smoothed ? &outcome.smoothed->raw : nullptr;
  const auto* path = raw && outcome.smoothed->raw_positions ? &*outcome.smoothed->raw_positions : nullptr;
  attributes["raw_error_rms"] = raw ? nb::cast(raw->rms) : nb::none();
  attributes["raw_error_max"] = raw ? nb::cast(raw->largest) : nb::none();
  attributes["raw_position_error_rms"] = path ? nb::cast(path->rms) : nb::none();
  attributes["raw_position_error_max"] = path ? nb::cast(path->largest) : nb::none();
  return attributes;
}

std::optional<jobs::SmoothOutcome> smoothing_of(const ReduceOutcome& outcome) {
  return outcome.smoothed ? std::optional<jobs::SmoothOutcome>(*outcome.smoothed) : std::nullopt;
}

}  // namespace

void add_reduce(nb::module_& module) {
  auto outcome_class = nb::class_<ReduceOutcome>(module, "Reduction");
  outcome_class.def_prop_ro("keys", [](const ReduceOutcome& outcome) { return shared(outcome.chosen().track); })
      .def_prop_ro("method", [](const ReduceOutcome& outcome) { return MethodText::of(outcome.chosen().method); })
      .def_prop_ro("smoothing", &smoothing_of)
      .def("attributes", &attributes_of_reduction);
  add_words(outcome_class);
  add_page(outcome_class);
  module.def("reduce", &reduced, "recordings"_a, "methods"_a.none(), "options"_a, "smoothing"_a.none(), "threads"_a);
}

}  // namespace orispline::python
