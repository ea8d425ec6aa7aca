// SPDX-License-Identifier: Apache-2.0
#include <orispline/pages/task_pages.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>

#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/pages/curve_page.hpp>
#include <orispline/pages/way_clock.hpp>
#include <orispline/retime/rate_bounds.hpp>
#include <orispline/retime/retime.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

namespace {

/// Of the motion before it was slowed; nothing where it has none.
std::vector<SegmentPeaks> peaks_of(const PoseCurve& curve, const MotionLimits& limits) {
  const auto quantities = quantities_of(limits);
  return certified_peaks(curve, {quantities, limits.inertia}, {}).value_or(std::vector<SegmentPeaks>());
}

std::vector<report::PageColumn> columns_of(const CurvePage& curves, const std::vector<Certificate>& certificates) {
  std::vector<report::PageColumn> columns{
      {"duration_s", "duration", "s", "Time from the first to the last key", Better::neither}};
  for (const Certificate& c : certificates) {
    const std::string unit(c.shown.name);
    columns.push_back(
        {c.id_of("bound"), c.name + " at most", unit,
         formatted("The {} is certified to be nowhere larger; the limit is {}", c.name, c.text_of(c.limit)),
         Better::less});
    columns.push_back(
        {c.id_of("max"), c.name + " found", unit, "Largest value that was found on the curve", Better::less});
  }
  std::ranges::move(measure_columns(curves.measures), std::back_inserter(columns));
  return columns;
}

std::string title_of(const Track& before, const Retiming& retiming, const std::vector<Certificate>& certificates) {
  std::vector<std::string> limits;
  for (std::size_t i = 0; i < certificates.size();) {
    const Certificate& first = certificates[i];
    const std::size_t axes = first.id.ends_with("_x") ? 3 : 1;
    std::vector<std::string> numbers;
    for (std::size_t axis = 0; axis < axes; ++axis, ++i)
      numbers.push_back(formatted("{:.6g}", certificates[i].limit / first.shown.size));
    limits.push_back(formatted("{} {}", joined(numbers, ", "), first.shown.name));
  }
  const std::string within = limits.empty() ? "" : formatted(" within {}", joined(limits, " and "));
  if (retiming.evenness)
    return formatted("{}: an even motion along the path of {}", file_name_of(before.name),
                     retiming.evenness->path_method.name);
  const std::string of_what = formatted("{}{}, {}", file_name_of(before.name), within, retiming.method.name);
  if (retiming.slowing == Slowing::fastest_keys)
    return formatted("{}: as fast as its limits allow, in {:.6g} times the time", of_what, retiming.time_scale);
  return formatted("{}: slowed {} by {:.6g}", of_what,
                   retiming.slowing == Slowing::uniform ? "uniformly" : "per interval", retiming.time_scale);
}

/// The limits of lengths as lines in the plots of their quantities, which are shown in the units of the certificates.
void add_limits(report::Page& page, const MotionLimits& limits, const std::vector<Certificate>& certificates) {
  const auto add = [&](std::string_view quantity, std::string_view id, const std::optional<Limit>& limit) {
    const auto certificate =
        std::ranges::find_if(certificates, [&](const Certificate& c) { return c.id.starts_with(id); });
    if (!limit || certificate == certificates.end()) return;
    if (!limit->is_per_axis()) page.limits.emplace(quantity, limit->sizes[0]);
    page.units.emplace(quantity, report::PageUnit{std::string(certificate->shown.name), certificate->shown.size});
  };
  add("w", "rate", limits.rate);
  add("a", "acceleration", limits.acceleration);
  add("j", "jerk", limits.jerk);
  add("torque", "torque", limits.torque);
}

/// What both curves have alike.
struct RetimedKeys {
  CurvePage curves;
  const MotionLimits& limits;
};

/// The method's curve through the keys; its certificates are `peaks`, or sought where there are none.
report::PageMethod method_of(const RetimedKeys& retimed, std::string name, const Method& made_by, const Keyframes& keys,
                             std::vector<SegmentPeaks> peaks) {
  auto curve = make_pose_curve(made_by, keys);
  auto measures = measure({.method = made_by, .keys = keys}, {keys.times(), keys.orientations()},
                          {.inertia = retimed.curves.inertia.value_or(Eigen::Matrix3d::Identity())});
  if (!curve || !measures)
    return {.name = std::move(name), .failure = describe(curve ? measures.error() : curve.error())};
  if (peaks.empty()) peaks = peaks_of(*curve, retimed.limits);
  report::PageMethod method = method_of(retimed.curves, {std::move(name), keys, *curve, *measures});
  method.measures["duration_s"] = keys.times().back() - keys.times().front();
  for (const Certificate& c : certificates_of(retimed.limits, peaks)) {
    method.measures[c.id_of("bound")] = c.bound / c.shown.size;
    method.measures[c.id_of("max")] = c.found / c.shown.size;
  }
  return method;
}

/// The same places of a way at other times of its keys, the keys among them.
report::PageClock at_times_of_keys(const report::PageClock& clock, std::span<const double> from,
                                   std::span<const double> to) {
  report::PageClock other;
  const auto add = [&](double time, double own) {
    other.times.push_back(time);
    other.own.push_back(own);
  };
  std::size_t key = 1;
  for (std::size_t k = 0; k < clock.own.size(); ++k) {
    const double own = clock.own[k];
    for (; key + 1 < from.size() && from[key] < own; ++key)
      if (k > 0)
        add(std::lerp(clock.times[k - 1], clock.times[k], (from[key] - clock.own[k - 1]) / (own - clock.own[k - 1])),
            to[key]);
    add(clock.times[k], std::lerp(to[key - 1], to[key], (own - from[key - 1]) / (from[key] - from[key - 1])));
  }
  return other;
}

/// The motion before is shown at the place where that after is, which may have more keys. An even motion may go along a
/// path that other times shape: there both are at the keys together.
std::optional<report::PageClock> clock_of(const Keyframes& before, const Retiming& retiming) {
  if (retiming.track.keys.size() == before.size()) return clock_of_keys(retiming.track.keys, before);
  const auto& evenness = retiming.evenness;
  const auto keys = evenness ? before.with_times(evenness->path_times) : Expected<Keyframes>(before);
  if (!keys) return std::nullopt;
  const auto after = make_pose_curve(retiming.method, retiming.track.keys),
             path = make_pose_curve(evenness ? evenness->path_method : retiming.method, *keys);
  if (!after || !path) return std::nullopt;
  return at_times_of_keys(clock_of_ways(*after, *path), keys->times(), before.times());
}

}  // namespace

report::Page retime_page(const Track& before, const Retiming& retiming, const MotionLimits& limits,
                         const PageHead& head) {
  const RetimedKeys retimed{
      .curves = {.recording = before.keys,
                 .measures = limits.inertia ? measures_of({MeasureGroup::shape, MeasureGroup::torque})
                                            : measures_of({MeasureGroup::shape}),
                 .inertia = limits.inertia},
      .limits = limits};
  const auto certificates = certificates_of(limits, retiming.peaks);
  const Method& path_method = retiming.evenness ? retiming.evenness->path_method : retiming.method;
  report::Page page = begun_page(title_of(before, retiming, certificates), head, before.epoch, before.keys);
  add_limits(page, limits, certificates);
  page.columns = columns_of(retimed.curves, certificates);
  page.methods.push_back(method_of(retimed, "after", retiming.method, retiming.track.keys, retiming.peaks));
  page.methods.push_back(method_of(retimed, "before", path_method, before.keys, {}));
  page.methods.back().clock = clock_of(before.keys, retiming);
  return page;
}

}}}  // namespace orispline::pages
