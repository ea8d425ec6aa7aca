// SPDX-License-Identifier: Apache-2.0
#include "reduce_report.hpp"

#include <numbers>

#include <fmt/format.h>

#include <orispline/io/output_file.hpp>

#include "json.hpp"
#include "json_document.hpp"
#include "sample_report.hpp"

namespace orispline::cli {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

std::string line_of(const ReduceReport& report, const optimise::Reduction& reduction) {
  const optimise::Deviation& d = reduction.deviation;
  std::string line = fmt::format("  {:<9}{:>9}{:>9.1f}{:>14.6g}° at {} s", reduction.method, reduction.samples.size(),
                                 static_cast<double>(report.samples) / static_cast<double>(reduction.samples.size()),
                                 d.angle * degrees, report.times[d.angle_at].to_string());
  if (d.position) line += fmt::format(", {:.6g} m at {} s", *d.position, report.times[d.position_at].to_string());
  return line + "\n";
}

Json method_json(const ReduceReport& report, const optimise::Reduction& reduction) {
  const optimise::Deviation& d = reduction.deviation;
  Json json{{"method", reduction.method},
            {"keys", reduction.samples.size()},
            {"error_max_deg", d.angle * degrees},
            {"error_max_time_s", report.times[d.angle_at].to_string()}};
  if (!d.position) return json;
  json["position_error_max_m"] = *d.position;
  json["position_error_max_time_s"] = report.times[d.position_at].to_string();
  return json;
}

}  // namespace

std::string text_of(const ReduceReport& report) {
  const optimise::Reduction& chosen = report.reductions[report.chosen];
  std::string text = fmt::format("{} from {}, tolerance {:.6g}°", counted(report.samples, "sample"), report.input,
                                 report.options.tolerance.angle * degrees);
  if (report.options.tolerance.position < std::numeric_limits<double>::infinity())
    text += fmt::format(" and {:.6g} m", report.options.tolerance.position);
  text += "\n";
  if (const std::string repairs = text_of(report.repairs); !repairs.empty()) text += repairs + "\n";
  text += "  method        keys    ratio  largest error, at every sample\n";
  for (const optimise::Reduction& reduction : report.reductions) text += line_of(report, reduction);
  return text + fmt::format("{} of {} written to {}\n", counted(chosen.samples.size(), "key"), chosen.method,
                            report.output == io::standard_stream ? "standard output" : report.output);
}

std::string json_of(const ReduceReport& report) {
  const optimise::Reduction& chosen = report.reductions[report.chosen];
  const optimise::Tolerance& tolerance = report.options.tolerance;
  Json json{{"input", report.input},
            {"output", report.output},
            {"samples", report.samples},
            {"tolerance_deg", tolerance.angle * degrees}};
  if (tolerance.position < std::numeric_limits<double>::infinity()) json["position_tolerance_m"] = tolerance.position;
  json["refitted"] = report.options.values == optimise::KeyValues::refitted;
  json.update(method_json(report, chosen));
  Json& methods = json["methods"] = Json::array();
  for (const optimise::Reduction& reduction : report.reductions) methods.push_back(method_json(report, reduction));
  return document(json);
}

}  // namespace orispline::cli
