// SPDX-License-Identifier: Apache-2.0
#include "commands/retime/retime_report.hpp"

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/retime/certificate.hpp>
#include <orispline/retime/retime_fields.hpp>

#include "output/field_json.hpp"
#include "output/summary.hpp"

namespace orispline::cli {
namespace {

double duration_of(const RetimeReport& report) {
  return report.retiming.track.keys.times().back() - report.retiming.track.keys.times().front();
}

}  // namespace

std::string text_of(const RetimeReport& report) {
  std::string text =
      formatted("{} from {}, {}: {:.6g} s before, {:.6g} s after, slowed by {:.6g}{}\n",
                counted(report.retiming.track.keys.times().size(), "key"), printable(report.input),
                report.retiming.method.name, report.duration_before, duration_of(report), report.retiming.time_scale,
                report.retiming.slowing == report.slowing ? "" : ", all intervals alike: each by itself saves no time");
  for (const Certificate& c : certificates_of(report.limits, report.retiming.peaks))
    text += formatted("{}: nowhere above {:.6g} {} (limit {:.6g}), largest found {:.6g} at {:.6g} s after the start\n",
                      c.name, c.bound, c.unit, c.limit, c.found, c.time);
  return text + formatted("keys written to {}\n", destination(report.output));
}

std::string json_of(const RetimeReport& report) {
  Json json{{"input", report.input}, {"output", report.output}, {"method", report.retiming.method.name}};
  put(json, report.retiming, {"slowing"});
  json["slowing_asked_for"] = word_of(report.slowing);
  put(json, report.retiming, {"keys"});
  json["duration_before_s"] = report.duration_before;
  put(json, report.retiming, {"duration_after", "time_scale", "slack"});
  for (const Certificate& c : certificates_of(report.limits, report.retiming.peaks)) {
    json[c.id_of("limit")] = c.limit;
    json[c.id_of("bound")] = c.bound;
    json[c.id_of("max")] = c.found;
    json[formatted("{}_max_after_s", c.name)] = c.time;
    json[formatted("{}_bound_after_key", c.name)] = c.segment;
  }
  return document(json);
}

}  // namespace orispline::cli
