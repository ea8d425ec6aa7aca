// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <orispline/jobs.hpp>

#include "errors.hpp"
#include "interruption.hpp"
#include "tasks.hpp"
#include "text.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

namespace {

using jobs::TuneOutcome;

TuneOutcome tuned(const Keys& keys, const MethodText& method, const std::optional<Keys>& reference,
                  const nb::dict& stated) {
  jobs::TuneRequest request{.keys = keys.track,
                            .method = method_chosen(method, *keys.track, jobs::usual_tuned),
                            .reference = reference_in(reference),
                            .options = options_in<TuneOptions>(stated)};
  return value_of(interruptible([&](const Progress& progress) { return jobs::tune(std::move(request), progress); }));
}

nb::dict attributes_of_tuning(const TuneOutcome& outcome) {
  nb::dict attributes = attributes_of(outcome.tuning), values;
  for (const std::string& name : outcome.tuning.parameters) {
    const auto& numbers = outcome.values(name);
    values[text(name)] = array_of(numbers.data(), numbers.size(), 0);
  }
  attributes["parameters"] = values;
  attributes["objective"] = text(word_of(outcome.request.options.objective));
  attributes["unit"] = text(unit_of(outcome.request.options.objective));
  return attributes;
}

}  // namespace

void add_tune(nb::module_& module) {
  auto outcome_class = nb::class_<TuneOutcome>(module, "Tuning");
  outcome_class.def_prop_ro("keys", [](const TuneOutcome& outcome) { return shared(outcome.tuning.track); })
      .def_prop_ro("method", [](const TuneOutcome& outcome) { return MethodText::of(outcome.tuning.method); })
      .def("attributes", &attributes_of_tuning);
  add_words(outcome_class);
  module.def("tune", &tuned, "keys"_a, "method"_a, "reference"_a.none(), "options"_a);
}

}  // namespace orispline::python
