// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/hull_polynomial.hpp>

#include <algorithm>
#include <cmath>

namespace orispline { inline namespace ORISPLINE_ABI {

HullDerivatives derivatives_of(const BernsteinForm& form, std::size_t degree, double duration) {
  HullDerivatives all{HullPolynomial{form, degree}};
  for (std::size_t order = 1; order < all.size(); ++order) {
    const HullPolynomial& before = all[order - 1];
    HullPolynomial& next = all[order];
    next.degree = before.degree > 0 ? before.degree - 1 : 0;
    const double factor = static_cast<double>(before.degree) / duration;
    for (std::size_t i = 0; i < before.degree; ++i)
      next.form.coefficients[i] = factor * (before.form.coefficients[i + 1] - before.form.coefficients[i]);
  }
  return all;
}

HullPolynomial restricted(HullPolynomial p, double start, double end) {
  auto& c = p.form.coefficients;
  for (std::size_t r = 1; r <= p.degree; ++r)
    for (std::size_t i = p.degree; i >= r; --i) c[i] = (1.0 - end) * c[i - 1] + end * c[i];
  const double place = end > 0.0 ? start / end : 0.0;
  for (std::size_t r = 1; r <= p.degree; ++r)
    for (std::size_t i = 0; i + r <= p.degree; ++i) c[i] = (1.0 - place) * c[i] + place * c[i + 1];
  return p;
}

double largest(const HullPolynomial& p) {
  double value = 0.0;
  for (std::size_t i = 0; i <= p.degree; ++i) value = std::max(value, std::abs(p.form.coefficients[i]));
  return value;
}

Eigen::Vector3d coefficient(const HullVector& components, std::size_t i) {
  return {components[0].form.coefficients[i], components[1].form.coefficients[i], components[2].form.coefficients[i]};
}

double longest(const HullVector& components) {
  double length = 0.0;
  for (std::size_t i = 0; i <= components[0].degree; ++i) length = std::max(length, coefficient(components, i).norm());
  return length;
}

}}  // namespace orispline
