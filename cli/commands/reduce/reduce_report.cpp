// SPDX-License-Identifier: Apache-2.0
#include "commands/reduce/reduce_report.hpp"

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/fields/field_json.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/reduce/reduce_fields.hpp>
#include <orispline/smooth/smooth_fields.hpp>

#include "output/repairs_text.hpp"
#include "output/smoothing_text.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

namespace {

std::string line_of(const ReduceReport& report, const orispline::Reduction& reduction) {
  const orispline::Deviation& d = reduction.deviation;
  std::string line =
      formatted("  {:<9}{:>9}{:>9.1f}{:>14.6g}° at {} s", reduction.method.name, reduction.samples.size(),
                static_cast<double>(report.samples) / static_cast<double>(reduction.samples.size()), d.angle * degrees,
                report.times[d.angle_at].to_string());
  if (d.position) line += formatted(", {:.6g} m at {} s", *d.position, report.times[d.position_at].to_string());
  return line + "\n";
}

Places places_of(const ReduceReport& report) {
  return {report.lines, [&](std::size_t sample) { return report.times[sample]; }};
}

Json method_json(const ReduceReport& report, const orispline::Reduction& reduction) {
  Json json{{"method", reduction.method.name}};
  put(json, reduction, places_of(report), Absent::left_out);
  return json;
}

Json smoothing_json(const ReduceReport& report) {
  const auto& [smoothing, raw, raw_positions] = *report.smoothed;
  Json json;
  put(json, smoothing, {"smoothing_time", "cutoff", "criterion", "noise", "rejected"}, places_of(report));
  json["raw_error_rms_deg"] = raw.rms * degrees;
  json["raw_error_max_deg"] = raw.largest * degrees;
  json["raw_error_max_time_s"] = report.times[raw.largest_at].to_string();
  if (!raw_positions) return json;
  put(json, smoothing, {"position_smoothing_time", "position_criterion", "position_noise", "rejected_positions"},
      places_of(report));
  json["raw_position_error_rms_m"] = raw_positions->rms;
  json["raw_position_error_max_m"] = raw_positions->largest;
  json["raw_position_error_max_time_s"] = report.times[raw_positions->largest_at].to_string();
  return json;
}

std::string smoothed_lines(const ReduceReport& report) {
  const auto& [smoothing, raw, raw_positions] = *report.smoothed;
  const auto rejected_line = [&report](const std::vector<std::size_t>& rejected) {
    return formatted("  rejected        {}{}\n", rejected.size(), places_text(rejected, report.lines, report.times));
  };
  std::string text = "  " + choice_line(smoothing) + rejected_line(smoothing.rejected) +
                     formatted("  raw samples     {:.6g}° RMS from the keys' curve, {:.6g}° at most, at {} s\n",
                               raw.rms * degrees, raw.largest * degrees, report.times[raw.largest_at].to_string());
  if (!raw_positions) return text;
  return text + "  " + position_choice_line(smoothing) + rejected_line(smoothing.positions->rejected) +
         formatted("  raw positions   {:.6g} m RMS from the keys' path, {:.6g} m at most, at {} s\n",
                   raw_positions->rms, raw_positions->largest, report.times[raw_positions->largest_at].to_string());
}

}  // namespace

std::string text_of(const ReduceReport& report) {
  const orispline::Reduction& chosen = report.reductions[report.chosen];
  std::string text = formatted("{} from {}, tolerance {:.6g}°", counted(report.samples, "sample"),
                               printable(report.input), report.options.tolerance.angle * degrees);
  if (report.options.tolerance.bounds_positions())
    text += formatted(" and {:.6g} m", report.options.tolerance.position);
  text += "\n";
  if (const std::string repairs = text_of(report.repairs); !repairs.empty()) text += repairs + "\n";
  text += "  method        keys    ratio  largest error, at every sample\n";
  for (const orispline::Reduction& reduction : report.reductions) text += line_of(report, reduction);
  if (report.smoothed) text += smoothed_lines(report);
  return text + formatted("{} written to {}; they are for --method {}\n", counted(chosen.samples.size(), "key"),
                          destination(report.output), chosen.method.name);
}

std::string line_of(const ReduceReport& report) {
  const orispline::Reduction& chosen = report.reductions[report.chosen];
  std::string text = formatted("{}: {} of {} from {}, {:.6g}° off at most", printable(report.output),
                               counted(chosen.samples.size(), "key"), chosen.method.name,
                               counted(report.samples, "sample"), chosen.deviation.angle * degrees);
  if (chosen.deviation.position) text += formatted(", {:.6g} m", *chosen.deviation.position);
  if (report.smoothed)
    text += formatted("; smoothed with {:.4g} s, {} rejected, {:.6g}° RMS from the raw samples",
                      report.smoothed->smoothing.smoothing_time, report.smoothed->smoothing.rejected.size(),
                      report.smoothed->raw.rms * degrees);
  text += clauses_of(report.repairs);
  return text;
}

Json json_of(const ReduceReport& report) {
  const orispline::Reduction& chosen = report.reductions[report.chosen];
  const orispline::Tolerance& tolerance = report.options.tolerance;
  Json json{{"input", report.input},
            {"output", report.output},
            {"samples", report.samples},
            {"tolerance_deg", tolerance.angle * degrees}};
  if (tolerance.bounds_positions()) json["position_tolerance_m"] = tolerance.position;
  json["refitted"] = report.options.values == orispline::KeyValues::refitted;
  json.update(method_json(report, chosen));
  Json methods = Json::array();
  for (const orispline::Reduction& reduction : report.reductions) methods.push_back(method_json(report, reduction));
  json["methods"] = std::move(methods);
  if (report.smoothed) json["smoothing"] = smoothing_json(report);
  return json;
}

}  // namespace orispline::cli
