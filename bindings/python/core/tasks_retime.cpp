// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <orispline/families/registry.hpp>
#include <orispline/retime.hpp>

#include "errors.hpp"
#include "interruption.hpp"
#include "tasks.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

namespace {

/// With what was asked for, which the result does not know.
struct RetimeTask : TaskResult<Retiming> {
  RetimeOptions options{};

  [[nodiscard]] std::vector<Certificate> certificates() const {
    return certificates_of(options.limits, result.peaks);
  }
};

bool takes_no_rates(const FamilyInfo& family) { return family.rate_orders == 0; }

RetimeTask retimed(const Keys& keys, const std::optional<std::string>& method, const nb::dict& stated) {
  auto options = options_in<RetimeOptions>(stated);
  const Track& track = *keys.track;
  Method chosen = method_for(method, track, default_method, takes_no_rates);
  if (!method && track.recipe.is_empty()) chosen = holding_rests(std::move(chosen), track.keys);
  Retiming retiming = value_of(
      interruptible([&](const Progress& progress) { return retime(track, chosen, options, progress); }));
  return {{keys, std::move(retiming)}, std::move(options)};
}

double duration_before(const RetimeTask& task) {
  return task.track().keys.times().back() - task.track().keys.times().front();
}

nb::dict members_of(const RetimeTask& task) {
  nb::dict members;
  members["method"] = text(task.result.method.name);
  members["slowing_asked_for"] = text(word_of(task.options.slowing));
  members["duration_before_s"] = duration_before(task);
  put_members(members, task.result, task.track());
  for (const Certificate& c : task.certificates()) {
    members[text(c.id_of("limit"))] = c.limit / c.in_ids.size;
    members[text(c.id_of("bound"))] = c.bound / c.in_ids.size;
    members[text(c.id_of("max"))] = c.found / c.in_ids.size;
    members[text(c.id + "_max_after_s")] = c.time;
    members[text(c.id + "_bound_after_key")] = c.segment;
  }
  return members;
}

nb::dict attributes_of_retiming(const RetimeTask& task) {
  nb::dict attributes = attributes_of(task.result);
  attributes["duration_before"] = duration_before(task);
  nb::dict certificates;
  for (const Certificate& c : task.certificates())
    certificates[text(c.id)] = nb::make_tuple(c.limit, c.bound, c.found, c.time, c.segment);
  attributes["certificates"] = certificates;
  return attributes;
}

void write_report(const RetimeTask& task, const std::string& path, const std::string& date) {
  write_page(path, pages::retime_page(task.track(), task.result, task.options.limits, {.date = date}));
}

}  // namespace

void add_retime(nb::module_& module) {
  nb::class_<RetimeTask>(module, "Retiming")
      .def_prop_ro("keys", [](const RetimeTask& task) { return shared(task.result.track); })
      .def_prop_ro("method", [](const RetimeTask& task) { return text(text_of(task.result.method)); })
      .def_prop_ro("warnings", [](const RetimeTask& task) { return warnings_of(task.result.warnings); })
      .def("attributes", &attributes_of_retiming)
      .def("members", &members_of)
      .def("report", &write_report, "path"_a, "date"_a);
  module.def("retime", &retimed, "keys"_a, "method"_a.none(), "options"_a);
}

}  // namespace orispline::python
