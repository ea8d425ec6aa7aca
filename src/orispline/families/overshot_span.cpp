// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/overshot_span.hpp>

#include <algorithm>
#include <numbers>

#include <orispline/base/formatted.hpp>
#include <orispline/families/span_curve.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double share_of_step = 0.5;     // which the method `monotone` keeps within
constexpr double share_of_beside = 0.25;  // the parabola through four keys whose middle ones are equal has an eighth
constexpr double least_swing = radians_per_degree;
constexpr double least_ratio = 2.0;  // of a span that is looked at
constexpr int looks = 16;            // at a span

/// The shortest way from one orientation to another.
class ShortestWay {
 public:
  ShortestWay(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to)
      : from_(from), step_(increment<double>(from, to)), angle_(step_.norm()) {}

  [[nodiscard]] double angle() const { return angle_; }
  /// How far an orientation is from it [rad].
  [[nodiscard]] double distance(const Eigen::Quaterniond& q) const {
    const Eigen::Quaterniond turned = from_.conjugate() * q;
    const double along = angle_ > 0.0 ? 2.0 * atan2_of(turned.vec().dot(step_) / angle_, turned.w()) : 0.0;
    double nearest = std::min(at_distance(0.0, q), at_distance(angle_, q));
    for (const double turn : {along, along + 2.0 * std::numbers::pi})  // of q and of -q
      if (turn > 0.0 && turn < angle_) nearest = std::min(nearest, at_distance(turn, q));
    return nearest;
  }

 private:
  [[nodiscard]] double at_distance(double turn, const Eigen::Quaterniond& q) const {
    return angular_distance(angle_ > 0.0 ? from_ * exp<double>(turn / angle_ * step_) : from_, q);
  }

  Eigen::Quaterniond from_;
  Eigen::Vector3d step_;
  double angle_;
};

double swing_of(const SpanCurve& curve, const ShortestWay& way) {
  double farthest = 0.0;
  for (int i = 1; i < looks; ++i) farthest = std::max(farthest, way.distance(curve.at(static_cast<double>(i) / looks)));
  return farthest;
}

double turn_after(const Keyframes& keys, std::size_t i) {
  return angular_distance(keys.orientations()[i], keys.orientations()[i + 1]);
}

/// What is worth saying of a span whose keys are so far apart.
double least_said(const Keyframes& keys, std::size_t span, double step) {
  const double before = span > 0 ? turn_after(keys, span - 1) : 0.0;
  const double after = span + 2 < keys.size() ? turn_after(keys, span + 1) : 0.0;
  return std::max({least_swing, share_of_step * step, share_of_beside * std::max(before, after)});
}

}  // namespace

std::optional<Warning> overshot_span(const Method& method, const FamilyInfo& family, const Track& track,
                                     const AnyCurve* made) {
  const Keyframes& keys = track.keys;
  if (!family.interpolates || family.key_use.stride > 1 || keys.size() < 3) return std::nullopt;
  std::size_t found = 0;
  double farthest = 0.0, step = 0.0;
  for (const SuspiciousSpan& span : suspicious_spans(keys, least_swing, least_ratio)) {
    if (keys.rests_after(span.start)) continue;  // which moving_rests tells
    const auto curve = made ? span_of(*made, keys, span.start) : span_of(method, keys, span.start);
    if (!curve) continue;
    const ShortestWay way(keys.orientations()[span.start], keys.orientations()[span.start + 1]);
    const double swing = swing_of(*curve, way);
    if (swing <= std::max(farthest, least_said(keys, span.start, way.angle()))) continue;
    found = span.start;
    farthest = swing;
    step = way.angle();
  }
  if (!(farthest > 0.0)) return std::nullopt;
  return Warning{
      .code = "overshot_span",
      .message = formatted("{} the curve of {} swings {:.4g} degrees away from the shortest way, where the keys are "
                           "{:.4g} apart; take monotone, which stays near its keys",
                           between_keys(track, found), method.name, farthest * degrees, step * degrees),
      .where = {.key = found},
      .numbers = {{"swing_deg", farthest * degrees}, {"step_deg", step * degrees}}};
}

}}  // namespace orispline
