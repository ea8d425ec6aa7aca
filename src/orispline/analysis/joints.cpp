// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/joints.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <orispline/math/chord.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Where a body turns by more than this between two times [rad], it is looked at between them, but not more often than
/// so many times over: a jump is found where it is not small beside what the curve turns meanwhile.
constexpr double widest_look = 0.1;
constexpr int deepest_look = 6;

/// At least the angle between two orientations [rad]: up to half a turn, an arc is at most π/√8 times as long as its
/// chord, and the angle is twice the arc in R⁴.
double longest_way(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) noexcept {
  return std::numbers::pi / std::numbers::sqrt2 * std::sqrt(chord_square(a, b));
}

}  // namespace

Probes::Probes(const AnyCurve& curve, std::size_t segment) noexcept
    : motions_(curve, segment, MotionPart::all), segment_(segment) {
  if (motions_.is_gap()) return;
  const KnotSpan span = curve.knots().span(segment);
  const auto within = [&](double u) { return std::lerp(span.start(), span.end(), u); };
  const std::array times{span.start(), within(0.25), within(0.5), within(0.75), span.end()};
  motions_.evaluate(times);
  count_ = times.size();
  for (std::size_t k = 0; k < count_; ++k) probes_[k] = {times[k], motions_.motion(k)};
}

OrientationJump Probes::jump() noexcept {
  for (std::size_t k = 0; k + 1 < count_; ++k)
    if (const OrientationJump found = jump_between(probes_[k], probes_[k + 1]); found.angle > 0.0) return found;
  return {};
}

OrientationJump Probes::jump_between(const TimedMotion& a, const TimedMotion& b, int depth) noexcept {
  const Eigen::Quaterniond &from = a.motion.orientation, &to = b.motion.orientation;
  const double rate = std::max(a.motion.angular_velocity.squaredNorm(), b.motion.angular_velocity.squaredNorm());
  const double reach = std::sqrt(rate) * (b.time - a.time), longest = 2.0 * reach + smallest_jump;
  const bool jumps = longest_way(from, to) > longest && angular_distance(from, to) > longest;
  if (!jumps && (reach <= widest_look || depth >= deepest_look)) return {};
  const double middle = std::midpoint(a.time, b.time);
  if (!(a.time < middle && middle < b.time))
    return {.angle = jumps ? angular_distance(from, to) : 0.0, .time = a.time, .key = segment_};
  motions_.evaluate({&middle, 1});
  const TimedMotion between_them{middle, motions_.motion(0)};
  const OrientationJump first = jump_between(a, between_them, depth + 1);
  return first.angle > 0.0 ? first : jump_between(between_them, b, depth + 1);
}

}}  // namespace orispline
