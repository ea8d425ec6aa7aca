// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/curve/knots.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/math/series.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The space that a point of a kind lies in: unit quaternions in R⁴ (qx, qy, qz, qw), positions in R³.
template <CurvePoint P>
using Ambient = std::conditional_t<std::same_as<P, Eigen::Quaterniond>, Eigen::Vector4d, Eigen::Vector3d>;

[[nodiscard]] inline Eigen::Vector4d ambient(const Eigen::Quaterniond& q) noexcept { return q.coeffs(); }
[[nodiscard]] inline Eigen::Vector3d ambient(const Eigen::Vector3d& p) noexcept { return p; }

/// An arc of a circle, or a straight line, from a point with a unit tangent there and the curvature towards the centre.
///
/// A circle through two points of S³ with a tangent of S³ at one of them lies on S³.
template <class V>
struct Arc {
  V start = V::Zero(), tangent = V::Zero(), curvature = V::Zero();
  double length = 0.0;

  /// The arc from `start` with that unit tangent to the point a chord farther, less than half a circle.
  [[nodiscard]] static Arc along(const V& start, const V& tangent, const V& chord) noexcept {
    const double square = chord.squaredNorm(), size = std::sqrt(square), ahead = chord.dot(tangent);
    if (!(square > 0.0)) return {.start = start, .tangent = tangent};
    const V aside = chord - ahead * tangent;
    const double half = atan2_of(aside.norm(), ahead);  // half the angle of the arc
    return {start, tangent, (2.0 / square) * aside, size / series::sinc_sqrt(half * half)};
  }

  /// The point so far along the arc.
  template <Number T>
  [[nodiscard]] Eigen::Matrix<T, V::RowsAtCompileTime, 1> at(const T& way) const noexcept {
    const T x = way * way * Plain<T>(curvature.squaredNorm());
    const T ahead = way * series::sinc_sqrt<T>(x), aside = way * way * series::versine_ratio<T>(x);
    Eigen::Matrix<T, V::RowsAtCompileTime, 1> point;
    for (Eigen::Index k = 0; k < V::RowsAtCompileTime; ++k)
      point[k] = T(start[k]) + ahead * Plain<T>(tangent[k]) + aside * Plain<T>(curvature[k]);
    return point;
  }
};

/// Two arcs that meet with one tangent: the first from the start on, the second from the end backwards.
///
/// With b₁ = p₀ + λ t₀ and b₃ = p₁ - λ t₁ they meet in b₂ = (b₁ + b₃)/2, where |b₃ - b₁| = 2λ, which is the positive
/// root of (4 - |t₀ + t₁|²) λ² + 2 (p₁ - p₀)·(t₀ + t₁) λ = |p₁ - p₀|². Source: Wang & Joe 1993.
template <class V>
struct Biarc {
  Arc<V> first, last;

  /// `chord` leads from one end to the other, and is told apart since their difference may be all rounding. The
  /// tangents lead on, both of them or by halves: chord·(leaving + arriving) is not negative.
  [[nodiscard]] static Biarc between(const V& from, const V& leaving, const V& to, const V& arriving,
                                     const V& chord) noexcept {
    const V bend = leaving - arriving;
    const double a = bend.squaredNorm(), b = chord.dot(leaving + arriving), square = chord.squaredNorm();
    const double reach = square / (b + std::sqrt(b * b + a * square));
    const V joint = 0.5 * (chord + reach * bend);  // seen from the start
    return {Arc<V>::along(from, leaving, joint), Arc<V>::along(to, -arriving, joint - chord)};
  }

  [[nodiscard]] double length() const noexcept { return first.length + last.length; }
};

/// Biarcs from key to key, each run through by a cubic of time that never turns back.
template <CurvePoint P>
class BiarcCurve {
 public:
  using V = Ambient<P>;
  struct Piece {
    Biarc<V> path;
    double start_speed, end_speed;  ///< along the path, times the duration of the piece
  };

  BiarcCurve(Knots knots, std::vector<Piece> pieces) : knots_(std::move(knots)), pieces_(std::move(pieces)) {
    ORISPLINE_EXPECT(pieces_.size() == knots_.segments());
  }

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }

  template <Number T>
  [[nodiscard]] PointOver<P, T> point(const T& t, std::size_t segment) const noexcept {
    const Piece& piece = pieces_[segment];
    const T u = knots_.span(segment).normalised(t), v = T(1.0) - u;
    const double length = piece.path.length();
    // From either end the way to it, so that both keys are met exactly.
    const T way = u * u * (T(1.0) + v * Plain<T>(2.0)) * Plain<T>(length) + u * v * v * Plain<T>(piece.start_speed) -
                  u * u * v * Plain<T>(piece.end_speed);
    if (value_of(way) <= piece.path.first.length) return PointOver<P, T>(piece.path.first.template at<T>(way));
    const T left = v * v * (T(1.0) + u * Plain<T>(2.0)) * Plain<T>(length) - u * v * v * Plain<T>(piece.start_speed) +
                   u * u * v * Plain<T>(piece.end_speed);
    return PointOver<P, T>(piece.path.last.template at<T>(left));
  }

 private:
  Knots knots_;
  std::vector<Piece> pieces_;
};

}}  // namespace orispline
