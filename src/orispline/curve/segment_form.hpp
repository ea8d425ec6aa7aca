// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <variant>

#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Largest degree of the polynomials in which a segment may state itself.
inline constexpr std::size_t form_degree = 7;

/// Bernstein coefficients of a polynomial of the given degree; those beyond it are zero.
struct BernsteinForm {
  std::array<double, form_degree + 1> coefficients{};
};

/// A segment q(u) = base ∏ exp(β̃_k(u) φ_k) of up to three factors, u in [0, 1]; factors that are absent have φ = 0.
struct CumulativeForm {
  std::size_t degree;
  Eigen::Quaterniond base;
  std::array<Eigen::Vector3d, 3> increments;
  std::array<BernsteinForm, 3> blending;
};

/// A segment q(u) = base exp(ψ(u)), ψ a polynomial rotation vector; by component.
struct ChartForm {
  std::size_t degree;
  Eigen::Quaterniond base;
  std::array<BernsteinForm, 3> rotation_vector;
};

/// A segment q(u) = s(u)/|s(u)|, s a cubic of R⁴; by component: qx, qy, qz, qw.
struct RationalForm {
  static constexpr std::size_t degree = 3;
  std::array<BernsteinForm, 4> components{};
};

/// What a segment is made of, where it is made of polynomials: for evaluation in bulk.
using SegmentForm = std::variant<std::monostate, CumulativeForm, ChartForm, RationalForm>;

}}  // namespace orispline
