// SPDX-License-Identifier: Apache-2.0
#include "papers/sampling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <time.h>

#include <orispline/base/formatted.hpp>
#include <orispline/math/highest.hpp>

namespace orispline::cli {

namespace {

constexpr int steps_per_segment = 100;

/// Of this thread: other work on the machine does not count.
double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The motion at the times of one segment, one-sided at its ends.
std::vector<std::pair<double, Motion>> motions_of_segment(const AnyCurve& curve, std::size_t segment) {
  const KnotSpan span = curve.knots().span(segment);
  std::vector<std::pair<double, Motion>> motions;
  for (int k = 0; k <= steps_per_segment; ++k) {
    const double t = std::lerp(span.start(), span.t[span.i + 1], static_cast<double>(k) / steps_per_segment);
    motions.emplace_back(t, curve.motion(t, k == steps_per_segment ? Side::left : Side::right));
  }
  return motions;
}

}  // namespace

std::vector<double> even_times(Domain domain, std::size_t count) {
  std::vector<double> times;
  for (std::size_t i = 0; i < count; ++i)
    times.push_back(std::lerp(domain.start, domain.end, static_cast<double>(i) / static_cast<double>(count - 1)));
  return times;
}

std::vector<Eigen::Vector3d> axis_path(const AnyCurve& curve, std::span<const double> times,
                                       const Eigen::Vector3d& axis) {
  std::vector<Eigen::Vector3d> path;
  for (const double t : times) path.push_back(to_world<double>(curve(t), axis));
  return path;
}

std::vector<Eigen::Vector3d> axis_path(std::span<const Eigen::Quaterniond> orientations, const Eigen::Vector3d& axis) {
  std::vector<Eigen::Vector3d> path;
  for (const Eigen::Quaterniond& q : orientations) path.push_back(to_world<double>(q, axis));
  return path;
}

report::SpherePicture sphere_of(std::span<const Served> curves, const Keyframes& keys, const Eigen::Vector3d& axis) {
  report::SpherePicture picture;
  for (const auto& [recipe, curve] : curves)
    picture.paths.push_back({axis_path(curve, even_times(curve.domain(), 401), axis), recipe.stroke, recipe.label});
  for (const Eigen::Vector3d& key : axis_path(keys.orientations(), axis))
    picture.dots.push_back({key, std::to_string(picture.dots.size() + 1)});
  return picture;
}

report::Series over_time(const AnyCurve& curve, const std::function<double(const Motion&)>& figure) {
  report::Series series;
  for (std::size_t segment = 0; segment < curve.knots().segments(); ++segment) {
    for (const auto& [t, motion] : motions_of_segment(curve, segment)) {
      series.x.push_back(t);
      series.y.push_back(figure(motion));
    }
    series.x.push_back(series.x.back());
    series.y.push_back(std::numeric_limits<double>::quiet_NaN());
  }
  return series;
}

report::Series over_time(const Served& served, const std::function<double(const Motion&)>& figure) {
  report::Series series = over_time(served.curve, figure);
  series.label = served.recipe.label;
  series.stroke = served.recipe.stroke;
  return series;
}

std::vector<report::Series> names_of(std::span<const Served> curves) {
  std::vector<report::Series> names;
  names.reserve(curves.size());
  for (const auto& [recipe, curve] : curves) names.push_back({recipe.label, {}, {}, recipe.stroke});
  return names;
}

double largest_over_time(const AnyCurve& curve, const std::function<double(const Motion&)>& figure) {
  double largest = 0.0;
  for (std::size_t segment = 0; segment < curve.knots().segments(); ++segment) {
    std::vector<double> times, figures;
    for (const auto& [t, motion] : motions_of_segment(curve, segment)) {
      times.push_back(t);
      figures.push_back(figure(motion));
    }
    const auto at = [&](double t) { return figure(curve.motion_on(segment, t)); };
    largest = std::max(largest, highest(times, figures, at, largest).value);
  }
  return largest;
}

double largest_distance(const AnyCurve& a, const AnyCurve& b, std::span<const double> times) {
  double largest = 0.0;
  for (const double t : times) largest = std::max(largest, angular_distance(a(t), b(t)));
  return largest;
}

std::vector<report::Mark> marks_at(std::span<const double> knots) {
  std::vector<report::Mark> marks;
  constexpr std::size_t most_labels = 12;
  for (const double t : knots) marks.push_back({t, knots.size() > most_labels ? "" : formatted("{:.4g} s", t)});
  return marks;
}

report::Cell finite_or_dash(double value) {
  if (!std::isfinite(value)) return "–";
  return value;
}

std::vector<double> seconds_in_turn(std::span<const std::function<void()>> works) {
  constexpr std::size_t rounds = 9;
  std::vector<std::array<double, rounds>> seconds(works.size());
  for (std::size_t round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < works.size(); ++i) {
      const double start = processor_seconds();
      works[i]();
      seconds[i][round] = processor_seconds() - start;
    }
  std::vector<double> medians;
  for (auto& all : seconds) {
    std::ranges::nth_element(all, all.begin() + rounds / 2);
    medians.push_back(all[rounds / 2]);
  }
  return medians;
}

std::function<void()> building(const Recipe& recipe, const Keyframes& keys, const std::vector<double>& times) {
  return [recipe, &keys, &times, frames = std::vector<Eigen::Quaterniond>(times.size())]() mutable {
    if (const auto curve = curve_of(recipe, keys))
      std::ranges::transform(times, frames.begin(), [&](double t) { return (*curve)(t); });
  };
}

}  // namespace orispline::cli
