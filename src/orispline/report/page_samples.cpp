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

#include <orispline/math/chord.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t most_seen = 2'000'000, most_places_seen = 8;  // of a curve and of a segment, for their extremes
const Eigen::Quaterniond no_orientation(nan, nan, nan, nan);
const Eigen::Vector3d no_rate(nan, nan, nan);

void append(PageSamples& samples, double t, const Motion& motion) {
  samples.path.times.push_back(t);
  samples.path.orientations.push_back(motion.orientation);
  samples.angular_velocities.push_back(motion.angular_velocity);
  samples.angular_accelerations.push_back(motion.angular_acceleration);
  samples.angular_jerks.push_back(motion.angular_jerk);
}

void append(PageSamples& samples, const PoseCurve& curve, double t, Side side) {
  append(samples, t, curve.orientation.motion(t, side));
  if (curve.position) samples.positions.push_back(curve.position->linear_motion(t, side).position);
}

/// Nothing stands between the two sides of a jump, which has no time.
void append_jump(PageSamples& samples, const PoseCurve& curve, double t) {
  append(samples, t, {no_orientation, no_rate, no_rate, no_rate});
  if (curve.position) samples.positions.push_back(no_rate);
  append(samples, curve, t, Side::right);
}

/// The k-th of `steps` equal steps from a to b; exactly b at the last one.
double between(double a, double b, std::size_t k, std::size_t steps) {
  return std::lerp(a, b, static_cast<double>(k) / static_cast<double>(steps));
}

/// The samples of one column of a picture among which the extremes of its charts are: the first one, those of the
/// least and the largest rates and angles, and one in a gap.
class PictureColumn {
 public:
  PictureColumn(const PoseCurve& curve, const Eigen::Quaterniond& start) : curve_(curve), start_(start) {}

  void see(double t, Side side, const Motion& m) {
    const std::array values{m.angular_velocity.squaredNorm(), m.angular_acceleration.squaredNorm(),
                            m.angular_jerk.squaredNorm(), chord_square(start_, m.orientation)};
    const Place place{t, side == Side::right};
    if (!first_) first_ = place;
    if (m.orientation.coeffs().hasNaN()) missing_ = place;
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
    if (missing_) places.push_back(*missing_);
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());  // Clang 14 cannot take ranges::unique
    for (const auto& [t, is_right] : places) append(samples, curve_, t, is_right ? Side::right : Side::left);
    first_.reset();
    missing_.reset();
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
  std::optional<Place> first_{}, missing_{};  // the latter in a gap, which the picture shows
  Extremes least_ = none(std::numeric_limits<double>::infinity()),
           most_ = none(-std::numeric_limits<double>::infinity());
};

/// Of more segments than can be shown each: what is extreme in even columns.
PageSamples envelope(const PoseCurve& curve, std::size_t columns, const SegmentLook& look) {
  PageSamples samples;
  const Knots& knots = curve.orientation.knots();
  const Domain domain = curve.orientation.domain();
  const std::size_t segments = knots.segments(),
                    places = std::clamp<std::size_t>(most_seen / segments, 2, most_places_seen);
  const auto column_of = [&](double t) {
    const double share = (t - domain.start) / (domain.end - domain.start);
    return std::min(columns - 1, static_cast<std::size_t>(share * static_cast<double>(columns)));
  };
  PictureColumn column(curve, curve.orientation(domain.start));
  std::size_t current = 0;
  std::array<double, most_places_seen + 1> times;
  std::array<Motion, most_places_seen + 1> motions;
  for (std::size_t i = 0; i < segments; ++i) {
    for (std::size_t k = 0; k <= places; ++k) times[k] = between(knots.times()[i], knots.times()[i + 1], k, places);
    look(i, {times.data(), places + 1}, {motions.data(), places + 1});
    for (std::size_t k = 0; k <= places; ++k) {
      if (const std::size_t next = column_of(times[k]); next != current) {
        column.flush(samples);
        current = next;
      }
      column.see(times[k], k == places ? Side::left : Side::right, motions[k]);
    }
  }
  column.flush(samples);
  if (samples.path.times.back() != domain.end) append(samples, curve, domain.end, Side::left);
  return samples;
}

SegmentLook one_by_one(const AnyCurve& curve) {
  return [&curve](std::size_t segment, std::span<const double> times, std::span<Motion> motions) {
    for (std::size_t k = 0; k < times.size(); ++k) motions[k] = curve.motion_on(segment, times[k]);
  };
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

PageSamples sampled(const PoseCurve& curve, std::size_t count, const SegmentLook& look) {
  PageSamples samples;
  const Knots& knots = curve.orientation.knots();
  const Domain domain = curve.orientation.domain();
  const std::size_t segments = knots.segments();
  if (segments == 0) append(samples, curve, domain.start, Side::right);
  if (4 * segments > count)
    return envelope(curve, std::max<std::size_t>(1, count / 9), look ? look : one_by_one(curve.orientation));
  for (std::size_t i = 0; i < segments; ++i) {
    const double from = knots.times()[i], to = knots.times()[i + 1];
    if (from == to) {
      append_jump(samples, curve, to);
      continue;
    }
    const double share = (to - from) / (domain.end - domain.start);
    const auto steps = static_cast<std::size_t>(std::max(3.0, std::ceil(share * static_cast<double>(count))));
    for (std::size_t k = 0; k <= steps; ++k)
      append(samples, curve, between(from, to, k, steps), k == steps ? Side::left : Side::right);
  }
  return samples;
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

PageErrors largest_near(const PageErrors& errors, std::span<const std::size_t> places) {
  PageErrors few;
  std::size_t next = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::size_t end = k + 1 < places.size() ? std::midpoint(places[k], places[k + 1]) + 1 : errors.times.size();
    double worst = nan;
    for (; next < end; ++next)
      if (std::isnan(worst) || errors.values[next] > worst) worst = errors.values[next];
    few.times.push_back(errors.times[places[k]]);
    few.values.push_back(worst);
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
