// SPDX-License-Identifier: Apache-2.0
#include "output/report_page.hpp"

#include <algorithm>
#include <ctime>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <orispline/analysis/sampled.hpp>
#include <orispline/analysis/torque.hpp>
#include <orispline/base/version.hpp>

#include "options/quantity.hpp"

namespace orispline::cli {
namespace {

constexpr std::size_t most_keys = 2000;

std::string now() { return fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(std::time(nullptr))); }

std::vector<Eigen::Vector3d> torques_of(const report::PageSamples& samples, const Eigen::Matrix3d& inertia) {
  std::vector<Eigen::Vector3d> torques;
  for (std::size_t i = 0; i < samples.path.times.size(); ++i)
    torques.push_back(torque(Motion{.angular_velocity = samples.angular_velocities[i],
                                    .angular_acceleration = samples.angular_accelerations[i]},
                             inertia));
  return torques;
}

}  // namespace

report::Page begun_page(std::string title, const ReportOptions& options, const Decimal& epoch,
                        const Keyframes& keys) {
  report::Page page{.title = std::move(title),
                    .command = options.command_line,
                    .date = now(),
                    .version = std::string(version),
                    .time_start = epoch.to_string(),
                    .keys = keys_in_page(keys)};
  if (keys.size() > most_keys)
    page.notes.push_back(fmt::format("Of the {} keys {} are shown, evenly picked.", keys.size(), most_keys));
  return page;
}

ComparedData compared_with(std::string file, const Decimal& epoch, const Keyframes& samples) {
  return {.reference = std::move(file),
          .epoch = epoch,
          .samples = samples,
          .times = {samples.times().begin(), samples.times().end()},
          .key_sets = {},
          .repairs = {}};
}

report::PageKeys keys_in_page(const Keyframes& keys) { return report::thinned(report::page_keys(keys), most_keys); }

report::PagePath path_of(std::span<const double> times, std::span<const Eigen::Quaterniond> orientations) {
  return {{times.begin(), times.end()}, {orientations.begin(), orientations.end()}};
}

std::vector<report::PageColumn> columns_of(std::vector<CompareFigure> figures) {
  std::vector<report::PageColumn> columns;
  std::stable_partition(figures.begin(), figures.end(),
                        [](const CompareFigure& figure) { return !figure.column.name.empty(); });
  for (const CompareFigure& figure : figures)
    if (figure.id != "continuity")  // which has a column of its own
      columns.push_back({std::string(figure.id), std::string(figure.label), std::string(figure.unit),
                         std::string(figure.explanation), figure.better});
  return columns;
}

report::PageSamples samples_of(const PoseCurve& curve, const std::optional<Eigen::Matrix3d>& inertia,
                               std::size_t count) {
  report::PageSamples samples = report::sampled(curve, count);
  if (inertia) samples.torques = torques_of(samples, *inertia);
  return samples;
}

report::PageMethod method_of(const CurvePage& page, const ShownCurve& curve) {
  report::PageMethod method{.name = curve.name,
                            .continuity = fmt::format("C{}", curve.measures.continuity.order()),
                            .samples = samples_of(curve.curve, page.inertia, samples_of_few),
                            .keys = keys_in_page(curve.keys)};
  for (const CompareFigure& figure : page.figures)
    if (const auto value = figure.value(curve.measures, page.data); value && is_finite(figure, curve.measures))
      method.measures.emplace(figure.id, *value);
  return method;
}

report::PageErrors errors_at(const PoseCurve& curve, const report::PagePath& recording) {
  const auto orientations = sampled(curve.orientation, recording.times, Sampled::orientations).orientations;
  report::PageErrors errors{.times = recording.times};
  for (std::size_t i = 0; i < orientations.size(); ++i)
    errors.values.push_back(angular_distance(orientations[i], recording.orientations[i]) * degrees);
  return errors;
}

std::vector<std::string> notes_on_samples(std::size_t samples) {
  if (samples <= samples_of_few) return {};
  return {
      fmt::format("Curves are drawn through {} points, errors as the largest of every {:.3g} samples; the table "
                  "counts all.",
                  samples_of_few, static_cast<double>(samples) / samples_of_few)};
}

report::PageMethod with_errors(report::PageMethod method, const report::PageErrors& errors,
                               const report::Covers& covers) {
  auto largest = report::with_gaps(report::largest(errors, samples_of_few), covers);
  method.samples.error_times = std::move(largest.times);
  method.samples.errors = std::move(largest.values);
  return method;
}

}  // namespace orispline::cli
