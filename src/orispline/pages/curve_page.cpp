// SPDX-License-Identifier: Apache-2.0
#include <orispline/pages/curve_page.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <orispline/analysis/sampled.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/version.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

namespace {

constexpr std::size_t most_keys = 2000;

report::PageKeys keys_in_page(const Keyframes& keys) { return report::thinned(report::page_keys(keys), most_keys); }

std::vector<Eigen::Vector3d> torques_of(const report::PageSamples& samples, const Eigen::Matrix3d& inertia) {
  std::vector<Eigen::Vector3d> torques;
  for (std::size_t i = 0; i < samples.path.times.size(); ++i)
    torques.push_back(torque(Motion{.angular_velocity = samples.angular_velocities[i],
                                    .angular_acceleration = samples.angular_accelerations[i]},
                             inertia));
  return torques;
}

}  // namespace

report::Page begun_page(const std::string& title, const PageHead& head, const Decimal& epoch, const Keyframes& keys) {
  report::Page page{.title = head.title.empty() ? title : head.title,
                    .command = head.command,
                    .date = head.date,
                    .version = std::string(version),
                    .time_start = epoch.to_string(),
                    .keys = keys_in_page(keys)};
  if (keys.size() > most_keys)
    page.notes.push_back(formatted("Of the {} keys {} are shown, evenly picked.", keys.size(), most_keys));
  page.notes.insert(page.notes.end(), head.notes.begin(), head.notes.end());
  return page;
}

report::PagePath path_of(std::span<const double> times, std::span<const Eigen::Quaterniond> orientations) {
  return {{times.begin(), times.end()}, {orientations.begin(), orientations.end()}};
}

report::PagePath path_of(const Keyframes& keys) { return path_of(keys.times(), keys.orientations()); }

std::vector<report::PageColumn> measure_columns(std::vector<MeasureInfo> measures) {
  std::vector<report::PageColumn> columns;
  // Clang 14 does not compile what std::ranges::stable_partition returns.
  std::stable_partition(measures.begin(), measures.end(), [](const MeasureInfo& m) { return !m.heading.empty(); });
  for (const MeasureInfo& measure : measures)
    if (measure.id != "continuity")  // which has a column of its own
      columns.push_back({.id = std::string(measure.id),
                         .label = std::string(measure.label),
                         .unit = std::string(measure.unit),
                         .explanation = std::string(measure.explanation),
                         .better = measure.better,
                         .is_time = measure.is_time,
                         .rounding = measure.rounding});
  return columns;
}

report::PageSamples samples_of(const PoseCurve& curve, const std::optional<Eigen::Matrix3d>& inertia,
                               const report::Fineness& fineness) {
  report::PageSamples samples = report::drawn_samples(curve, fineness);
  if (inertia) samples.torques = torques_of(samples, *inertia);
  return samples;
}

std::string continuity_of(const Measures& measures) { return formatted("C{}", measures.continuity.order()); }

report::PageMethod method_of(const CurvePage& page, const ShownCurve& curve) {
  report::PageMethod method{
      .name = curve.name,
      .continuity = continuity_of(curve.measures),
      .samples = samples_of(curve.curve, page.inertia, {.least = samples_of_few, .covers = page.covers}),
      .keys = keys_in_page(curve.keys)};
  for (const MeasureInfo& measure : page.measures)
    if (const auto value = measure.value(curve.measures, on_page(page.recording.times()));
        value && measure.is_finite(curve.measures))
      method.measures.emplace(measure.id, *value);
  return method;
}

std::vector<std::size_t> evenly_picked(std::size_t count, std::size_t most) {
  std::vector<std::size_t> places;
  const std::size_t picked = std::min(count, most);
  for (std::size_t k = 0; k < picked; ++k) places.push_back(k * (count - 1) / std::max<std::size_t>(picked - 1, 1));
  return places;
}

void extend(report::PageBand& band, double t, double low, double high) {
  band.times.push_back(t);
  band.low.push_back(low);
  band.high.push_back(high);
}

Bands bands_about(const report::PagePath& path, const std::string& label, const std::function<double(double)>& radius) {
  Bands bands;
  report::PageBand& error = bands["error"];
  report::PageBand& turn = bands["angle"];
  error.label = turn.label = label;
  for (std::size_t i = 0; i < path.times.size(); ++i) {
    const double t = path.times[i], width = radius(t) * degrees,
                 angle = angular_distance(path.orientations.front(), path.orientations[i]) * degrees;
    const double from = std::isfinite(width) ? 0.0 : std::nan("");  // NaN ends a band
    extend(error, t, from, width + from);
    extend(turn, t, std::max(0.0, angle - width) + from, std::min(180.0, angle + width) + from);
  }
  return bands;
}

report::PageErrors errors_at(const PoseCurve& curve, const report::PagePath& recording) {
  const auto orientations = sampled(curve.orientation, recording.times, Sampled::orientations).orientations;
  report::PageErrors errors{.times = recording.times};
  for (std::size_t i = 0; i < orientations.size(); ++i)
    errors.values.push_back(angular_distance(orientations[i], recording.orientations[i]) * degrees);
  return errors;
}

report::Covers covers_of(std::span<const double> times, std::optional<double> gap) {
  if (!gap) return [](double) { return true; };
  return [times, longest = *gap](double t) {
    const auto after = std::upper_bound(times.begin(), times.end(), t);
    return after == times.begin() || after == times.end() || *after - *(after - 1) <= longest;
  };
}

std::vector<std::string> notes_on_samples(std::size_t samples, std::size_t drawn) {
  if (samples <= drawn) return {};
  return {formatted("A drawn error is the largest of about {} samples. The table counts all samples.",
                    (samples + drawn / 2) / drawn)};
}

report::PageMethod with_errors(report::PageMethod method, const report::PageErrors& errors,
                               const report::Covers& covers) {
  auto largest = report::with_gaps(report::largest(errors, samples_of_few), covers);
  method.samples.error_times = std::move(largest.times);
  method.samples.errors = std::move(largest.values);
  return method;
}

}}}  // namespace orispline::pages
