// SPDX-License-Identifier: Apache-2.0
#include "commands/retime/retime_report.hpp"

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/retime/retime.hpp>
#include <orispline/retime/retime_fields.hpp>

#include "output/field_json.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

namespace {

double duration_of(const RetimeReport& report) {
  return report.retiming.track.keys.times().back() - report.retiming.track.keys.times().front();
}

std::string scale_text(double scale) {
  return scale < 1.0 ? formatted("faster by {:.6g}", 1.0 / scale) : formatted("slowed by {:.6g}", scale);
}

std::string rests_line(const orispline::Retiming& retiming) {
  if (retiming.rests.empty()) return "";
  const auto t = retiming.track.keys.times();
  double rested = 0.0;
  for (const std::size_t i : retiming.rests) rested += t[i + 1] - t[i];
  return formatted("{} between equal keys, {:.6g} s in all\n", counted(retiming.rests.size(), "rest"), rested);
}

}  // namespace

std::string text_of(const RetimeReport& report) {
  std::string text =
      formatted("{} from {}, {}: {:.6g} s before, {:.6g} s after, {}{}\n",
                counted(report.retiming.track.keys.times().size(), "key"), printable(report.input),
                orispline::text_of(report.retiming.method), report.duration_before, duration_of(report),
                scale_text(report.retiming.time_scale),
                report.retiming.slowing == report.slowing ? "" : ", all intervals alike: each by itself saves no time");
  for (const Certificate& c : certificates_of(report.limits, report.retiming.peaks))
    text += formatted("{}: nowhere above {} (limit {:.6g}), largest found {:.6g} at {:.6g} s after the start\n", c.name,
                      c.text_of(c.bound), c.limit / c.shown.size, c.found / c.shown.size, c.time);
  text += rests_line(report.retiming);
  return text + formatted("keys written to {}\n", destination(report.output));
}

std::string line_of(const RetimeReport& report) {
  return formatted("{}: {} for {}, {:.6g} s before, {:.6g} s after, {}", printable(report.output),
                   counted(report.retiming.track.keys.times().size(), "key"),
                   orispline::text_of(report.retiming.method), report.duration_before, duration_of(report),
                   scale_text(report.retiming.time_scale));
}

Json json_of(const RetimeReport& report) {
  Json json{{"input", report.input}, {"output", report.output}, {"method", report.retiming.method.name}};
  put(json, report.retiming, {"slowing"});
  json["slowing_asked_for"] = word_of(report.slowing);
  put(json, report.retiming, {"keys"});
  json["duration_before_s"] = report.duration_before;
  put(json, report.retiming, {"duration_after", "time_scale", "rests", "slack"});
  for (const Certificate& c : certificates_of(report.limits, report.retiming.peaks)) {
    json[c.id_of("limit")] = c.limit / c.in_ids.size;
    json[c.id_of("bound")] = c.bound / c.in_ids.size;
    json[c.id_of("max")] = c.found / c.in_ids.size;
    json[formatted("{}_max_after_s", c.id)] = c.time;
    json[formatted("{}_bound_after_key", c.id)] = c.segment;
  }
  return json;
}

}  // namespace orispline::cli
