// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/biarcs.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include <orispline/curve/four_key_curve.hpp>
#include <orispline/curve/monotone_rates.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

/// A body that turns by more than this from one step to the next stops in the key between: the cosine of 150°.
constexpr double turns_back = -0.86602540378443864676;
/// One that is so many times slower on one side of a key than on the other stops in it.
constexpr double slower = 1e-3;
/// Shorter steps [rad], [m] are none: their squares vanish.
constexpr double least_step = 1e-150;

/// The points to go through, those of a loop two beyond its seam on either side: a segment looks that far.
template <CurvePoint P>
struct Course {
  std::vector<P> points;
  std::vector<double> steps;  ///< from each point to the next [s]
  std::size_t first = 0;      ///< the point where the curve begins
};

Eigen::Quaterniond with_sign(const Eigen::Quaterniond& q, double sign) {
  return Eigen::Quaterniond(Eigen::Vector4d(sign * q.coeffs()));
}
Eigen::Vector3d with_sign(const Eigen::Vector3d& p, double) { return p; }

template <CurvePoint P>
Course<P> course_of(const Keyframes& keys, const FamilySettings& settings, const Knots& knots) {
  const auto points = keys.points<P>();
  const auto n = static_cast<std::ptrdiff_t>(points.size());
  if (!settings.closure) {
    Course<P> course{.points = {points.begin(), points.end()}, .steps = {}};
    for (std::size_t i = 0; i < knots.segments(); ++i) course.steps.push_back(knots.span(i).step());
    return course;
  }
  constexpr std::ptrdiff_t beyond = 2;
  Course<P> course{.points = {}, .steps = {}, .first = beyond};
  for (std::ptrdiff_t k = -beyond; k <= n + beyond; ++k) {
    const std::ptrdiff_t round = k < 0 ? -((n - 1 - k) / n) : k / n, key = k - round * n;
    const double sign = round % 2 == 0 ? 1.0 : settings.closure->sign;
    course.points.push_back(with_sign(points[static_cast<std::size_t>(key)], sign));
    if (k < n + beyond) course.steps.push_back(knots.span(static_cast<std::size_t>(key)).step());
  }
  return course;
}

/// The direction at a key between the displacements on either side, or none where the curve stops in it.
///
/// That of the parabola through the three keys, drawn to the middle of a sharp turn, so that it leads on from both
/// steps.
std::optional<Eigen::Vector3d> direction_between(const Eigen::Vector3d& before, double step_before,
                                                 const Eigen::Vector3d& after, double step_after) {
  const double a = before.norm(), b = after.norm(), speed_a = a / step_before, speed_b = b / step_after;
  if (std::min(a, b) < least_step || std::min(speed_a, speed_b) < slower * std::max(speed_a, speed_b))
    return std::nullopt;
  const Eigen::Vector3d unit_a = before / a, unit_b = after / b;
  const double cosine = unit_a.dot(unit_b);
  if (cosine < turns_back) return std::nullopt;
  double weight_a = speed_a * step_after, weight_b = speed_b * step_before;
  if (cosine < 0.0) {
    const double widest = 1.0 / std::sqrt(-cosine);
    weight_a = std::min(weight_a, weight_b * widest);
    weight_b = std::min(weight_b, weight_a * widest);
  }
  return (weight_a * unit_a + weight_b * unit_b).normalized();
}

/// A direction of the body, or of space, as a unit tangent of what the points lie in.
Eigen::Vector4d tangent_at(const Eigen::Quaterniond& q, const Eigen::Vector3d& direction) {
  return (q * Eigen::Quaterniond(0.0, direction.x(), direction.y(), direction.z())).coeffs();
}
Eigen::Vector3d tangent_at(const Eigen::Vector3d&, const Eigen::Vector3d& direction) { return direction; }

/// From a point to the one that a displacement leads to: the difference of the two, as exact as the displacement is.
Eigen::Vector4d chord_along(const Eigen::Quaterniond& from, const Eigen::Vector3d& displacement) {
  const double size = displacement.norm();
  double sine, cosine, half_sine, half_cosine;
  sin_cos(0.5 * size, sine, cosine);
  sin_cos(0.25 * size, half_sine, half_cosine);
  const Eigen::Vector3d across = sine * (displacement / size);
  return (from * Eigen::Quaterniond(-2.0 * half_sine * half_sine, across.x(), across.y(), across.z())).coeffs();
}
Eigen::Vector3d chord_along(const Eigen::Vector3d&, const Eigen::Vector3d& displacement) { return displacement; }

