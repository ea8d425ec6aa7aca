// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/curve_measures.hpp>

#include <algorithm>
#include <iterator>

#include <orispline/analysis/quadrature.hpp>
#include <orispline/analysis/rounding.hpp>
#include <orispline/analysis/segment_motions.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr int most_steps = 80;  // bisection alone needs fewer than 64

using Speeds = std::span<Figures<1>>;

/// The speeds on a segment of a curve.
auto speeds_on(const AnyCurve& curve, std::size_t segment) {
  return [motions = SegmentMotions(curve, segment, MotionPart::angular_velocities)](std::span<const double> times,
                                                                                    Speeds speeds) mutable {
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
ArcLength<C>::ArcLength(C curve, std::span<const double> kinks)
    : curve_(std::move(curve)), rounding_(rounding_of(curve_)), lengths_{0.0} {
  std::ranges::set_union(curve_.knots().times(), kinks, std::back_inserter(nodes_));
  for (std::size_t node = 0; node + 1 < nodes_.size(); ++node)
    lengths_.push_back(lengths_.back() + beyond(node, nodes_[node + 1]));
}

template <class C>
double ArcLength<C>::beyond(std::size_t node, double end) const {
  const std::size_t segment = curve_.knots().segment_at(nodes_[node]);
  if (is_gap(curve_, segment)) return 0.0;
  return adaptive_integral<1>(speeds_on(curve_, segment), nodes_[node], end, Figures<1>(rounding_))[0];
}

template <class C>
double ArcLength<C>::at(double t) const {
  if (!(t > nodes_.front())) return 0.0;
  if (t >= nodes_.back()) return total();
  const auto node = static_cast<std::size_t>(std::ranges::upper_bound(nodes_, t) - nodes_.begin()) - 1;
  return lengths_[node] + beyond(node, t);
}

template <class C>
double ArcLength<C>::time_at(double length) const {
  if (!(length > 0.0)) return nodes_.front();
  const auto after = std::ranges::lower_bound(lengths_, length);
  if (after == lengths_.end()) return time_at(total());
  const auto node = static_cast<std::size_t>(after - lengths_.begin()) - 1;
  const std::size_t segment = curve_.knots().segment_at(nodes_[node]);
  const double wanted = length - lengths_[node];
  double low = nodes_[node], high = nodes_[node + 1];
  double t = std::lerp(low, high, wanted / (lengths_[node + 1] - lengths_[node]));
  for (int step = 0; step < most_steps && low < high; ++step) {  // Newton's method, kept between low and high
    const double excess = beyond(node, t) - wanted;
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
