// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/compare.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

#include <orispline/analysis/comparison.hpp>
#include <orispline/analysis/decimation.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/curve/value_counts.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/jobs/tune.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

/// The method with the tensions that make ∫|α|² least, or with the reason why there are none.
ComparedMethod tuned(ComparedMethod method, const Track& keys, const Progress& progress) {
  method.label += ":tuned";
  auto tuning = orispline::tune(keys, method.candidate.method, {}, {.stop = progress.stop});
  if (tuning) method.candidate.method = std::move(tuning->method);
  else method.measures = tl::unexpected(keys.located(std::move(tuning.error())));
  return method;
}

Expected<std::vector<ComparedMethod>> methods_to_compare(const CompareRequest& request, const ComparedData& data,
                                                         const Progress& progress) {
  std::vector<ComparedMethod> methods;
  for (std::size_t i = 0; i < data.key_sets.size(); ++i)
    for (const LabelledMethod& stated : request.methods) {
      const Track& keys = data.key_sets[i].track;
      const FamilyInfo& family = family_of(stated.method);
      methods.push_back({.label = stated.label,
                         .key_set = i,
                         .candidate = {completed(stated.method, family, keys), keys.keys, data.key_sets[i].stretches}});
      if (request.tune && has_tensions(family)) methods.push_back(tuned(methods.back(), keys, progress));
      if (progress.stopped()) return cancellation();
    }
  return methods;
}

/// Settings with a value for each key want as many as there are, which is what was kept of a recording.
Expected<void> check_counts(const CompareRequest& request, const ComparedData& data) {
  for (const ComparedKeys& keys : data.key_sets)
    for (const LabelledMethod& stated : request.methods) {
      const std::size_t count = keys.track.keys.size();
      auto fits = check_value_counts(family_of(stated.method), stated.method.options, count);
      if (fits) continue;
      if (keys.decimation)
        fits.error().message += formatted("; `keep_every` {} keeps {} of the {} samples", keys.decimation->keep_every,
                                          count, data.samples.size());
      return fits;
    }
  return {};
}

void measure_all(CompareOutcome& outcome, const Progress& progress) {
  std::vector<Candidate> candidates;
  for (const ComparedMethod& method : outcome.methods) candidates.push_back(method.candidate);
  Comparison comparison = orispline::compare(candidates, outcome.data.recording(), outcome.request.measured,
                                             outcome.request.threads, progress);
  std::ranges::move(comparison.warnings, std::back_inserter(outcome.warnings));
  for (std::size_t i = 0; i < outcome.methods.size(); ++i) {
    ComparedMethod& method = outcome.methods[i];
    if (!method.measures) continue;  // it could not be tuned
    method.measures = std::move(comparison.measures[i]).map_error([&](Error error) {
      return outcome.data.key_sets[method.key_set].track.located(std::move(error));
    });
  }
}

Expected<ComparedData> data_of(const CompareRequest& request) {
  return request.reference ? beside_recording(*request.keys, *request.reference)
                           : beside_own_samples(*request.keys, request.decimations);
}

/// The keys where they lie beside the reference.
Expected<std::optional<AlignOutcome>> alignment_in(const CompareRequest& request, const Progress& progress) {
  if (!request.align) return std::nullopt;
  if (!request.reference)
    return bad_option("align", "found no recording to align the keys with, wanted `reference` as well");
  return align({.moved = request.keys, .fixed = request.reference}, {.stop = progress.stop})
      .map([](AlignOutcome outcome) { return std::optional(std::move(outcome)); });
}

Expected<MeasureInfo> measure_to_sort_by(const CompareOutcome& outcome) {
  const auto measures = outcome.measures();
  const auto measure = std::ranges::find(measures, outcome.request.sort, &MeasureInfo::word);
  if (measure != measures.end()) return *measure;
  const std::string& recording = outcome.data.reference;
  return bad_option("sort", formatted("found '{}', wanted angular velocities {}", outcome.request.sort,
                                      recording.empty() ? std::string("to compare with")
                                                        : formatted("as columns wx,wy,wz in {}", recording)));
}

}  // namespace

std::vector<LabelledMethod> all_methods() {
  std::vector<LabelledMethod> methods;
  for (const FamilyInfo& family : families_info()) methods.push_back({std::string(family.name), family.name});
  return methods;
}

Expected<void> check(const CompareRequest& request) {
  if (auto sound = orispline::check(request.measured); !sound) return sound;
  return measure_of_word(request.sort).and_then([&](const MeasureInfo& measure) -> Expected<void> {
    if (measure.group != MeasureGroup::torque || request.has_inertia) return {};
    return bad_option("sort", formatted("found '{}', wanted `inertia` as well", request.sort));
  });
}

std::vector<MeasureInfo> CompareOutcome::measures() const {
  return data.measures(request.measured.leave_out, request.inertia());
}

std::optional<double> CompareOutcome::value(const MeasureInfo& measure, const ComparedMethod& method) const {
  if (!method.measures) return std::nullopt;
  return measure.value(*method.measures, data.measure_times());
}

Expected<CompareOutcome> compare(CompareRequest request, const Progress& progress) {
  if (auto checked = check(request); !checked) return tl::unexpected(std::move(checked.error()));
  if (request.tune)
    if (auto whole = check_without_gaps(*request.keys); !whole) return tl::unexpected(std::move(whole.error()));
  auto alignment = alignment_in(request, progress);
  if (!alignment) return tl::unexpected(std::move(alignment.error()));
  if (*alignment) request.keys = std::make_shared<const Track>((*alignment)->aligned);
  auto data = data_of(request);
  if (!data) return tl::unexpected(std::move(data.error()));
  CompareOutcome outcome{.request = std::move(request), .alignment = std::move(*alignment), .data = std::move(*data)};
  if (outcome.alignment) outcome.warnings = outcome.alignment->warnings;
  std::ranges::move(std::exchange(outcome.data.warnings, {}), std::back_inserter(outcome.warnings));
  const auto sorted_by = measure_to_sort_by(outcome);
  if (!sorted_by) return tl::unexpected(sorted_by.error());
  if (auto fits = check_counts(outcome.request, outcome.data); !fits) return tl::unexpected(std::move(fits.error()));
  auto methods = methods_to_compare(outcome.request, outcome.data, progress);
  if (!methods) return tl::unexpected(std::move(methods.error()));
  outcome.methods = std::move(*methods);
  measure_all(outcome, progress);
  if (progress.stopped()) return cancellation();
  sort_by(*sorted_by, outcome.methods, outcome.data.measure_times());
  return outcome;
}

}}}  // namespace orispline::jobs
