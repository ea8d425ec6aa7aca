// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/rate_bounds.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <orispline/analysis/torque.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/batch/sample.hpp>
#include <orispline/retime/segment_hull.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

constexpr double gap = 1e-4;  // of a bound above the largest value found, relative
/// Of an increment so much is rounding [rad]: that of two keys, also when they are written, read and normalised again.
constexpr double rounding_of_keys = 16.0 * std::numeric_limits<double>::epsilon();
constexpr std::size_t keys_near = 3;   // so many segments away a short step still shapes the curve
constexpr std::size_t first_cuts = 4;  // of a segment
/// Parts that the segments of a curve are cut into, all together, and those of each that it has in any case.
constexpr std::size_t most_parts = std::size_t{1} << 20, fewest_parts = std::size_t{1} << 10;

/// The longer end of the line a ± b r.
double longest(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double r) {
  return std::max((a + b * r).norm(), (a - b * r).norm());
}

MotionSizes smaller(const MotionSizes& a, const MotionSizes& b) {
  return {std::min(a.rate, b.rate), std::min(a.acceleration, b.acceleration), std::min(a.torque, b.torque)};
}

/// A part of a segment, and what the motion is nowhere above on it.
struct Part {
  double middle, radius;  ///< [s]
  MotionSizes bounds;
  double excess;  ///< by which factor a bound is above what is near enough, when it was found
};

/// One segment, cut where its bounds are the farthest from what was found.
class PeakSearch {
 public:
  PeakSearch(const AnyCurve& curve, std::size_t segment, const SegmentHull& hull,
             const std::optional<Eigen::Matrix3d>& inertia, const MotionSizes& floors)
      : curve_(curve),
        segment_(segment),
        span_(curve.knots().span(segment)),
        hull_(hull),
        rounding_(hull.rounding()),
        inertia_(inertia ? *inertia : Eigen::Matrix3d::Zero()),
        weight_(inertia_.norm()),
        floors_(floors) {}

  /// `parts`: at most.
  SegmentPeaks run(std::size_t parts) {
    constexpr double any = std::numeric_limits<double>::infinity();
    const double step = span_.step() / static_cast<double>(first_cuts);
    for (std::size_t i = 0; i < first_cuts; ++i) note(span_.start() + static_cast<double>(i) * step);
    note(span_.end());
    for (std::size_t i = 0; i < first_cuts; ++i)
      add(span_.start() + (static_cast<double>(i) + 0.5) * step, 0.5 * step, {any, any, any});
    for (std::size_t made = first_cuts; !open_.empty() && made < parts; made += 2) halve_worst();
    for (const Part& part : open_) take(part.bounds);
    return rounded();
  }

 private:
  Motion note(double t) {
    const Motion m = curve_.motion_on(segment_, t);
    const auto see = [t](CertifiedPeak& peak, double value) {
      if (value > peak.found) peak.found = value, peak.time = t;
      peak.bound = std::max(peak.bound, value);
    };
    see(peaks_.rate, m.angular_velocity.norm());
    see(peaks_.acceleration, m.angular_acceleration.norm());
    see(peaks_.torque, orispline::torque(m, inertia_).norm());
    return m;
  }

  /// Of all times within `r` of the motion's.
  [[nodiscard]] MotionSizes bounds(const Motion& m, double r, const HullBounds& hull) const {
    const double jerk = m.angular_jerk.norm();
    const double rate = std::min(hull.rate, longest(m.angular_velocity, m.angular_acceleration, r) +
                                                (0.5 * jerk + hull.snap * r / 6.0) * r * r) +
                        rounding_.rate;
    const double acceleration =
        std::min(hull.acceleration, longest(m.angular_acceleration, m.angular_jerk, r) + 0.5 * hull.snap * r * r) +
        rounding_.acceleration;
    const double bend =
        weight_ * (hull.snap + 2.0 * ((jerk + hull.snap * r) * rate + acceleration * acceleration));  // of the torque
    const double torque = longest(orispline::torque(m, inertia_), torque_rate(m, inertia_), r) + 0.5 * bend * r * r +
                          weight_ * (rounding_.acceleration + 2.0 * rate * rounding_.rate);
    return {rate, acceleration, std::min(torque, weight_ * (acceleration + rate * rate))};
  }

  /// `within`: bounds of a part that holds this one.
  void add(double middle, double radius, const MotionSizes& within) {
    const double of_time = 2.0 * std::numeric_limits<double>::epsilon() * std::abs(middle);
    const double r = radius + of_time;
    const Motion m = note(middle);
    const auto place = [&](double t) { return std::clamp(span_.normalised(t), 0.0, 1.0); };
    const HullBounds hull = hull_.on(place(middle - r), place(middle + r));
    const MotionSizes found = smaller(within, bounds(m, r, hull));
    const double excess = excess_of(found);
    if (excess > 1.0 && radius > of_time) {
      open_.push_back({middle, radius, found, excess});
      std::ranges::push_heap(open_, {}, &Part::excess);
    } else {
      take(found);
    }
  }