/// The path between two points with the tangents that their keys ask for; one that is not asked for makes it one arc.
template <CurvePoint P>
Biarc<Ambient<P>> path_between(const P& from, const std::optional<Eigen::Vector3d>& leaving, const P& to,
                               const std::optional<Eigen::Vector3d>& arriving, const Eigen::Vector3d& displacement) {
  using V = Ambient<P>;
  const V start = ambient(from), end = ambient(to);
  const double size = displacement.norm();
  if (size < least_step) return {{.start = start}, {.start = end}};
  const V chord = chord_along(from, displacement);
  const auto mirrored_at_chord = [unit = V(chord.normalized())](const V& t) -> V {
    return 2.0 * unit.dot(t) * unit - t;
  };
  if (!leaving && !arriving) {
    const Eigen::Vector3d straight = displacement / size;
    return Biarc<V>::between(start, tangent_at(from, straight), end, tangent_at(to, straight), chord);
  }
  const V first = leaving ? tangent_at(from, *leaving) : mirrored_at_chord(tangent_at(to, *arriving));
  const V last = arriving ? tangent_at(to, *arriving) : mirrored_at_chord(tangent_at(from, *leaving));
  return Biarc<V>::between(start, first, end, last, chord);
}

/// The speed at an end, times the duration h: none, or the one that does not change there.
double speed_at_end(EndRule rule, double length, double other) {
  return rule == EndRule::rest ? 0.0 : 0.5 * (3.0 * length - other);
}

/// The speeds at the keys where the curve does not stop, and those at the ends of the whole.
template <class Piece>
void set_speeds(std::vector<Piece>& pieces, std::span<const std::optional<Eigen::Vector3d>> directions,
                std::span<const double> steps, const FamilySettings& settings) {
  const auto mean_speed = [&](std::size_t i) { return pieces[i].path.length() / steps[i]; };
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    if (!directions[i]) continue;
    const double speed = harmonic_speed(mean_speed(i - 1), steps[i - 1], mean_speed(i), steps[i]);
    pieces[i - 1].end_speed = speed * steps[i - 1];
    pieces[i].start_speed = speed * steps[i];
  }
  Piece &start = pieces.front(), &end = pieces.back();
  if (pieces.size() == 1 && settings.end.rule != EndRule::rest) end.end_speed = end.path.length();
  start.start_speed = speed_at_end(settings.start.rule, start.path.length(), start.end_speed);
  end.end_speed = speed_at_end(settings.end.rule, end.path.length(), end.start_speed);
}

}  // namespace

template <CurvePoint P>
Expected<BiarcCurve<P>> Biarcs::curve(const Keyframes& keys, const FamilySettings& settings) {
  Knots knots = four_key_knots(keys, settings);
  const Course<P> course = course_of<P>(keys, settings, knots);
  const auto& [points, steps, first] = course;
  const std::size_t last = steps.size();
  const std::vector<Eigen::Vector3d> displacements = increments_between(points);
  std::vector<std::optional<Eigen::Vector3d>> directions(last + 1);
  for (std::size_t i = 1; i < last; ++i)
    directions[i] = direction_between(displacements[i - 1], steps[i - 1], displacements[i], steps[i]);
  std::vector<typename BiarcCurve<P>::Piece> pieces;
  for (std::size_t i = 0; i < last; ++i)
    pieces.push_back(
        {path_between(points[i], directions[i], points[i + 1], directions[i + 1], displacements[i]), 0.0, 0.0});
  set_speeds(pieces, directions, steps, settings);
  const auto begin = pieces.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = begin + static_cast<std::ptrdiff_t>(knots.segments());
  return BiarcCurve<P>(std::move(knots), {begin, end});
}

template Expected<BiarcCurve<Eigen::Quaterniond>> Biarcs::curve<Eigen::Quaterniond>(const Keyframes&,
                                                                                    const FamilySettings&);
template Expected<BiarcCurve<Eigen::Vector3d>> Biarcs::curve<Eigen::Vector3d>(const Keyframes&, const FamilySettings&);

}}}  // namespace orispline::families
