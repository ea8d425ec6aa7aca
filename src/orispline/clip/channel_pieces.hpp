// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <utility>
#include <variant>
#include <vector>

#include <orispline/clip/clip.hpp>
#include <orispline/curve/curve_through.hpp>
#include <orispline/curve/rational_curve.hpp>
#include <orispline/math/bernstein.hpp>

// What a channel is between its keys, over any number type.

namespace orispline { inline namespace ORISPLINE_ABI {

/// The value of the key before.
template <CurvePoint P>
class StepCurve {
 public:
  explicit StepCurve(const Channel<P>& channel) : knots_(channel.times), values_(channel.values) {}
  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  template <Number T>
  [[nodiscard]] PointOver<P, T> point(const T& t, std::size_t segment) const noexcept {
    return constant<T>(value_of(t) < knots_.back() ? values_[segment] : values_.back());
  }

 private:
  Knots knots_;
  std::vector<P> values_;
};

/// Geodesics from key to key.
template <CurvePoint P>
class GeodesicCurve {
 public:
  explicit GeodesicCurve(const Channel<P>& channel) : knots_(channel.times), values_(channel.values) {
    if constexpr (std::same_as<P, Eigen::Quaterniond>)
      for (std::size_t i = 1; i < values_.size(); ++i)
        if (values_[i].dot(values_[i - 1]) < 0.0) values_[i].coeffs() = -values_[i].coeffs();
  }
  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  template <Number T>
  [[nodiscard]] PointOver<P, T> point(const T& t, std::size_t segment) const noexcept {
    return on_geodesic<T>(constant<T>(values_[segment]), constant<T>(values_[segment + 1]),
                          knots_.span(segment).normalised(t));
  }

 private:
  Knots knots_;
  std::vector<P> values_;
};

/// Cubic Hermite polynomials of positions or scales, whose derivatives may differ on the two sides of a key.
class CubicPath {
 public:
  explicit CubicPath(const VectorChannel& channel) : knots_(channel.times) {
    for (std::size_t i = 0; i + 1 < channel.size(); ++i) {
      const double third = (channel.times[i + 1] - channel.times[i]) / 3.0;
      controls_.push_back({channel.values[i], channel.values[i] + third * channel.out_tangents[i],
                           channel.values[i + 1] - third * channel.in_tangents[i + 1], channel.values[i + 1]});
    }
  }
  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  template <Number T>
  [[nodiscard]] Vector3<T> point(const T& t, std::size_t segment) const noexcept {
    const auto basis = bernstein_basis<3>(knots_.span(segment).normalised(t));
    Vector3<T> sum = Vector3<T>::Constant(T(0.0));
    for (std::size_t i = 0; i < basis.size(); ++i)
      for (Eigen::Index axis = 0; axis < 3; ++axis) sum[axis] += basis[i] * Plain<T>(controls_[segment][i][axis]);
    return sum;
  }

 private:
  Knots knots_;
  std::vector<std::array<Eigen::Vector3d, 4>> controls_;
};

inline RationalCurve cubic_curve(const RotationChannel& channel) {
  std::vector<RationalPiece> pieces;
  for (std::size_t i = 0; i + 1 < channel.size(); ++i) {
    const double third = (channel.times[i + 1] - channel.times[i]) / 3.0;
    const Eigen::Vector4d start = channel.values[i].coeffs(), end = channel.values[i + 1].coeffs();
    const Eigen::Vector4d leaving = third * channel.out_tangents[i].coeffs(),
                          arriving = third * channel.in_tangents[i + 1].coeffs();
    pieces.push_back({start, end, {leaving, (end - start) - leaving - arriving, arriving}});
  }
  return {Knots(channel.times), std::move(pieces)};
}
inline CubicPath cubic_curve(const VectorChannel& channel) { return CubicPath(channel); }

/// A channel by its interpolation.
template <CurvePoint P>
using ChannelPieces = std::variant<ConstantCurve<P>, StepCurve<P>, GeodesicCurve<P>,
                                   std::conditional_t<std::same_as<P, Eigen::Quaterniond>, RationalCurve, CubicPath>>;

template <CurvePoint P>
[[nodiscard]] ChannelPieces<P> pieces_of(const Channel<P>& channel) {
  if (channel.size() == 1) return ConstantCurve<P>(channel.times.front(), channel.values.front());
  switch (channel.interpolation) {
    case ChannelInterpolation::step:
      return StepCurve<P>(channel);
    case ChannelInterpolation::cubicspline:
      return cubic_curve(channel);
    case ChannelInterpolation::linear:
      break;
  }
  return GeodesicCurve<P>(channel);
}

}}  // namespace orispline
