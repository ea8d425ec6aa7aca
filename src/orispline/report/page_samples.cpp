// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/page_samples.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include <orispline/math/degrees.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t most_seen = 2'000'000;  // of a curve, for its extremes
const Eigen::Quaterniond no_orientation(nan, nan, nan, nan);

void append(PageSamples& samples, const PoseCurve& curve, double t, Side side) {
  const Motion motion = curve.orientation.motion(t, side);
  samples.path.times.push_back(t);
  samples.path.orientations.push_back(motion.orientation);
  samples.angular_velocities.push_back(motion.angular_velocity);
  samples.angular_accelerations.push_back(motion.angular_acceleration);
  samples.angular_jerks.push_back(motion.angular_jerk);
  if (curve.position) samples.positions.push_back(curve.position->linear_motion(t, side).position);
}

/// The k-th of `steps` equal steps from a to b; exactly b at the last one.
double between(double a, double b, std::size_t k, std::size_t steps) {
  return std::lerp(a, b, static_cast<double>(k) / static_cast<double>(steps));
}

/// The samples of one column of a picture among which the extremes of its charts are: the first one, and those of the
/// least and the largest rates and angles.
class PictureColumn {
 public:
  PictureColumn(const PoseCurve& curve, const Eigen::Quaterniond& start) : curve_(curve), start_(start) {}

  void see(double t, Side side) {
    const Motion m = curve_.orientation.motion(t, side);
    const std::array values{m.angular_velocity.norm(), m.angular_acceleration.norm(), m.angular_jerk.norm(),
                            angular_distance(start_, m.orientation)};
    const Place place{t, side == Side::right};
    if (!first_) first_ = place;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] < least_[i].first) least_[i] = {values[i], place};
      if (values[i] > most_[i].first) most_[i] = {values[i], place};
    }
  }

  void flush(PageSamples& samples) {
    if (!first_) return;
    std::vector<Place> places{*first_};
    for (const auto& extremes : {least_, most_})
      for (const auto& [value, place] : extremes)
        if (std::isfinite(value)) places.push_back(place);
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());  // Clang 14 cannot take ranges::unique
    for (const auto& [t, is_right] : places) append(samples, curve_, t, is_right ? Side::right : Side::left);
    first_.reset();
    least_ = none(std::numeric_limits<double>::infinity());
    most_ = none(-std::numeric_limits<double>::infinity());
  }

 private:
  using Place = std::pair<double, bool>;  // a time, and whether its right side: that comes after the left one
  using Extremes = std::array<std::pair<double, Place>, 4>;

  static Extremes none(double value) {
    Extremes extremes;
    extremes.fill({value, Place{}});
    return extremes;
  }

  const PoseCurve& curve_;
  Eigen::Quaterniond start_;
  std::optional<Place> first_{};
  Extremes least_ = none(std::numeric_limits<double>::infinity()),
           most_ = none(-std::numeric_limits<double>::infinity());
};

/// Of more segments than can be shown each: what is extreme in even columns.
PageSamples envelope(const PoseCurve& curve, std::size_t columns) {
  PageSamples samples;
  const Knots& knots = curve.orientation.knots();
  const Domain domain = curve.orientation.domain();
  const std::size_t segments = knots.segments(), places = std::clamp<std::size_t>(most_seen / segments, 2, 8);
  const auto column_of = [&](double t) {
    const double share = (t - domain.start) / (domain.end - domain.start);
    return std::min(columns - 1, static_cast<std::size_t>(share * static_cast<double>(columns)));
  };
  PictureColumn column(curve, curve.orientation(domain.start));
  std::size_t current = 0;
  for (std::size_t i = 0; i < segments; ++i)
    for (std::size_t k = 0; k <= places; ++k) {
      const double t = between(knots.times()[i], knots.times()[i + 1], k, places);
      if (const std::size_t next = column_of(t); next != current) {
        column.flush(samples);
        current = next;
      }
      column.see(t, k == places ? Side::left : Side::right);
    }
  column.flush(samples);
  if (samples.path.times.back() != domain.end) append(samples, curve, domain.end, Side::left);
  return samples;
}

