// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/channel_curve.hpp>

#include <utility>

#include <orispline/curve/rational_curve.hpp>
#include <orispline/math/bernstein.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

/// The value of the key before.
template <CurvePoint P>
class StepCurve {
 public:
  explicit StepCurve(const Channel<P>& channel) : knots_(channel.times), values_(channel.values) {}
  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  template <Number T>
  [[nodiscard]] PointOver<P, T> point(const T&, std::size_t segment) const noexcept {
    return constant<T>(values_[segment]);
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

RationalCurve cubic_curve(const RotationChannel& channel) {
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
CubicPath cubic_curve(const VectorChannel& channel) { return CubicPath(channel); }

template <CurvePoint P>
ErasedCurve<P> curve_of(const Channel<P>& channel) {
  if (channel.size() == 1) return ErasedCurve<P>(ConstantCurve<P>(channel.times.front(), channel.values.front()));
  switch (channel.interpolation) {
    case ChannelInterpolation::step:
      return ErasedCurve<P>(StepCurve<P>(channel));
    case ChannelInterpolation::cubicspline:
      return ErasedCurve<P>(cubic_curve(channel));
    case ChannelInterpolation::linear:
      break;
  }
  return ErasedCurve<P>(GeodesicCurve<P>(channel));
}

Motion at_rest(const Eigen::Quaterniond& value) { return {.orientation = value}; }
LinearMotion at_rest(const Eigen::Vector3d& value) { return {.position = value}; }

}  // namespace

template <CurvePoint P>
ChannelCurve<P>::ChannelCurve(const Channel<P>& channel)
    : curve_(curve_of(channel)), last_(channel.values.back()), joint_(channel.joint) {}

template <CurvePoint P>
P ChannelCurve<P>::at(double t) const noexcept {
  if (t >= knots().back()) return last_;
  t = std::max(t, knots().front());
  return curve_.point(t, knots().segment_at(t));
}

template <CurvePoint P>
MotionOf<P> ChannelCurve<P>::motion(double t) const noexcept {
  if (t < knots().front() || t > knots().back()) return at_rest(at(t));
  MotionOf<P> motion = curve_.motion(t, knots().segment_at(t));
  if (t == knots().back()) {
    if constexpr (std::same_as<P, Eigen::Quaterniond>) motion.orientation = last_;
    else motion.position = last_;
  }
  return motion;
}

template class ChannelCurve<Eigen::Quaterniond>;
template class ChannelCurve<Eigen::Vector3d>;

}  // namespace orispline::inline ORISPLINE_ABI
