// SPDX-License-Identifier: Apache-2.0
#include <iterator>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <orispline/reduce.hpp>

#include "errors.hpp"
#include "interruption.hpp"
#include "tasks.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {
namespace {

/// A recording with the reductions by each of the methods.
struct ReduceTask {
  Keys given;
  ReduceOptions options;
  std::vector<Reduction> all;

  [[nodiscard]] const Reduction& chosen() const { return all[smallest(all)]; }
};

std::vector<Method> methods_in(const std::optional<std::vector<std::string>>& texts) {
  if (!texts) return {reducing_methods.begin(), reducing_methods.end()};
  std::vector<Method> methods;
  for (const std::string& words : *texts) methods.push_back(value_of(method_from_text(words)));
  return methods;
}

void check_positions(const Track& track, const ReduceOptions& options, std::optional<std::size_t> curve) {
  if (options.tolerance.bounds_positions() && track.keys.positions().empty())
    raise({ErrorCode::bad_data, "found no positions, wanted some", {.curve = curve}, "position_tolerance"});
}

std::vector<ReduceTask> reduced(const std::vector<Keys>& recordings,
                                const std::optional<std::vector<std::string>>& texts, const nb::dict& stated,
                                unsigned threads) {
  const auto options = options_in<ReduceOptions>(stated);
  const std::vector<Method> methods = methods_in(texts);
  const bool is_one = recordings.size() == 1;
  std::vector<Track> tracks;
  for (const Keys& keys : recordings) {
    check_positions(*keys.track, options, is_one ? std::nullopt : std::optional(tracks.size()));
    tracks.push_back(*keys.track);
  }
  auto found = interruptible(
      [&](const Progress& progress) { return reduce_tracks(tracks, methods, options, threads, progress); });
  std::vector<ReduceTask> tasks;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i] && !is_one) found[i].error().where.curve = i;
    tasks.push_back({recordings[i], options, value_of(std::move(found[i]))});
  }
  return tasks;
}

nb::dict members_of_one(const ReduceTask& task, const Reduction& reduction) {
  nb::dict members;
  members["method"] = text(reduction.method.name);
  put_members(members, reduction, *task.given.track, Absent::left_out);
  return members;
}

nb::dict members_of(const ReduceTask& task) {
  nb::dict members = members_of_one(task, task.chosen());
  nb::list methods;
  for (const Reduction& reduction : task.all) methods.append(members_of_one(task, reduction));
  members["methods"] = methods;
  members["samples"] = task.given.track->keys.size();
  return members;
}

nb::dict attributes_of_reduction(const ReduceTask& task) {
  nb::dict attributes = attributes_of(task.chosen());
  attributes["samples"] = task.chosen().samples;
  return attributes;
}

void write_report(const ReduceTask& task, const std::string& path, const std::string& date) {
  write_page(path, pages::reduce_page(*task.given.track, task.all, task.options, {.date = date}));
}

}  // namespace

void add_reduce(nb::module_& module) {
  nb::class_<ReduceTask>(module, "Reduction")
      .def_prop_ro("keys", [](const ReduceTask& task) { return shared(task.chosen().track); })
      .def_prop_ro("method", [](const ReduceTask& task) { return text(text_of(task.chosen().method)); })
      .def("attributes", &attributes_of_reduction)
      .def("members", &members_of)
      .def("report", &write_report, "path"_a, "date"_a);
  module.def("reduce", &reduced, "recordings"_a, "methods"_a.none(), "options"_a, "threads"_a);
}

}  // namespace orispline::python
