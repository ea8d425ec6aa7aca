// SPDX-License-Identifier: Apache-2.0
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

using jobs::AlignOutcome;

AlignOutcome alignment_of(const Keys& moved, const Keys& fixed, const nb::dict& stated) {
  jobs::AlignRequest request{.moved = moved.track, .fixed = fixed.track, .options = options_in<AlignOptions>(stated)};
  return value_of(interruptible([&](const Progress& progress) { return jobs::align(std::move(request), progress); }));
}

nb::dict attributes_of_alignment(const AlignOutcome& outcome) {
  const Alignment& alignment = outcome.alignment;
  nb::dict attributes = attributes_of(alignment);
  attributes["world"] = numbers_of(alignment.world);
  attributes["body"] = numbers_of(alignment.body);
  nb::list open;
  for (const OpenDirection& one : alignment.open)
    open.append(nb::make_tuple(numbers_of(one.world), numbers_of(one.body), one.offset, one.scale,
                               numbers_of(one.translation)));
  attributes["open"] = open;
  return attributes;
}

Keys applied(const AlignOutcome& outcome, const Keys& keys) {
  return shared(value_of(aligned(*keys.track, *outcome.request.fixed, outcome.alignment)));
}

}  // namespace

void add_align(nb::module_& module) {
  auto outcome_class = nb::class_<AlignOutcome>(module, "Alignment");
  outcome_class.def_prop_ro("keys", [](const AlignOutcome& outcome) { return shared(outcome.aligned); })
      .def("attributes", &attributes_of_alignment)
      .def("apply", &applied, "keys"_a);
  add_words(outcome_class);
  module.def("align", &alignment_of, "moved"_a, "fixed"_a, "options"_a);
}

}  // namespace orispline::python
