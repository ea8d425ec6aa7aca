// SPDX-License-Identifier: Apache-2.0
#include <orispline/pages/task_pages.hpp>

#include <algorithm>
#include <iterator>

#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/pages/curve_page.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

namespace {

std::string title_of(const Track& recording, const std::string& method, const Reduction& chosen,
                     const Tolerance& allowed) {
  std::string tolerance = formatted("{:.6g}°", allowed.angle * degrees);
  if (allowed.bounds_positions()) tolerance += formatted(" and {:.6g} m", allowed.position);
  return formatted("{} within {}: {} keys of {} for {} samples", file_name_of(recording.name), tolerance,
                   chosen.samples.size(), method, recording.keys.size());
}

std::vector<report::PageColumn> columns_of(const CurvePage& page) {
  std::vector<report::PageColumn> columns{
      {"keys", "keys", "", "Number of keys that are kept", Better::less},
      {"samples_per_key", "samples per key", "", "Number of samples for each key", Better::more}};
  if (!page.recording.positions().empty())
    columns.push_back({"position_error_max_m", "max", "m", "Largest distance to the recording", Better::less});
  std::ranges::move(measure_columns(page.measures), std::back_inserter(columns));
  return columns;
}

report::PageMethod method_of(const CurvePage& page, const std::string& name, const Reduction& reduction,
                             const report::Covers& covers) {
  const Candidate candidate{.method = reduction.method, .keys = reduction.track.keys, .stretches = reduction.stretches};
  auto curve = curve_of(reduction);
  auto measures = measure(candidate, page.recorded());
  if (!curve || !measures) return {.name = name, .failure = describe(curve ? measures.error() : curve.error())};
  report::PageMethod method = with_errors(method_of(page, {name, reduction.track.keys, *curve, *measures}),
                                          errors_at(*curve, path_of(page.recording)), covers);
  const auto keys = static_cast<double>(reduction.samples.size());
  method.measures["keys"] = keys;
  method.measures["samples_per_key"] = static_cast<double>(page.recording.size()) / keys;
  method.measures["max_deg"] = reduction.deviation.angle * degrees;  // as it is certified
  if (reduction.deviation.position) method.measures["position_error_max_m"] = *reduction.deviation.position;
  return method;
}

}  // namespace

report::Page reduce_page(const Track& recording, std::span<const Reduction> reductions, const ReduceOptions& options,
                         const PageHead& head, std::optional<double> smoothing_time) {
  const std::size_t smallest = orispline::smallest(reductions);
  const auto labels = labels_of(reductions);
  const Reduction& chosen = reductions[smallest];
  const CurvePage curves{.recording = recording.keys,
                         .measures = measures_of({MeasureGroup::distance, MeasureGroup::shape})};
  report::Page page = begun_page(title_of(recording, labels[smallest], chosen, options.tolerance), head,
                                 recording.epoch, chosen.track.keys);
  if (smoothing_time)
    page.notes.push_back(formatted(
        "The recording is shown as it is after smoothing, with a smoothing time of {:.4g} s.", *smoothing_time));
  std::ranges::move(notes_on_samples(recording.keys.size()), std::back_inserter(page.notes));
  const report::Covers covers = covers_of(recording.keys.times(), recording.recipe.gap);
  page.reference = report::with_gaps(report::thinned(path_of(recording.keys), samples_of_few), covers);
  page.limits["error"] = options.tolerance.angle * degrees;
  page.columns = columns_of(curves);
  for (std::size_t i = 0; i < reductions.size(); ++i)
    page.methods.push_back(method_of(curves, labels[i], reductions[i], covers));
  const auto first = page.methods.begin() + static_cast<std::ptrdiff_t>(smallest);
  std::rotate(page.methods.begin(), first, first + 1);
  return page;
}

}}}  // namespace orispline::pages
