// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/curve/cumulative_basis.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline {

/// Control points of a cumulative curve in space [m].
using PathPolygon = std::vector<Eigen::Vector3d>;

/// p(t) = p₀ + Σ β̃_k(t) (p_k - p_{k-1}) over any Number, on one knot span.
template <CumulativeBasis B, Number T>
[[nodiscard]] Vector3<T> cumulative_position(const B& basis, KnotSpan span, const T& t,
                                             std::span<const Eigen::Vector3d, B::increments + 1> points) noexcept {
  const std::array<T, B::increments> b = basis(span, t);
  Vector3<T> p = constant<T>(points[0]);
  for (std::size_t k = 0; k < B::increments; ++k) p += constant<T>(Eigen::Vector3d(points[k + 1] - points[k])) * b[k];
  return p;
}

/// The Euclidean curve of the same blending functions: p(t) = p₀ + Σ β̃_k(t) (p_k - p_{k-1}).
///
/// Source: the papers' curves in R^d (Tan 2018, (3.1); 003 §3.1.1), written cumulatively.
template <CumulativeBasis B>
class CumulativePath {
 public:
  static constexpr int degree = B::degree;

  CumulativePath(Knots knots, B basis, PathPolygon points)
      : knots_(std::move(knots)), basis_(std::move(basis)), points_(std::move(points)) {
    ORISPLINE_EXPECT(points_.size() > (knots_.segments() - 1) * B::stride + B::increments);
  }

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }

  template <Number T>
  [[nodiscard]] Vector3<T> position(const T& t, std::size_t segment) const noexcept {
    constexpr std::size_t count = B::increments + 1;
    return cumulative_position(basis_, knots_.span(segment), t,
                               std::span<const Eigen::Vector3d, count>(points_.data() + segment * B::stride, count));
  }

 private:
  Knots knots_;
  [[no_unique_address]] B basis_;
  PathPolygon points_;
};

}  // namespace orispline
