// SPDX-License-Identifier: Apache-2.0
#include <iterator>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <orispline/base/parallel.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/reduce.hpp>
#include <orispline/smooth.hpp>

#include "errors.hpp"
#include "interruption.hpp"
#include "tasks.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

namespace {

/// What was done to a recording before, and how far the chosen curve is from it as it was [rad] and its path [m], samples
/// that were rejected apart.
struct SmoothedFirst {
  Smoothing smoothing;
  DistanceStatistics raw{};
  std::optional<DistanceStatistics> raw_positions{};
};

/// A recording with the reductions by each of the methods.
struct ReduceTask {
  Keys given;
  ReduceOptions options;
  std::vector<Reduction> all;
  std::optional<SmoothedFirst> smoothed;

  [[nodiscard]] const Reduction& chosen() const { return all[smallest(all)]; }
  [[nodiscard]] const Track& reduced() const { return smoothed ? smoothed->smoothing.track : *given.track; }
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

SmoothedFirst measured(Smoothing smoothing, const Track& recording, const Reduction& reduction) {
  SmoothedFirst smoothed{.smoothing = std::move(smoothing)};
  smoothed.raw = value_of(distance_of(reduction, recording.keys, smoothed.smoothing.rejected));
  if (const auto& positions = smoothed.smoothing.positions)
    smoothed.raw_positions = value_of(position_distance_of(reduction, recording.keys, positions->rejected));
  return smoothed;
}

/// What is to be done to each of the recordings.
struct Request {
  std::vector<Method> methods;
  ReduceOptions options;
  std::optional<SmoothOptions> smoothing;
  unsigned threads;
};

/// The smoothed recordings, or why there is none; nothing where they are to be reduced as they are.
std::vector<Expected<Smoothing>> smoothed(const std::vector<Track>& tracks, const Request& request,
                                          const Progress& progress) {
  std::vector<Expected<Smoothing>> found;
  if (!request.smoothing) return found;
  found.resize(tracks.size());
  parallel_for(tracks.size(), request.threads, [&](std::size_t i) {
    found[i] = smooth(tracks[i], *request.smoothing, {.stop = progress.stop});
  });
  return found;
}

std::vector<ReduceTask> reduced(const std::vector<Keys>& recordings, const Request& request) {
  const bool is_one = recordings.size() == 1;
  const auto number_of = [&](std::size_t i) { return is_one ? std::nullopt : std::optional(i); };
  std::vector<Track> tracks;
  for (const Keys& keys : recordings) {
    check_positions(*keys.track, request.options, number_of(tracks.size()));
    tracks.push_back(*keys.track);
  }
  auto smoothings = interruptible([&](const Progress& progress) { return smoothed(tracks, request, progress); });
  for (std::size_t i = 0; i < smoothings.size(); ++i) {
    if (!smoothings[i]) smoothings[i].error().where.curve = number_of(i);
    tracks[i] = value_of(smoothings[i]).track;
  }
  auto found = interruptible([&](const Progress& progress) {
    return reduce_tracks(tracks, request.methods, request.options, request.threads, progress);
  });
  std::vector<ReduceTask> tasks;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i]) found[i].error().where.curve = number_of(i);
    tasks.push_back({recordings[i], request.options, value_of(std::move(found[i])), std::nullopt});
    if (smoothings.empty()) continue;
    tasks.back().smoothed = measured(std::move(*smoothings[i]), *recordings[i].track, tasks.back().chosen());
  }
  return tasks;
}

nb::dict members_of_one(const ReduceTask& task, const Reduction& reduction) {
  nb::dict members;
  members["method"] = text(reduction.method.name);
  put_members(members, reduction, task.reduced(), Absent::left_out);
  return members;
}

