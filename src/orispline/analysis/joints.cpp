// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/joints.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double smallest_jump = 1e-6;  // [rad]
/// Where a body turns by more than this between two times [rad], it is looked at between them, but not more often than
/// so many times over: a jump is found where it is not small beside what the curve turns meanwhile.
constexpr double widest_look = 0.1;
constexpr int deepest_look = 6;

class JumpSearch {
 public:
  JumpSearch(const AnyCurve& curve, std::size_t segment) : curve_(curve), segment_(segment) {}

  [[nodiscard]] OrientationJump between(const TimedMotion& a, const TimedMotion& b, int depth = 0) const noexcept {
    const double way = angular_distance(a.motion.orientation, b.motion.orientation);
    const double reach =
        std::max(a.motion.angular_velocity.norm(), b.motion.angular_velocity.norm()) * (b.time - a.time);
    const bool jumps = way > 2.0 * reach + smallest_jump;
    if (!jumps && (reach <= widest_look || depth >= deepest_look)) return {};
    const double middle = std::midpoint(a.time, b.time);
    if (!(a.time < middle && middle < b.time))
      return jumps ? OrientationJump{.angle = way, .time = a.time, .key = segment_} : OrientationJump{};
    const TimedMotion between_them{middle, curve_.motion_on(segment_, middle)};
    const OrientationJump first = between(a, between_them, depth + 1);
    return first.angle > 0.0 ? first : between(between_them, b, depth + 1);
  }

 private:
  const AnyCurve& curve_;
  std::size_t segment_;
};

}  // namespace

std::array<TimedMotion, 5> probes_of(const AnyCurve& curve, std::size_t segment) noexcept {
  const KnotSpan span = curve.knots().span(segment);
  const auto at = [&](double t) -> TimedMotion { return {t, curve.motion_on(segment, t)}; };
  const auto within = [&](double u) { return at(std::lerp(span.start(), span.end(), u)); };
  return {at(span.start()), within(0.25), within(0.5), within(0.75), at(span.end())};
}

OrientationJump jump_between(std::span<const TimedMotion> probes, const AnyCurve& curve, std::size_t segment) noexcept {
  const JumpSearch search(curve, segment);
  for (std::size_t k = 0; k + 1 < probes.size(); ++k)
    if (const OrientationJump found = search.between(probes[k], probes[k + 1]); found.angle > 0.0) return found;
  return {};
}

}}  // namespace orispline
