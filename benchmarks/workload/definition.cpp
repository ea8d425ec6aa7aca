// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <workload/definition.hpp>
#include <workload/quintic_blending.hpp>

namespace orispline::bench {

namespace {

LongQuaternion exp_of_half(const LongVector& v) {
  const Real angle = v.norm(), ratio = angle == 0 ? Real(1) : std::sin(angle) / angle;
  return {std::cos(angle), ratio * v.x(), ratio * v.y(), ratio * v.z()};
}

LongVector half_log(const LongQuaternion& q) {
  const Real sine = q.vec().norm();
  return sine == 0 ? LongVector::Zero() : LongVector(std::atan2(sine, q.w()) / sine * q.vec());
}

/// Central difference of fourth order.
template <class F>
auto slope(const F& f, Real t) {
  const Real h = 1e-3L;
  return ((8 * (f(t + h) - f(t - h)) - (f(t + 2 * h) - f(t - 2 * h))) / (12 * h)).eval();
}

template <class Q>
LongVector body_rate(const Q& orientation, Real t) {
  const auto rate = slope([&](Real at) { return orientation(at).coeffs(); }, t);
  return 2 * (orientation(t).conjugate() * LongQuaternion(rate)).vec();
}

}  // namespace

Definition::Definition(const Track& track)
    : times_(track.times.begin(), track.times.end()), tensions_(track.tensions.begin(), track.tensions.end()) {
  for (std::size_t i = 0; i < track.keys(); ++i)
    keys_.emplace_back(Eigen::Map<const Eigen::Quaterniond>(&track.orientations[4 * i]).cast<Real>());
  half_angles_.assign(keys_.size() + 1, LongVector::Zero());
  for (std::size_t i = 1; i < keys_.size(); ++i) half_angles_[i] = half_log(keys_[i - 1].conjugate() * keys_[i]);
}

std::size_t Definition::segment_at(double t) const {
  const auto next = std::upper_bound(times_.begin() + 1, times_.end() - 1, Real(t));
  return static_cast<std::size_t>(next - times_.begin()) - 1;
}

Real Definition::local(Real t, std::size_t i) const { return (t - times_[i]) / (times_[i + 1] - times_[i]); }

LongQuaternion Definition::quintic(Real t, std::size_t i) const {
  const auto b = quintic_blending(local(t, i), tensions_[i], tensions_[i + 1]);
  return keys_[i] * exp_of_half(b[0] * half_angles_[i]) * exp_of_half(b[1] * half_angles_[i + 1]) *
         exp_of_half(b[2] * half_angles_[i + 2]);
}

LongQuaternion Definition::slerp(double t) const {
  const std::size_t i = segment_at(t);
  return keys_[i] * exp_of_half(local(Real(t), i) * half_angles_[i + 1]);
}

LongQuaternion Definition::uniform_bspline(Real u, std::size_t i) const {
  const Real v = 1 - u, b3 = u * u * u / 6, b2 = (1 + 3 * (u + u * u - u * u * u)) / 6, b0 = v * v * v / 6;
  return keys_[i] * exp_of_half((1 - b0) * half_angles_[i + 1]) * exp_of_half((b2 + b3) * half_angles_[i + 2]) *
         exp_of_half(b3 * half_angles_[i + 3]);
}

LongVector Definition::uniform_bspline_velocity(Real u, std::size_t i) const {
  return body_rate([&](Real at) { return uniform_bspline(at, i); }, u);
}

LongVector Definition::uniform_bspline_acceleration(Real u, std::size_t i) const {
  return slope([&](Real at) { return uniform_bspline_velocity(at, i); }, u);
}

LongVector Definition::angular_velocity(Real t, std::size_t i) const {
  return body_rate([&](Real at) { return quintic(at, i); }, t);
}

LongVector Definition::angular_acceleration(double t) const {
  return slope([&, i = segment_at(t)](Real at) { return angular_velocity(at, i); }, Real(t));
}

}  // namespace orispline::bench
