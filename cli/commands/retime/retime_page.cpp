// SPDX-License-Identifier: Apache-2.0
#include "commands/retime/retime_page.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <orispline/families/registry.hpp>

#include "output/report_page.hpp"

namespace orispline::cli {
namespace {

using orispline::SegmentPeaks;
using report::Better;

/// Of the motion before it was slowed; nothing where it has none.
std::vector<SegmentPeaks> peaks_of(const AnyCurve& curve, const orispline::MotionLimits& limits) {
  const auto floor = [](const std::optional<double>& limit) {
    return limit ? 0.0 : std::numeric_limits<double>::infinity();
  };
  return orispline::certified_peaks(curve, limits.inertia,
                                   {floor(limits.rate), floor(limits.acceleration), floor(limits.torque)})
      .value_or(std::vector<SegmentPeaks>());
}

std::string id_of(const Certificate& c, std::string_view part) {
  return fmt::format("{}_{}_{}", c.name, part, c.json_unit);
}

std::vector<report::PageColumn> columns_of(const CurvePage& curves, const std::vector<Certificate>& certificates) {
  std::vector<report::PageColumn> columns{
      {"duration_s", "duration", "s", "From the first to the last key", Better::neither}};
  for (const Certificate& c : certificates) {
    const std::string name(c.name), unit(c.unit);
    columns.push_back(
        {id_of(c, "bound"), name + " at most", unit,
         fmt::format("Certified: nowhere on the curve is the {} larger; the limit is {:.6g}", name, c.limit),
         Better::less});
    columns.push_back({id_of(c, "max"), name + " found", unit, "A value that the curve takes", Better::less});
  }
  std::ranges::move(columns_of(curves.figures), std::back_inserter(columns));
  return columns;
}

std::string title_of(const RetimeReport& report, const std::vector<Certificate>& certificates) {
  std::vector<std::string> limits;
  for (const Certificate& c : certificates) limits.push_back(fmt::format("{:.6g} {}", c.limit, c.unit));
  return fmt::format("{} within {}, {}: slowed {} by {:.6g}", report.input, fmt::join(limits, " and "), report.retiming.method.name,
                     report.retiming.slowing == orispline::Slowing::uniform ? "uniformly" : "per interval",
                     report.retiming.time_scale);
}

std::map<std::string, double, std::less<>> limits_of(const orispline::MotionLimits& limits) {
  std::map<std::string, double, std::less<>> lines;
  if (limits.rate) lines["w"] = *limits.rate;
  if (limits.acceleration) lines["a"] = *limits.acceleration;
  if (limits.torque) lines["torque"] = *limits.torque;
  return lines;
}

/// The method's curve through the keys; its certificates are `peaks`, or sought where there are none.
report::PageMethod method_of(const CurvePage& curves, const RetimeReport& report, std::string name,
                             const Keyframes& keys, std::vector<SegmentPeaks> peaks) {
  const Method& shown = report.retiming.method;
  auto curve = make_pose_curve(shown, keys);
  auto measures = measure({.method = shown, .keys = keys}, {keys.times(), keys.orientations()},
                          {.inertia = curves.inertia.value_or(Eigen::Matrix3d::Identity())});
  if (!curve || !measures)
    return {.name = std::move(name), .failure = describe(curve ? measures.error() : curve.error())};
  if (peaks.empty()) peaks = peaks_of(curve->orientation, report.limits);
  report::PageMethod method = method_of(curves, {std::move(name), keys, *curve, *measures});
  method.measures["duration_s"] = keys.times().back() - keys.times().front();
  for (const Certificate& c : certificates_of(report.limits, peaks)) {
    method.measures[id_of(c, "bound")] = c.bound;
    method.measures[id_of(c, "max")] = c.found;
  }
  return method;
}

}  // namespace

report::Page page_of(const RetimeReport& report, const Track& before, const ReportOptions& options) {
  CurvePage curves{
      .data = compared_with(report.input, before.epoch, before.keys), .figures = shape_figures(), .inertia = report.limits.inertia};
  if (curves.inertia) std::ranges::move(torque_figures(), std::back_inserter(curves.figures));
  const auto certificates = certificates_of(report.limits, report.retiming.peaks);
  report::Page page = begun_page(title_of(report, certificates), options, before.epoch, before.keys);
  page.limits = limits_of(report.limits);
  page.columns = columns_of(curves, certificates);
  page.methods.push_back(method_of(curves, report, "after", report.retiming.track.keys, report.retiming.peaks));
  page.methods.push_back(method_of(curves, report, "before", before.keys, {}));
  return page;
}

}  // namespace orispline::cli