/// The time in the reference's interval that ends at `after`, by the shortest way.
Eigen::Quaterniond on_reference(const PagePath& reference, std::size_t after, double t) {
  const double start = reference.times[after - 1], step = reference.times[after] - start;
  const Eigen::Quaterniond& from = reference.orientations[after - 1];
  Eigen::Quaterniond to = reference.orientations[after];
  if (from.dot(to) < 0.0) to.coeffs() = -to.coeffs();
  return step > 0.0 ? slerp<double>(from, to, (t - start) / step) : to;
}

/// Times and values, with `none` in the middle of neighbouring times where there is a gap.
template <class Value>
std::pair<std::vector<double>, std::vector<Value>> interrupted(const std::vector<double>& times,
                                                               const std::vector<Value>& values, const Value& none,
                                                               const Covers& covers) {
  std::pair<std::vector<double>, std::vector<Value>> result;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (const double middle = i > 0 ? std::midpoint(times[i - 1], times[i]) : times[i]; !covers(middle)) {
      result.first.push_back(middle);
      result.second.push_back(none);
    }
    result.first.push_back(times[i]);
    result.second.push_back(values[i]);
  }
  return result;
}

/// At most about `count` of the values, evenly, with both ends.
template <class Value>
std::vector<Value> picked(const std::vector<Value>& values, std::size_t count) {
  if (values.size() <= count || count < 2) return values;
  std::vector<Value> few;
  for (std::size_t k = 0; k < count; ++k) few.push_back(values[k * (values.size() - 1) / (count - 1)]);
  return few;
}

}  // namespace

PageKeys page_keys(const Keyframes& keys) {
  return {
      .path = {{keys.times().begin(), keys.times().end()}, {keys.orientations().begin(), keys.orientations().end()}},
      .positions = {keys.positions().begin(), keys.positions().end()}};
}

PageSamples sampled(const PoseCurve& curve, std::size_t count) {
  PageSamples samples;
  const Knots& knots = curve.orientation.knots();
  const Domain domain = curve.orientation.domain();
  const std::size_t segments = knots.segments();
  if (segments == 0) append(samples, curve, domain.start, Side::right);
  if (4 * segments > count) return envelope(curve, std::max<std::size_t>(1, count / 9));
  for (std::size_t i = 0; i < segments; ++i) {
    const double from = knots.times()[i], to = knots.times()[i + 1];
    const double share = (to - from) / (domain.end - domain.start);
    const auto steps = static_cast<std::size_t>(std::max(3.0, std::ceil(share * static_cast<double>(count))));
    for (std::size_t k = 0; k <= steps; ++k)
      append(samples, curve, between(from, to, k, steps), k == steps ? Side::left : Side::right);
  }
  return samples;
}

std::vector<double> errors_to(const PagePath& reference, const PagePath& path) {
  std::vector<double> errors(path.times.size(), nan);
  if (reference.times.size() < 2) return errors;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double t = path.times[i];
    if (t < reference.times.front() || t > reference.times.back()) continue;
    const auto after = std::upper_bound(reference.times.begin() + 1, reference.times.end() - 1, t);
    const auto index = static_cast<std::size_t>(after - reference.times.begin());
    errors[i] = angular_distance(path.orientations[i], on_reference(reference, index, t)) / radians_per_degree;
  }
  return errors;
}

PageErrors largest(const PageErrors& errors, std::size_t count) {
  const std::size_t size = errors.times.size();
  if (size <= count) return errors;
  PageErrors few;
  for (std::size_t k = 0; k < count; ++k) {
    const auto first = errors.values.begin();
    const auto at = [&](std::size_t part) { return first + static_cast<std::ptrdiff_t>(part * size / count); };
    const auto worst = std::max_element(at(k), at(k + 1));
    few.times.push_back(errors.times[static_cast<std::size_t>(worst - first)]);
    few.values.push_back(*worst);
  }
  return few;
}

PagePath with_gaps(const PagePath& path, const Covers& covers) {
  PagePath result;
  std::tie(result.times, result.orientations) = interrupted(path.times, path.orientations, no_orientation, covers);
  return result;
}

PageErrors with_gaps(const PageErrors& errors, const Covers& covers) {
  PageErrors result;
  std::tie(result.times, result.values) = interrupted(errors.times, errors.values, nan, covers);
  return result;
}

PagePath thinned(const PagePath& path, std::size_t count) {
  return {picked(path.times, count), picked(path.orientations, count)};
}

PageKeys thinned(const PageKeys& keys, std::size_t count) {
  return {.path = thinned(keys.path, count), .positions = picked(keys.positions, count)};
}

}}}  // namespace orispline::report