/// As the command's JSON has it.
nb::dict members_of_smoothing(const ReduceTask& task) {
  const auto& [smoothing, raw, raw_positions] = *task.smoothed;
  const Track& recording = *task.given.track;
  const auto time_of = [&](std::size_t sample) { return text(recording.time_of(sample).to_string()); };
  nb::dict members;
  const auto put = [&](std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names)
      put_members(members, {&field_named(fields_of<Smoothing>(), name), 1}, &smoothing, recording);
  };
  put({"smoothing_time", "cutoff", "criterion", "noise", "rejected"});
  members["raw_error_rms_deg"] = raw.rms * degrees;
  members["raw_error_max_deg"] = raw.largest * degrees;
  members["raw_error_max_time_s"] = time_of(raw.largest_at);
  if (!raw_positions) return members;
  put({"position_smoothing_time", "position_criterion", "position_noise", "rejected_positions"});
  members["raw_position_error_rms_m"] = raw_positions->rms;
  members["raw_position_error_max_m"] = raw_positions->largest;
  members["raw_position_error_max_time_s"] = time_of(raw_positions->largest_at);
  return members;
}

nb::dict members_of(const ReduceTask& task) {
  nb::dict members = members_of_one(task, task.chosen());
  nb::list methods;
  for (const Reduction& reduction : task.all) methods.append(members_of_one(task, reduction));
  members["methods"] = methods;
  members["samples"] = task.given.track->keys.size();
  if (task.smoothed) members["smoothing"] = members_of_smoothing(task);
  return members;
}

nb::dict attributes_of_reduction(const ReduceTask& task) {
  nb::dict attributes = attributes_of(task.chosen());
  attributes["samples"] = task.chosen().samples;
  const auto* raw = task.smoothed ? &task.smoothed->raw : nullptr;
  const auto* path = raw && task.smoothed->raw_positions ? &*task.smoothed->raw_positions : nullptr;
  attributes["raw_error_rms"] = raw ? nb::cast(raw->rms) : nb::none();
  attributes["raw_error_max"] = raw ? nb::cast(raw->largest) : nb::none();
  attributes["raw_position_error_rms"] = path ? nb::cast(path->rms) : nb::none();
  attributes["raw_position_error_max"] = path ? nb::cast(path->largest) : nb::none();
  return attributes;
}

std::optional<jobs::SmoothOutcome> smoothing_of(const ReduceTask& task) {
  if (!task.smoothed) return std::nullopt;
  return jobs::SmoothOutcome{{task.given.track}, task.smoothed->smoothing, task.smoothed->smoothing.warnings};
}

void write_report(const ReduceTask& task, const std::string& path, const std::string& date) {
  const auto smoothing_time = task.smoothed ? std::optional(task.smoothed->smoothing.smoothing_time) : std::nullopt;
  write_page(path, pages::reduce_page(task.reduced(), task.all, task.options, {.date = date}, smoothing_time));
}

std::vector<ReduceTask> reduce_recordings(const std::vector<Keys>& recordings,
                                          const std::optional<std::vector<std::string>>& methods,
                                          const nb::dict& options, const std::optional<nb::dict>& smoothing,
                                          unsigned threads) {
  Request request{methods_in(methods), options_in<ReduceOptions>(options), std::nullopt, threads};
  if (smoothing) request.smoothing = options_in<SmoothOptions>(*smoothing);
  if (request.smoothing) value_of(check(*request.smoothing));
  return reduced(recordings, request);
}

}  // namespace

void add_reduce(nb::module_& module) {
  nb::class_<ReduceTask>(module, "Reduction")
      .def_prop_ro("keys", [](const ReduceTask& task) { return shared(task.chosen().track); })
      .def_prop_ro("method", [](const ReduceTask& task) { return text(text_of(task.chosen().method)); })
      .def_prop_ro("smoothing", &smoothing_of)
      .def("attributes", &attributes_of_reduction)
      .def("members", &members_of)
      .def("report", &write_report, "path"_a, "date"_a);
  module.def("reduce", &reduce_recordings, "recordings"_a, "methods"_a.none(), "options"_a, "smoothing"_a.none(),
             "threads"_a);
}

}  // namespace orispline::python
