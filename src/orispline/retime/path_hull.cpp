// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/path_hull.hpp>

#include <algorithm>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Of evaluation and of the coefficients, of the size of what they are made of.
constexpr double path_rounding_share = 1e-13;

/// The coefficients of a velocity of this degree in u from what it is at both ends: value and two derivatives each;
/// that in the middle of degree 6 from the distance, which is their mean. Farin, Curves and Surfaces for CAGD, 5.2.
std::array<Eigen::Vector3d, form_degree> coefficients_of(std::size_t degree, const LinearMotion& a,
                                                         const LinearMotion& b, double h) {
  std::array<Eigen::Vector3d, form_degree> c{};
  const double m = static_cast<double>(degree), bend = degree > 1 ? h * h / (m * (m - 1.0)) : 0.0;
  const double slope = degree > 0 ? h / m : 0.0;
  const std::array from_start{a.velocity, Eigen::Vector3d(a.velocity + slope * a.acceleration),
                              Eigen::Vector3d(bend * a.jerk + a.velocity + 2.0 * slope * a.acceleration)};
  const std::array from_end{b.velocity, Eigen::Vector3d(b.velocity - slope * b.acceleration),
                            Eigen::Vector3d(bend * b.jerk + b.velocity - 2.0 * slope * b.acceleration)};
  for (std::size_t i = 0; i <= std::min<std::size_t>(degree, 2); ++i) c[i] = from_start[i];
  for (std::size_t i = 0; i < std::min<std::size_t>(degree, 3) && degree - i > 2; ++i) c[degree - i] = from_end[i];
  if (degree == 6) {
    c[3] = 7.0 * (b.position - a.position) / h;
    for (std::size_t i = 0; i <= degree; ++i)
      if (i != 3) c[3] -= c[i];
  }
  return c;
}

}  // namespace

std::optional<PathHull> PathHull::of(const AnyPath& path, std::size_t segment) {
  if (path.degree() < 1 || path.degree() > static_cast<int>(form_degree)) return std::nullopt;
  const auto degree = static_cast<std::size_t>(path.degree() - 1);
  const KnotSpan span = path.knots().span(segment);
  const LinearMotion start = path.linear_motion_on(segment, span.start()),
                     end = path.linear_motion_on(segment, span.end());
  const auto c = coefficients_of(degree, start, end, span.step());
  PathHull hull;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    BernsteinForm form;
    for (std::size_t i = 0; i <= degree; ++i) form.coefficients[i] = c[i][static_cast<Eigen::Index>(axis)];
    const HullDerivatives derivatives = derivatives_of(form, degree, span.step());
    hull.velocity_[axis] = derivatives[0];
    hull.acceleration_[axis] = derivatives[1];
  }
  const double size = std::max(start.position.norm(), end.position.norm()) / span.step();
  hull.rounding_[0] = path_rounding_share * (size + longest(hull.velocity_));
  hull.rounding_[1] =
      path_rounding_share * static_cast<double>(path.degree()) * (size + longest(hull.velocity_)) / span.step();
  return hull;
}

double PathHull::rounding(const LimitedQuantity& quantity) const {
  return rounding_[quantity.vector == LimitedQuantity::Vector::speed ? 0 : 1];
}

double PathHull::bound(const LimitedQuantity& quantity, double start, double end) const {
  const HullVector& whole = quantity.vector == LimitedQuantity::Vector::speed ? velocity_ : acceleration_;
  if (quantity.axis) return largest(restricted(whole[*quantity.axis], start, end)) + rounding(quantity);
  return longest(
             {restricted(whole[0], start, end), restricted(whole[1], start, end), restricted(whole[2], start, end)}) +
         rounding(quantity);
}

}}  // namespace orispline
