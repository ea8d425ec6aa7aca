// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <orispline/analysis.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/tune.hpp>

#include "errors.hpp"
#include "interruption.hpp"
#include "tasks.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

namespace {

/// What was asked for.
struct Request {
  std::vector<std::string> labels{};  ///< method texts
  bool tune = false;
  MeasureInfo sort{};
  MeasureOptions measured{};
  std::optional<Eigen::Matrix3d> inertia{};
  unsigned threads = 0;
};

struct CompareTask {
  ComparedData data;
  std::vector<ComparedMethod> methods;
  Request request;
  std::vector<Warning> warnings;

  [[nodiscard]] std::vector<MeasureInfo> measures() const {
    return data.measures(request.measured.leave_out, request.inertia);
  }
};

Request request_in(const std::optional<std::vector<std::string>>& texts, bool tune, const std::string& sort,
                   const nb::dict& measured, unsigned threads) {
  Request request{.tune = tune, .sort = value_of(measure_of_word(sort)), .measured = options_in<MeasureOptions>(measured)};
  request.threads = threads;
  value_of(check(request.measured));
  if (measured.contains("inertia") && !nb::object(measured["inertia"]).is_none())
    request.inertia = request.measured.inertia;
  if (texts) request.labels = *texts;
  else
    for (const FamilyInfo& family : families_info()) request.labels.emplace_back(family.name);
  for (const std::string& label : request.labels) value_of(method_from_text(label));
  return request;
}

ComparedData data_of(const Keys& keys, const std::optional<Keys>& reference,
                     const std::optional<Numbers>& reference_times, const std::vector<nb::typed<nb::dict, nb::str, nb::any>>& decimations) {
  if (reference) return value_of(beside_recording(*keys.track, at_times(*reference, reference_times)));
  std::vector<Decimation> each;
  for (const nb::dict& stated : decimations) {
    each.push_back(options_in<Decimation>(stated));
    value_of(check_ranges(each.back()));
  }
  return value_of(beside_own_samples(*keys.track, each));
}

/// The same with the tensions that make ∫|α|² least, or with the reason why there are none.
ComparedMethod tuned(ComparedMethod method, const Track& track, const Progress& progress) {
  method.label += ":tuned";
  auto tuning = tune(track, method.candidate.method, {}, progress);
  if (tuning) method.candidate.method = std::move(tuning->method);
  else method.measures = tl::unexpected(track.located(std::move(tuning.error())));
  return method;
}

bool has_tensions(const Method& method) {
  const FamilyInfo& family = *value_of(find_family(method.name));
  return std::ranges::any_of(family.parameters, &Parameter::tunable);
}

/// Every method on every set of keys; `false`: still to be tuned.
std::vector<std::pair<ComparedMethod, bool>> methods_of(const CompareTask& task) {
  std::vector<std::pair<ComparedMethod, bool>> methods;
  for (std::size_t i = 0; i < task.data.key_sets.size(); ++i)
    for (const std::string& label : task.request.labels) {
      const Track& track = task.data.key_sets[i].track;
      Method method = value_of(method_from_text(label));
      const bool tunes = task.request.tune && has_tensions(method);
      Method whole = completed(method, *value_of(find_family(method.name)), track);
      methods.push_back({{.label = label, .key_set = i, .candidate = {std::move(whole), track.keys}}, true});
      if (tunes) methods.push_back({methods.back().first, false});
    }
  return methods;
}

void measure_all(CompareTask& task, const std::vector<std::pair<ComparedMethod, bool>>& methods,
                 const Progress& progress) {
  std::vector<Candidate> candidates;
  for (const auto& [method, is_ready] : methods) {
    if (progress.stopped()) return;
    const Track& track = task.data.key_sets[method.key_set].track;
    task.methods.push_back(is_ready ? method : tuned(method, track, progress));
    candidates.push_back(task.methods.back().candidate);
  }
  Comparison comparison =
      compare(candidates, task.data.recording(), task.request.measured, task.request.threads, progress);
  task.warnings.insert(task.warnings.end(), comparison.warnings.begin(), comparison.warnings.end());
  for (std::size_t i = 0; i < task.methods.size(); ++i) {
    ComparedMethod& method = task.methods[i];
    if (!method.measures) continue;  // it could not be tuned
    const Track& track = task.data.key_sets[method.key_set].track;
    method.measures = std::move(comparison.measures[i]).map_error([&](Error error) {
      return track.located(std::move(error));
    });
  }
}

CompareTask compared(const Keys& keys, const std::optional<Keys>& reference,
                     const std::optional<Numbers>& reference_times, const std::vector<nb::typed<nb::dict, nb::str, nb::any>>& decimations,
                     const std::optional<std::vector<std::string>>& texts, bool tune, const std::string& sort,
                     const nb::dict& measured, unsigned threads) {
  Request request = request_in(texts, tune, sort, measured, threads);
  CompareTask task{.data = data_of(keys, reference, reference_times, decimations),
                   .methods = {},
                   .request = std::move(request),
                   .warnings = {}};
  task.warnings = task.data.warnings;
  const auto measures = task.measures();
  if (std::ranges::find(measures, task.request.sort.word, &MeasureInfo::word) == measures.end()) {
    const bool wants_inertia = task.request.sort.group == MeasureGroup::torque;
    raise({ErrorCode::bad_argument,
           "found '" + sort + "', wanted " + (wants_inertia ? "`inertia` as well" : "angular velocities to compare with"),
           {},
           "sort"});
  }
  const auto methods = methods_of(task);
  run_interruptibly([&](const Progress& progress) { measure_all(task, methods, progress); });
  sort_by(task.request.sort, task.methods, task.data.measure_times());
  return task;
}

nb::object value_in_row(const MeasureInfo& measure, const ComparedMethod& method, const ComparedData& data) {
  if (!method.measures) return nb::none();
  const auto value = measure.value(*method.measures, data.measure_times());
  if (!value) return nb::none();
  return !measure.order.empty() ? nb::cast(static_cast<int>(*value)) : nb::cast(*value);
}

nb::list table_of(const CompareTask& task) {
  const auto measures = task.measures();
  nb::list rows;
  for (const ComparedMethod& method : task.methods) {
    const ComparedKeys& keys = task.data.key_sets[method.key_set];
    nb::dict row;
    row["method"] = method.label;
    row["keep_every"] = keys.decimation ? nb::cast(keys.decimation->keep_every) : nb::object(nb::none());
    row["keys"] = keys.track.keys.size();
    row["samples"] = keys.compared;
    for (const MeasureInfo& measure : measures) row[text(measure.id)] = value_in_row(measure, method, task.data);
    row["error"] = method.measures ? nb::object(nb::none()) : text(describe(method.measures.error()));
    rows.append(row);
  }
  return rows;
}

nb::list infos_of(const CompareTask& task) {
  nb::list infos;
  for (const MeasureInfo& measure : task.measures()) {
    nb::dict info;
    info["id"] = text(measure.id);
    info["word"] = text(measure.word);
    info["label"] = text(measure.label);
    info["unit"] = text(measure.unit);
    info["explanation"] = text(measure.explanation);
    infos.append(info);
  }
  return infos;
}

/// The text of each row's method, with the values that were tuned.
std::vector<std::string> texts_of(const CompareTask& task) {
  std::vector<std::string> texts;
  for (const ComparedMethod& method : task.methods) texts.push_back(text_of(method.candidate.method));
  return texts;
}

void write_report(const CompareTask& task, const std::string& path, const std::string& date) {
  pages::ComparedCurves curves{.methods = task.methods,
                               .recording = task.data.recording(),
                               .epoch = task.data.epoch,
                               .named = task.request.labels,
                               .measures = task.measures(),
                               .sorted_by = task.request.sort.word,
                               .inertia = task.request.inertia};
  for (const ComparedKeys& keys : task.data.key_sets)
    curves.key_sets.push_back(keys.decimation ? name_of(*keys.decimation) : "");
  write_page(path, pages::compare_page(curves, {.date = date}, task.request.threads));
}

}  // namespace

void add_compare(nb::module_& module) {
  nb::class_<CompareTask>(module, "Comparison")
      .def("rows", &table_of)
      .def("measures", &infos_of)
      .def("texts", &texts_of)
      .def("keys_of",
           [](const CompareTask& task, std::size_t row) {
             return shared(task.data.key_sets[task.methods.at(row).key_set].track);
           })
      .def_prop_ro("warnings", [](const CompareTask& task) { return warnings_of(task.warnings); })
      .def("report", &write_report, "path"_a, "date"_a);
  module.def("compare", &compared, "keys"_a, "reference"_a.none(), "reference_times"_a.none(), "decimations"_a,
             "methods"_a.none(), "tune"_a, "sort"_a, "measured"_a, "threads"_a);
}

}  // namespace orispline::python
