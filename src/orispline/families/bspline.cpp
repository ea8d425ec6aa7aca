// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/bspline.hpp>

#include <orispline/curve/bspline_basis.hpp>
#include <orispline/curve/cumulative_curve.hpp>
#include <orispline/curve/cumulative_path.hpp>
#include <orispline/curve/reflected.hpp>

namespace orispline::families {
namespace {

/// Control points on either side of a span's first one, beyond the two that it lies between.
constexpr std::ptrdiff_t ghosts(std::size_t degree) { return static_cast<std::ptrdiff_t>(degree) / 2; }

double continued(std::span<const double> t, std::ptrdiff_t i) {
  const auto last = static_cast<std::ptrdiff_t>(t.size()) - 1;
  if (i < 0) return t[0] + static_cast<double>(i) * (t[1] - t[0]);
  if (i > last) return t.back() + static_cast<double>(i - last) * (t.back() - t[t.size() - 2]);
  return t[static_cast<std::size_t>(i)];
}

/// Odd degrees: the key times, continued. Even degrees: their midpoints, continued. The curve's own spans end at the
/// first and the last key time.
template <std::size_t Degree>
std::vector<double> basis_knots(std::span<const double> t) {
  constexpr auto beyond = static_cast<std::ptrdiff_t>(Degree) - 1;
  constexpr bool even = Degree % 2 == 0;
  const auto keys = static_cast<std::ptrdiff_t>(t.size());
  std::vector<double> knots;
  for (std::ptrdiff_t i = even ? -1 - beyond : -beyond; i < keys + beyond; ++i)
    knots.push_back(even ? 0.5 * (continued(t, i) + continued(t, i + 1)) : continued(t, i));
  return knots;
}

template <std::size_t Degree>
Knots curve_knots(std::span<const double> t) {
  if constexpr (Degree % 2 == 1) return Knots({t.begin(), t.end()});
  std::vector<double> knots{t.front()};
  for (std::size_t i = 0; i + 1 < t.size(); ++i) knots.push_back(0.5 * (t[i] + t[i + 1]));
  knots.push_back(t.back());
  return Knots(std::move(knots));
}

/// The first control point of span 0: half of the degree before the key where the curve starts.
template <std::size_t Degree>
constexpr std::ptrdiff_t first_point = Degree % 2 == 0 ? -ghosts(Degree)
                                                       : 1 - static_cast<std::ptrdiff_t>(Degree + 1) / 2;

template <std::size_t Degree>
AnyCurve curve_of_degree(const Keyframes& keys) {
  using Basis = BSplineBasis<Degree>;
  const auto points = reflected(keys.orientations());
  Knots knots = curve_knots<Degree>(keys.times());
  ControlPolygon polygon;
  const auto spans = static_cast<std::ptrdiff_t>(knots.segments());
  for (std::ptrdiff_t i = 0; i + 1 < spans + static_cast<std::ptrdiff_t>(Degree); ++i) {
    const Eigen::Quaterniond from = points[first_point<Degree> + i], to = points[first_point<Degree> + i + 1];
    if (i < spans) polygon.bases.push_back(from);
    polygon.increments.push_back(increment<double>(from, to));
  }
  return CumulativeCurve<Basis>(std::move(knots), Basis{basis_knots<Degree>(keys.times())}, std::move(polygon));
}

template <std::size_t Degree>
AnyPath path_of_degree(const Keyframes& keys) {
  using Basis = BSplineBasis<Degree>;
  const auto points = reflected(keys.positions());
  Knots knots = curve_knots<Degree>(keys.times());
  PathPolygon polygon;
  const auto count = static_cast<std::ptrdiff_t>(knots.segments() + Degree);
  for (std::ptrdiff_t i = 0; i < count; ++i) polygon.push_back(points[first_point<Degree> + i]);
  return CumulativePath<Basis>(std::move(knots), Basis{basis_knots<Degree>(keys.times())}, std::move(polygon));
}

template <class Built, class Make>
Expected<Built> with_degree(const FamilySettings& settings, Make make) {
  return settings.whole("degree").map([&](int degree) -> Built {
    switch (degree) {
      case 2:
        return make(std::integral_constant<std::size_t, 2>{});
      case 3:
        return make(std::integral_constant<std::size_t, 3>{});
      case 4:
        return make(std::integral_constant<std::size_t, 4>{});
      default:
        return make(std::integral_constant<std::size_t, 5>{});
    }
  });
}

}  // namespace

Expected<AnyCurve> BSpline::curve(const Keyframes& keys, const FamilySettings& settings) {
  return with_degree<AnyCurve>(settings, [&](auto degree) { return curve_of_degree<degree()>(keys); });
}

Expected<AnyPath> BSpline::path(const Keyframes& keys, const FamilySettings& settings) {
  return with_degree<AnyPath>(settings, [&](auto degree) { return path_of_degree<degree()>(keys); });
}

}  // namespace orispline::families