  void halve_worst() {
    std::ranges::pop_heap(open_, {}, &Part::excess);
    const Part part = open_.back();
    open_.pop_back();
    if (!(excess_of(part.bounds) > 1.0)) return take(part.bounds);
    add(part.middle - 0.5 * part.radius, 0.5 * part.radius, part.bounds);
    add(part.middle + 0.5 * part.radius, 0.5 * part.radius, part.bounds);
  }

  void take(const MotionSizes& bounds) {
    peaks_.rate.bound = std::max(peaks_.rate.bound, bounds.rate);
    peaks_.acceleration.bound = std::max(peaks_.acceleration.bound, bounds.acceleration);
    peaks_.torque.bound = std::max(peaks_.torque.bound, bounds.torque);
  }

  [[nodiscard]] double excess_of(const MotionSizes& bounds) const {
    const auto of = [](double bound, const CertifiedPeak& peak, double floor) {
      return bound > 0.0 ? bound / std::max(peak.found * (1.0 + gap), floor) : 0.0;
    };
    return std::max({of(bounds.rate, peaks_.rate, floors_.rate),
                     of(bounds.acceleration, peaks_.acceleration, floors_.acceleration),
                     of(bounds.torque, peaks_.torque, floors_.torque)});
  }

  /// With what the rounding of the keys makes of the shortest step near the segment.
  [[nodiscard]] SegmentPeaks rounded() const {
    const auto t = curve_.knots().times();
    double shortest = span_.step();
    for (std::size_t i = segment_ - std::min(segment_, keys_near); i <= segment_ + keys_near && i + 1 < t.size(); ++i)
      shortest = std::min(shortest, t[i + 1] - t[i]);
    const double rate = rounding_of_keys / shortest, acceleration = rate / shortest;
    SegmentPeaks peaks = peaks_;
    peaks.rate.bound += rate;
    peaks.acceleration.bound += acceleration;
    peaks.torque.bound += weight_ * (acceleration + 2.0 * peaks.rate.bound * rate);
    return peaks;
  }

  const AnyCurve& curve_;
  std::size_t segment_;
  KnotSpan span_;
  const SegmentHull& hull_;
  HullBounds rounding_;
  Eigen::Matrix3d inertia_;
  double weight_;
  MotionSizes floors_;
  SegmentPeaks peaks_{};
  std::vector<Part> open_{};  ///< a heap, the worst first
};

}  // namespace

std::vector<MotionSizes> sampled_peaks(const AnyCurve& curve, const std::optional<Eigen::Matrix3d>& inertia) {
  constexpr std::size_t cuts = 16, places = cuts + 1;
  std::vector<MotionSizes> peaks(curve.knots().segments(), MotionSizes{});
  std::vector<double> times;
  for (std::size_t s = 0; s < peaks.size(); ++s) {
    const KnotSpan span = curve.knots().span(s);
    const double step = span.step() / static_cast<double>(cuts);
    const double last = std::nextafter(span.end(), span.start());  // the end itself belongs to the next segment
    for (std::size_t i = 0; i < places; ++i)
      times.push_back(std::min(span.start() + static_cast<double>(i) * step, last));
  }
  std::vector<double> orientations(4 * times.size()), rates(3 * times.size()), accelerations(3 * times.size());
  static_cast<void>(sample<double>(  // no times that decrease, no sizes that differ: no error
      curve, times, {.orientations = orientations, .angular_velocities = rates, .angular_accelerations = accelerations},
      {.threads = 0}));
  for (std::size_t k = 0; k < times.size(); ++k) {
    const Motion m{.angular_velocity = Eigen::Map<const Eigen::Vector3d>(&rates[3 * k]),
                   .angular_acceleration = Eigen::Map<const Eigen::Vector3d>(&accelerations[3 * k])};
    MotionSizes& largest = peaks[k / places];
    largest.rate = std::max(largest.rate, m.angular_velocity.norm());
    largest.acceleration = std::max(largest.acceleration, m.angular_acceleration.norm());
    if (inertia) largest.torque = std::max(largest.torque, torque(m, *inertia).norm());
  }
  return peaks;
}

std::optional<double> snap_bound(const SegmentForm& form, double duration) {
  const auto hull = SegmentHull::of(form, duration);
  return hull ? std::optional(hull->on(0.0, 1.0).snap) : std::nullopt;
}

std::optional<std::vector<SegmentPeaks>> certified_peaks(const AnyCurve& curve,
                                                         const std::optional<Eigen::Matrix3d>& inertia,
                                                         const MotionSizes& floors) {
  constexpr std::size_t together = 64;  // segments
  const std::size_t segments = curve.knots().segments();
  if (segments > 0 && std::holds_alternative<std::monostate>(curve.form(0))) return std::nullopt;
  const std::size_t parts = std::max(fewest_parts, most_parts / std::max<std::size_t>(segments, 1));
  std::vector<SegmentPeaks> peaks(segments);
  parallel_for((segments + together - 1) / together, 0, [&](std::size_t part) {
    for (std::size_t s = part * together; s < std::min(segments, (part + 1) * together); ++s)
      if (const auto hull = SegmentHull::of(curve.form(s), curve.knots().span(s).step()))
        peaks[s] = PeakSearch(curve, s, *hull, inertia, floors).run(parts);
  });
  return peaks;
}

}  // namespace orispline::inline ORISPLINE_ABI
