// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/bspline.hpp>

#include <orispline/curve/bspline_basis.hpp>
#include <orispline/curve/cumulative_curve.hpp>
#include <orispline/curve/reflected.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

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

template <std::size_t Degree, CurvePoint P>
AnyCurveThrough<P> curve_of_degree(const Keyframes& keys) {
  const auto continued_points = reflected(keys.points<P>());
  Knots knots = curve_knots<Degree>(keys.times());
  std::vector<P> points;
  const auto count = static_cast<std::ptrdiff_t>(knots.segments() + Degree);
  for (std::ptrdiff_t i = 0; i < count; ++i) points.push_back(continued_points[first_point<Degree> + i]);
  return CumulativeCurve<BSplineBasis<Degree>, P>(std::move(knots), {basis_knots<Degree>(keys.times())}, points);
}

}  // namespace

template <CurvePoint P>
Expected<AnyCurveThrough<P>> BSpline::curve(const Keyframes& keys, const FamilySettings& settings) {
  return settings.whole("degree").map([&](int degree) {
    switch (degree) {
      case 2:
        return curve_of_degree<2, P>(keys);
      case 3:
        return curve_of_degree<3, P>(keys);
      case 4:
        return curve_of_degree<4, P>(keys);
      default:
        return curve_of_degree<5, P>(keys);
    }
  });
}

template Expected<AnyCurveThrough<Eigen::Quaterniond>> BSpline::curve<Eigen::Quaterniond>(const Keyframes&,
                                                                                          const FamilySettings&);
template Expected<AnyCurveThrough<Eigen::Vector3d>> BSpline::curve<Eigen::Vector3d>(const Keyframes&,
                                                                                    const FamilySettings&);

}}}  // namespace orispline::families
