// SPDX-License-Identifier: Apache-2.0
#include "commands/retime/retime_report.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "commands/sample/sample_report.hpp"
#include "options/quantity.hpp"
#include "output/json_document.hpp"
#include "output/summary.hpp"

namespace orispline::cli {
namespace {

using orispline::CertifiedPeak;
using orispline::SegmentPeaks;

double duration_of(const RetimeReport& report) { return report.retiming.track.keys.times().back() - report.retiming.track.keys.times().front(); }

std::string_view word_of(orispline::Slowing slowing) {
  return slowing == orispline::Slowing::uniform ? "uniform" : "per-interval";
}

}  // namespace

std::vector<Certificate> certificates_of(const orispline::MotionLimits& limits, const std::vector<SegmentPeaks>& peaks) {
  std::vector<Certificate> certificates;
  const auto add = [&](std::string_view name, std::string_view unit, std::string_view json_unit, double scale,
                       const std::optional<double>& limit, CertifiedPeak SegmentPeaks::*member) {
    if (!limit) return;
    const auto worst = std::ranges::max_element(peaks, {}, [&](const SegmentPeaks& p) { return (p.*member).bound; });
    const CertifiedPeak& peak = (*worst).*member;
    certificates.push_back({name, unit, json_unit, *limit * scale, peak.bound * scale, peak.found * scale, peak.time,
                            static_cast<std::size_t>(worst - peaks.begin())});
  };
  add("rate", "°/s", "deg_s", degrees, limits.rate, &SegmentPeaks::rate);
  add("acceleration", "°/s²", "deg_s2", degrees, limits.acceleration, &SegmentPeaks::acceleration);
  add("torque", "N m", "nm", 1.0, limits.torque, &SegmentPeaks::torque);
  return certificates;
}

std::string text_of(const RetimeReport& report) {
  std::string text = fmt::format(
      "{} from {}, {}: {:.6g} s before, {:.6g} s after, slowed by {:.6g}{}\n",
      counted(report.retiming.track.keys.times().size(), "key"), report.input, report.retiming.method.name, report.duration_before,
      duration_of(report), report.retiming.time_scale,
      report.retiming.slowing == report.slowing ? "" : ", all intervals alike: each by itself saves no time");
  for (const Certificate& c : certificates_of(report.limits, report.retiming.peaks))
    text +=
        fmt::format("{}: nowhere above {:.6g} {} (limit {:.6g}), largest found {:.6g} at {:.6g} s after the start\n",
                    c.name, c.bound, c.unit, c.limit, c.found, c.time);
  return text + fmt::format("keys written to {}\n", destination(report.output));
}

std::string json_of(const RetimeReport& report) {
  Json json{{"input", report.input},
            {"output", report.output},
            {"method", report.retiming.method.name},
            {"slowing", word_of(report.retiming.slowing)},
            {"slowing_asked_for", word_of(report.slowing)},
            {"keys", report.retiming.track.keys.times().size()},
            {"duration_before_s", report.duration_before},
            {"duration_after_s", duration_of(report)},
            {"time_scale", report.retiming.time_scale}};
  for (const Certificate& c : certificates_of(report.limits, report.retiming.peaks)) {
    const auto name = [&c](std::string_view part) { return fmt::format("{}_{}_{}", c.name, part, c.json_unit); };
    json[name("limit")] = c.limit;
    json[name("bound")] = c.bound;
    json[name("max")] = c.found;
    json[fmt::format("{}_max_after_s", c.name)] = c.time;
    json[fmt::format("{}_bound_after_key", c.name)] = c.segment;
  }
  return document(json);
}

}  // namespace orispline::cli
