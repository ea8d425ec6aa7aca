// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/curve_measures.hpp>

#include <algorithm>

#include <orispline/analysis/quadrature.hpp>
#include <orispline/analysis/rounding.hpp>
#include <orispline/analysis/segment_motions.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr int most_steps = 80;  // bisection alone needs fewer than 64

}  // namespace

AngleTravelled::AngleTravelled(AnyCurve curve) : curve_(std::move(curve)) {
  const auto knots = curve_.knots().times();
  at_knots_.reserve(knots.size());
  at_knots_.push_back(0.0);
  for (std::size_t segment = 0; segment + 1 < knots.size(); ++segment)
    at_knots_.push_back(at_knots_.back() + within(segment, knots[segment], knots[segment + 1]));
}

double AngleTravelled::within(std::size_t segment, double start, double end) const {
  if (is_gap(curve_, segment)) return 0.0;
  SegmentMotions motions(curve_, segment);
  const auto speed = [&](std::span<const double> times, std::span<Figures<1>> values) {
    motions.evaluate(times);
    for (std::size_t i = 0; i < times.size(); ++i) values[i] = motions.angular_velocity(i).norm();
  };
  return adaptive_integral<1>(speed, start, end, Figures<1>(rounding_of_increments))[0];
}

double AngleTravelled::at(double t) const {
  const Domain domain = curve_.domain();
  if (!(t > domain.start)) return 0.0;
  if (t >= domain.end) return total();
  const std::size_t segment = curve_.knots().segment_at(t);
  return at_knots_[segment] + within(segment, curve_.knots().times()[segment], t);
}

double AngleTravelled::time_at(double angle) const {
  const auto knots = curve_.knots().times();
  if (!(angle > 0.0)) return knots.front();
  const auto beyond = std::ranges::lower_bound(at_knots_, angle);
  if (beyond == at_knots_.end()) return time_at(total());
  const auto segment = static_cast<std::size_t>(beyond - at_knots_.begin()) - 1;
  const double wanted = angle - at_knots_[segment], start = knots[segment];
  double low = start, high = knots[segment + 1];
  double t = std::lerp(low, high, wanted / (at_knots_[segment + 1] - at_knots_[segment]));
  for (int step = 0; step < most_steps && low < high; ++step) {  // Newton's method, kept between low and high
    const double excess = within(segment, start, t) - wanted;
    if (std::abs(excess) <= rounding_of_increments) return t;
    (excess > 0.0 ? high : low) = t;
    const double next = t - excess / curve_.motion_on(segment, t).angular_velocity.norm();
    t = low < next && next < high ? next : 0.5 * (low + high);
    if (t <= low || t >= high) break;
  }
  return t;
}

}}  // namespace orispline
