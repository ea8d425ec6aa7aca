// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/curve_measures.hpp>

#include <algorithm>

#include <orispline/analysis/quadrature.hpp>
#include <orispline/analysis/rounding.hpp>
#include <orispline/analysis/segment_motions.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr int most_steps = 80;  // bisection alone needs fewer than 64

using Speeds = std::span<Figures<1>>;

/// The speeds on a segment of a curve.
auto speeds_on(const AnyCurve& curve, std::size_t segment) {
  return [motions = SegmentMotions(curve, segment)](std::span<const double> times, Speeds speeds) mutable {
    motions.evaluate(times);
    for (std::size_t i = 0; i < times.size(); ++i) speeds[i] = motions.angular_velocity(i).norm();
  };
}
auto speeds_on(const AnyPath& path, std::size_t segment) {
  return [&path, segment](std::span<const double> times, Speeds speeds) {
    for (std::size_t i = 0; i < times.size(); ++i) speeds[i] = path.linear_motion_on(segment, times[i]).velocity.norm();
  };
}

double speed_of(const AnyCurve& curve, std::size_t segment, double t) {
  return curve.motion_on(segment, t).angular_velocity.norm();
}
double speed_of(const AnyPath& path, std::size_t segment, double t) {
  return path.linear_motion_on(segment, t).velocity.norm();
}

/// So much of a length is rounding, whatever the speed.
double rounding_of(const AnyCurve&) { return rounding_of_increments; }
double rounding_of(const AnyPath& path) {
  double size = 0.0;
  for (const double t : path.knots().times()) size = std::max(size, path.linear_motion(t).position.norm());
  return rounding_of_increments * size;
}

}  // namespace

template <class C>
ArcLength<C>::ArcLength(C curve) : curve_(std::move(curve)), rounding_(rounding_of(curve_)) {
  const auto knots = curve_.knots().times();
  at_knots_.reserve(knots.size());
  at_knots_.push_back(0.0);
  for (std::size_t segment = 0; segment + 1 < knots.size(); ++segment)
    at_knots_.push_back(at_knots_.back() + within(segment, knots[segment], knots[segment + 1]));
}

template <class C>
double ArcLength<C>::within(std::size_t segment, double start, double end) const {
  return adaptive_integral<1>(speeds_on(curve_, segment), start, end, Figures<1>(rounding_))[0];
}

template <class C>
double ArcLength<C>::at(double t) const {
  if (!(t > curve_.knots().front())) return 0.0;
  if (t >= curve_.knots().back()) return total();
  const std::size_t segment = curve_.knots().segment_at(t);
  return at_knots_[segment] + within(segment, curve_.knots().times()[segment], t);
}

template <class C>
double ArcLength<C>::time_at(double length) const {
  const auto knots = curve_.knots().times();
  if (!(length > 0.0)) return knots.front();
  const auto beyond = std::ranges::lower_bound(at_knots_, length);
  if (beyond == at_knots_.end()) return time_at(total());
  const auto segment = static_cast<std::size_t>(beyond - at_knots_.begin()) - 1;
  const double wanted = length - at_knots_[segment], start = knots[segment];
  double low = start, high = knots[segment + 1];
  double t = std::lerp(low, high, wanted / (at_knots_[segment + 1] - at_knots_[segment]));
  for (int step = 0; step < most_steps && low < high; ++step) {  // Newton's method, kept between low and high
    const double excess = within(segment, start, t) - wanted;
    if (std::abs(excess) <= rounding_) return t;
    (excess > 0.0 ? high : low) = t;
    const double next = t - excess / speed_of(curve_, segment, t);
    t = low < next && next < high ? next : 0.5 * (low + high);
    if (t <= low || t >= high) break;
  }
  return t;
}

template class ArcLength<AnyCurve>;
template class ArcLength<AnyPath>;

}}  // namespace orispline
