// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/blend.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <orispline/curve/reflected.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

/// Keys nearer to each other than this in R⁴ do not tell the circle through them.
constexpr double nearest_keys_of_a_circle = 1e-6;

/// Three neighbouring points with their times.
template <CurvePoint Point>
struct Triple {
  Point previous, key, next;
  double time, before, after;  ///< of the key; steps to its neighbours [s]

  /// The displacements to the neighbours, backwards along the way that arrives: of a full turn the logarithm could not
  /// tell which way it was.
  [[nodiscard]] Displacement<Point> to_previous() const { return -displacement<double>(previous, key); }
  [[nodiscard]] Displacement<Point> to_next() const { return displacement<double>(key, next); }

  /// The parabola from its values at the neighbours.
  template <class Value>
  [[nodiscard]] ParabolaThroughZero<Value> parabola(const Value& at_previous, const Value& at_next) const {
    const Value quadratic = (at_next / after + at_previous / before) / (before + after);
    return {.linear = before * quadratic - at_previous / before, .quadratic = quadratic};
  }
};

template <CurvePoint Point>
Parabola<Point> chart_parabola(const Triple<Point>& p) {
  return {p.key, p.time, p.template parabola<Displacement<Point>>(p.to_previous(), p.to_next())};
}

/// The stereographic image of `q` seen from `centre`, which itself goes to infinity: circles through the centre become
/// straight lines.
Eigen::Vector3d stereographic(const Eigen::Quaterniond& centre, const Eigen::Quaterniond& q) {
  const Eigen::Vector3d phi = increment<double>(centre, q);
  const double angle = phi.norm();
  double sine, cosine;
  sin_cos(0.25 * angle, sine, cosine);
  return phi * (cosine / (angle * sine));
}

CircleOrParabola circle(const Triple<Eigen::Quaterniond>& p) {
  const auto chord = [](const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
    return (a.coeffs() - b.coeffs()).norm();
  };
  if (std::min({chord(p.previous, p.key), chord(p.key, p.next), chord(p.previous, p.next)}) < nearest_keys_of_a_circle)
    return chart_parabola(p);
  const Eigen::Vector3d previous = stereographic(p.key, p.previous), next = stereographic(p.key, p.next);
  const Eigen::Vector3d tangent = (next - previous).normalized();
  const Eigen::Vector3d bend = tangent.cross(previous.cross(next)) / (next - previous).norm();  // the line's foot
  const bool back = previous.dot(next) > 0.0;
  if (back && bend.norm() <= one_axis_tolerance) return chart_parabola(p);
  const double radius = 1.0 / std::sqrt(1.0 + bend.squaredNorm());
  // On the line the distance from the foot is cot(φ/2)/ρ.
  const auto angle_to = [&](const Eigen::Vector3d& y) { return 2.0 * atan2_of(1.0, radius * tangent.dot(y)); };
  const double ahead = angle_to(next), behind = angle_to(previous) - 2.0 * std::numbers::pi;
  return CircularArc{p.key, p.time, tangent, bend, radius, p.parabola(behind, ahead)};
}

/// The primitive of every key, a reflected ghost beside either end.
template <class Point, class Rule>
auto primitives(std::span<const Point> points, std::span<const double> times, Rule rule) {
  const auto p = reflected(points);
  const auto t = reflected(times);
  std::vector<decltype(rule(std::declval<Triple<Point>>()))> all;
  for (std::ptrdiff_t i = 0; i < std::ssize(points); ++i)
    all.push_back(rule(Triple<Point>{p[i - 1], p[i], p[i + 1], t[i], t[i] - t[i - 1], t[i + 1] - t[i]}));
  return all;
}

template <class Blended, class Point, class Rule>
Expected<Blended> blended(std::span<const Point> points, std::span<const double> times, const FamilySettings& settings,
                          Rule rule) {
  return settings.whole("order").map([&](int order) {
    return Blended(Knots({times.begin(), times.end()}), primitives(points, times, rule), order);
  });
}

}  // namespace

template <CurvePoint P>
Expected<BlendedParabolas<P>> LogParabola::curve(const Keyframes& keys, const FamilySettings& settings) {
  return blended<BlendedParabolas<P>>(keys.points<P>(), keys.times(), settings, chart_parabola<P>);
}

template Expected<BlendedParabolas<Eigen::Quaterniond>> LogParabola::curve<Eigen::Quaterniond>(const Keyframes&,
                                                                                               const FamilySettings&);
template Expected<BlendedParabolas<Eigen::Vector3d>> LogParabola::curve<Eigen::Vector3d>(const Keyframes&,
                                                                                         const FamilySettings&);

Expected<Circular::Curve> Circular::curve(const Keyframes& keys, const FamilySettings& settings) {
  return blended<Curve>(keys.orientations(), keys.times(), settings, circle);
}

}}}  // namespace orispline::families
