// SPDX-License-Identifier: Apache-2.0
#include "commands/reduce/reduce_page.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include <orispline/families/registry.hpp>

#include "options/quantity.hpp"
#include "output/report_page.hpp"

namespace orispline::cli {
namespace {

using orispline::Reduction;
using report::Better;

std::string title_of(const ReduceReport& report) {
  const Reduction& chosen = report.reductions[report.chosen];
  std::string tolerance = fmt::format("{:.6g}°", report.options.tolerance.angle * degrees);
  if (report.options.tolerance.bounds_positions())
    tolerance += fmt::format(" and {:.6g} m", report.options.tolerance.position);
  return fmt::format("{} within {}: {} keys of {} for {} samples", report.input, tolerance, chosen.samples.size(),
                     chosen.method.name, report.samples);
}

std::vector<report::PageColumn> columns_of(const CurvePage& page, bool positions) {
  std::vector<report::PageColumn> columns{
      {"keys", "keys", "", "Keys that are left", Better::less},
      {"samples_per_key", "samples per key", "", "Samples for each key", Better::more}};
  if (positions)
    columns.push_back({"position_error_max_m", "max", "m", "Largest distance to the recording", Better::less});
  std::ranges::move(columns_of(page.figures), std::back_inserter(columns));
  return columns;
}

report::PageMethod method_of(const CurvePage& page, const Reduction& reduction) {
  const Candidate candidate{.method = reduction.method, .keys = reduction.track.keys};
  const std::string& name = reduction.method.name;
  auto curve = make_pose_curve(reduction.method, reduction.track.keys);
  auto measures = measure(candidate, page.data.recording());
  if (!curve || !measures)
    return {.name = name, .failure = describe(curve ? measures.error() : curve.error())};
  report::PageMethod method = with_errors(method_of(page, {name, reduction.track.keys, *curve, *measures}),
                                          errors_at(*curve, path_of(page.data.times, page.data.samples.orientations())),
                                          [](double) { return true; });
  const auto keys = static_cast<double>(reduction.samples.size());
  method.measures["keys"] = keys;
  method.measures["samples_per_key"] = static_cast<double>(page.data.times.size()) / keys;
  method.measures["max_deg"] = reduction.deviation.angle * degrees;  // as it is certified
  if (reduction.deviation.position) method.measures["position_error_max_m"] = *reduction.deviation.position;
  return method;
}

}  // namespace

report::Page page_of(const ReduceReport& report, const Track& track, const ReportOptions& options) {
  const Keyframes& recording = track.keys;
  CurvePage curves{.data = compared_with(report.input, track.epoch, recording)};
  curves.figures = distance_figures();
  std::ranges::move(shape_figures(), std::back_inserter(curves.figures));
  report::Page page = begun_page(title_of(report), options, track.epoch, report.reductions[report.chosen].track.keys);
  if (report.smoothed)
    page.notes.push_back(fmt::format("The recording was smoothed first, smoothing time {:.4g} s, and is shown so.",
                                     report.smoothed->smoothing.smoothing_time));
  std::ranges::move(notes_on_samples(report.samples), std::back_inserter(page.notes));
  page.reference = report::thinned(path_of(recording.times(), recording.orientations()), samples_of_few);
  page.limits["error"] = report.options.tolerance.angle * degrees;
  page.columns = columns_of(curves, !recording.positions().empty());
  for (const Reduction& reduction : report.reductions) page.methods.push_back(method_of(curves, reduction));
  const auto chosen = page.methods.begin() + static_cast<std::ptrdiff_t>(report.chosen);
  std::rotate(page.methods.begin(), chosen, chosen + 1);
  return page;
}

}  // namespace orispline::cli
