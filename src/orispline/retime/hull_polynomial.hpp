// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include <orispline/curve/segment_form.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A polynomial of u in [0, 1], in Bernstein form: its values lie in the hull of its coefficients.
struct HullPolynomial {
  BernsteinForm form;
  std::size_t degree;
};
using HullDerivatives = std::array<HullPolynomial, 6>;  ///< in time, of orders 0 to 5
using HullVector = std::array<HullPolynomial, 3>;       ///< components, of one degree

/// `duration` [s], of u from 0 to 1.
[[nodiscard]] HullDerivatives derivatives_of(const BernsteinForm& form, std::size_t degree, double duration);

/// The same polynomial over a part of [0, 1], by de Casteljau's algorithm.
[[nodiscard]] HullPolynomial restricted(HullPolynomial p, double start, double end);

/// The size that no value exceeds.
[[nodiscard]] double largest(const HullPolynomial& p);

[[nodiscard]] Eigen::Vector3d coefficient(const HullVector& components, std::size_t i);

/// The length that no vector of these components exceeds.
[[nodiscard]] double longest(const HullVector& components);

}}  // namespace orispline
