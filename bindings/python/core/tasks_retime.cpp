// SPDX-License-Identifier: Apache-2.0
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

using jobs::RetimeOutcome;

RetimeOutcome retimed(const Keys& keys, const std::optional<MethodText>& method, const nb::dict& stated) {
  jobs::RetimeRequest request{.keys = keys.track,
                              .method = method_chosen(method, *keys.track, jobs::usual_retimed),
                              .options = options_in<RetimeOptions>(stated)};
  return value_of(interruptible([&](const Progress& progress) { return jobs::retime(std::move(request), progress); }));
}

nb::dict attributes_of_retiming(const RetimeOutcome& outcome) {
  nb::dict attributes = attributes_of(outcome.retiming);
  attributes["duration_before"] = outcome.duration_before();
  nb::dict certificates;
  for (const Certificate& c : outcome.certificates())
    certificates[text(c.id)] = nb::make_tuple(c.limit, c.bound, c.found, c.time, c.segment);
  attributes["certificates"] = certificates;
  return attributes;
}

}  // namespace

void add_retime(nb::module_& module) {
  auto outcome_class = nb::class_<RetimeOutcome>(module, "Retiming");
  outcome_class.def_prop_ro("keys", [](const RetimeOutcome& outcome) { return shared(outcome.retiming.track); })
      .def_prop_ro("method", [](const RetimeOutcome& outcome) { return MethodText::of(outcome.retiming.method); })
      .def("attributes", &attributes_of_retiming);
  add_words(outcome_class);
  add_page(outcome_class);
  module.def("retime", &retimed, "keys"_a, "method"_a.none(), "options"_a);
}

}  // namespace orispline::python
