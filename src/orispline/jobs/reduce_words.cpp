// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <tuple>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/fields/field_json.hpp>
#include <orispline/jobs/reduce.hpp>
#include <orispline/jobs/smoothing_words.hpp>
#include <orispline/jobs/words.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <orispline/reduce/reduce.hpp>
#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

std::string seconds_text(const ReduceOutcome& outcome, std::size_t sample) {
  return outcome.recording->time_of(sample).to_string();
}

std::string time_text(const ReduceOutcome& outcome, std::size_t sample) {
  return outcome.recording->time_text(outcome.recording->time_of(sample));
}

/// A row of the table, whose first column is so wide.
std::string row_of(const ReduceOutcome& outcome, const std::string& label, std::size_t width,
                   const Reduction& reduction) {
  const Deviation& d = reduction.deviation;
  const std::size_t samples = outcome.recording->keys.size(), keys = reduction.samples.size();
  std::string line = formatted("  {:<{}}{:>9}{:>9.1f}{:>14.6g}° at {}", label, width, keys,
                               static_cast<double>(samples) / static_cast<double>(keys), d.angle * degrees,
                               time_text(outcome, d.angle_at));
  if (d.position) line += formatted(", {:.6g} m at {}", *d.position, time_text(outcome, d.position_at));
  return line + "\n";
}

std::string table_of(const ReduceOutcome& outcome) {
  const auto labels = labels_of(outcome.reductions);
  std::size_t width = 9;
  for (const std::string& label : labels) width = std::max(width, label.size());
  std::string table =
      formatted("  {:<{}}{:>9}{:>9}  largest error, at every sample\n", "method", width, "keys", "ratio");
  for (std::size_t i = 0; i < labels.size(); ++i) table += row_of(outcome, labels[i], width, outcome.reductions[i]);
  return table;
}

Json method_json(const ReduceOutcome& outcome, const std::string& label, const Reduction& reduction) {
  Json json{{"method", label}};
  put(json, reduction, places_of(*outcome.recording), Absent::left_out);
  return json;
}

Json smoothed_json(const ReduceOutcome& outcome) {
  const SmoothedFirst& smoothed = *outcome.smoothed;
  const auto& [smoothing, raw, raw_positions] = std::tie(smoothed.smoothing, smoothed.raw, smoothed.raw_positions);
  const Places places = places_of(*outcome.recording);
  Json json;
  put(json, smoothing, {"smoothing_time", "cutoff", "criterion", "noise", "rejected"}, places);
  json["raw_error_rms_deg"] = raw.rms * degrees;
  json["raw_error_max_deg"] = raw.largest * degrees;
  json["raw_error_max_time_s"] = seconds_text(outcome, raw.largest_at);
  if (!raw_positions) return json;
  put(json, smoothing, {"position_smoothing_time", "position_criterion", "position_noise", "rejected_positions"},
      places);
  json["raw_position_error_rms_m"] = raw_positions->rms;
  json["raw_position_error_max_m"] = raw_positions->largest;
  json["raw_position_error_max_time_s"] = seconds_text(outcome, raw_positions->largest_at);
  return json;
}

std::string smoothed_lines(const ReduceOutcome& outcome) {
  const SmoothedFirst& smoothed = *outcome.smoothed;
  const auto& [smoothing, raw, raw_positions] = std::tie(smoothed.smoothing, smoothed.raw, smoothed.raw_positions);
  const auto rejected_line = [&](const std::vector<std::size_t>& rejected) {
    return formatted("  rejected        {}{}\n", rejected.size(), places_text(rejected, *outcome.recording));
  };
  std::string text = "  " + choice_line(smoothing) + rejected_line(smoothing.rejected) +
                     formatted("  raw samples     {:.6g}° RMS from the keys' curve, {:.6g}° at most, at {}\n",
                               raw.rms * degrees, raw.largest * degrees, time_text(outcome, raw.largest_at));
  if (!raw_positions) return text;
  return text + "  " + position_choice_line(smoothing) + rejected_line(smoothing.positions->rejected) +
         formatted("  raw positions   {:.6g} m RMS from the keys' path, {:.6g} m at most, at {}\n", raw_positions->rms,
                   raw_positions->largest, time_text(outcome, raw_positions->largest_at));
}

}  // namespace

Json document_of(const ReduceOutcome& outcome) {
  const Tolerance& tolerance = outcome.options.tolerance;
  Json json{{"samples", outcome.recording->keys.size()}, {"tolerance_deg", tolerance.angle * degrees}};
  if (tolerance.bounds_positions()) json["position_tolerance_m"] = tolerance.position;
  json["refitted"] = outcome.options.values == KeyValues::refitted;
  const auto labels = labels_of(outcome.reductions);
  json.update(method_json(outcome, labels[smallest(outcome.reductions)], outcome.chosen()));
  Json methods = Json::array();
  for (std::size_t i = 0; i < labels.size(); ++i)
    methods.push_back(method_json(outcome, labels[i], outcome.reductions[i]));
  json["methods"] = std::move(methods);
  if (outcome.smoothed) json["smoothing"] = smoothed_json(outcome);
  return json;
}

std::string summary_of(const ReduceOutcome& outcome) {
  const Tolerance& tolerance = outcome.options.tolerance;
  std::string text =
      formatted("{}, tolerance {:.6g}°", keys_text(*outcome.recording, "sample"), tolerance.angle * degrees);
  if (tolerance.bounds_positions()) text += formatted(" and {:.6g} m", tolerance.position);
  text += "\n";
  if (!outcome.mended.empty()) text += outcome.mended + "\n";
  text += table_of(outcome);
  return outcome.smoothed ? text + smoothed_lines(outcome) : text;
}

std::string line_of(const ReduceOutcome& outcome) {
  const Reduction& chosen = outcome.chosen();
  std::string text = formatted("{} of {} from {}, {:.6g}° off at most", counted(chosen.samples.size(), "key"),
                               labels_of(outcome.reductions)[smallest(outcome.reductions)],
                               counted(outcome.recording->keys.size(), "sample"), chosen.deviation.angle * degrees);
  if (chosen.deviation.position) text += formatted(", {:.6g} m", *chosen.deviation.position);
  if (const auto& smoothed = outcome.smoothed)
    text +=
        formatted("; smoothed with {:.4g} s, {} rejected, {:.6g}° RMS from the raw samples",
                  smoothed->smoothing.smoothing_time, smoothed->smoothing.rejected.size(), smoothed->raw.rms * degrees);
  return outcome.mended.empty() ? text : formatted("{}; {}", text, outcome.mended);
}

}}}  // namespace orispline::jobs
