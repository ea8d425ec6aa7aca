// SPDX-License-Identifier: Apache-2.0
// What a careful user of Eigen writes: keys, half-angle vectors and tensions at hand, one search, no allocation.
#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <peers/peers.hpp>
#include <peers/search.hpp>
#include <workload/quintic_blending.hpp>

namespace orispline::bench {

namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

template <class T>
Eigen::Quaternion<T> exp_of_half(const Eigen::Matrix<T, 3, 1>& v) {
  const T angle = v.norm(), ratio = angle < T(1e-8) ? T(1) : std::sin(angle) / angle;
  return {std::cos(angle), ratio * v.x(), ratio * v.y(), ratio * v.z()};
}

Vector3d half_log(const Quaterniond& q) {
  const double sine = q.vec().norm();
  return sine < 1e-300 ? Vector3d::Zero() : Vector3d(std::atan2(sine, q.w()) / sine * q.vec());
}

struct Curve {
  std::vector<double> times, tensions;
  std::vector<Quaterniond, Eigen::aligned_allocator<Quaterniond>> keys;
  std::vector<Vector3d> half_angles;  // one more at either end: zero

  explicit Curve(const Track& track) : times(track.times), tensions(track.tensions) {
    for (std::size_t i = 0; i < track.keys(); ++i)
      keys.emplace_back(Eigen::Map<const Quaterniond>(&track.orientations[4 * i]));
    half_angles.assign(keys.size() + 1, Vector3d::Zero());
    for (std::size_t i = 1; i < keys.size(); ++i) half_angles[i] = half_log(keys[i - 1].conjugate() * keys[i]);
  }

  [[nodiscard]] Quaterniond quintic(double t) const {
    const auto [i, u] = search(times, t);
    const auto b = quintic_blending(u, tensions[i], tensions[i + 1]);
    return keys[i] * exp_of_half<double>(half_angles[i] * b[0]) * exp_of_half<double>(half_angles[i + 1] * b[1]) *
           exp_of_half<double>(half_angles[i + 2] * b[2]);
  }
  [[nodiscard]] Quaterniond slerp(Place place) const {
    return keys[place.segment].slerp(place.u, keys[place.segment + 1]);
  }
};

void put(const Quaterniond& q, std::span<double> out, std::size_t k) { Eigen::Vector4d::Map(&out[4 * k]) = q.coeffs(); }

/// A number with its first two derivatives, as far as the blending needs it.
struct Jet {
  double c[3];
  Jet(double value = 0.0, double first = 0.0, double second = 0.0) : c{value, first, second} {}
  friend Jet operator+(const Jet& a, const Jet& b) { return {a.c[0] + b.c[0], a.c[1] + b.c[1], a.c[2] + b.c[2]}; }
  friend Jet operator-(const Jet& a, const Jet& b) { return {a.c[0] - b.c[0], a.c[1] - b.c[1], a.c[2] - b.c[2]}; }
  friend Jet operator-(const Jet& a) { return {-a.c[0], -a.c[1], -a.c[2]}; }
  friend Jet operator*(const Jet& a, const Jet& b) {
    return {a.c[0] * b.c[0], a.c[1] * b.c[0] + a.c[0] * b.c[1],
            a.c[2] * b.c[0] + 2.0 * a.c[1] * b.c[1] + a.c[0] * b.c[2]};
  }
  friend Jet operator/(const Jet& a, double d) { return {a.c[0] / d, a.c[1] / d, a.c[2] / d}; }
};

}  // namespace

std::vector<Peer<double>> eigen_peers(const Track& track) {
  const auto curve = std::make_shared<const Curve>(track);
  return {{"Eigen product", Shape::quintic,
           [curve](std::span<const double> times, std::span<double> out) {
             for (std::size_t k = 0; k < times.size(); ++k) put(curve->quintic(times[k]), out, k);
           }},
          {"Eigen slerp", Shape::slerp,
           [curve](std::span<const double> times, std::span<double> out) {
             for (std::size_t k = 0; k < times.size(); ++k) put(curve->slerp(search(curve->times, times[k])), out, k);
           }},
          {"Eigen slerp, forward", Shape::slerp, [curve](std::span<const double> times, std::span<double> out) {
             std::size_t i = 0;
             for (std::size_t k = 0; k < times.size(); ++k) {
               while (i + 2 < curve->times.size() && curve->times[i + 1] <= times[k]) ++i;
               put(curve->slerp(place_in(curve->times, times[k], i)), out, k);
             }
           }}};
}

/// Source: Sommer et al. 2020, the recurrence of the rates.
RatesPeer eigen_rates_peer(const Track& track) {
  return {
      "Eigen product", Shape::quintic,
      [curve = std::make_shared<const Curve>(track)](std::span<const double> times, std::span<double> orientations,
                                                     std::span<double> velocities, std::span<double> accelerations) {
        for (std::size_t k = 0; k < times.size(); ++k) {
          const auto [i, u] = search(curve->times, times[k]);
          const double rate = 1.0 / (curve->times[i + 1] - curve->times[i]);
          const auto b = quintic_blending<Jet>(Jet(u, rate), curve->tensions[i], curve->tensions[i + 1]);
          Quaterniond q = curve->keys[i];
          Vector3d omega = Vector3d::Zero(), alpha = Vector3d::Zero();
          for (std::size_t m = 0; m < 3; ++m) {
            const Vector3d& half = curve->half_angles[i + m];
            const Quaterniond factor = exp_of_half<double>(half * b[m].c[0]), back = factor.conjugate();
            const Vector3d own = 2.0 * b[m].c[1] * half;
            q = q * factor;
            omega = back * omega;
            alpha = back * alpha + 2.0 * b[m].c[2] * half + omega.cross(own);
            omega += own;
          }
          put(q, orientations, k);
          Vector3d::Map(&velocities[3 * k]) = omega;
          Vector3d::Map(&accelerations[3 * k]) = alpha;
        }
      }};
}

template <class T>
void many_by_formula(std::span<const T> segments, T u, T tension, std::span<T> out) {
  const auto b = quintic_blending<T>(u, tension, tension);
  using Vector = Eigen::Matrix<T, 3, 1>;
  for (std::size_t k = 0; k < out.size() / 4; ++k) {
    const T* s = &segments[13 * k];
    Eigen::Quaternion<T> q{s[3], s[0], s[1], s[2]};
    for (std::size_t m = 0; m < 3; ++m) q = q * exp_of_half<T>(Eigen::Map<const Vector>(s + 4 + 3 * m) * b[m]);
    Eigen::Matrix<T, 4, 1>::Map(&out[4 * k]) = q.coeffs();
  }
}
template void many_by_formula<double>(std::span<const double>, double, double, std::span<double>);
template void many_by_formula<float>(std::span<const float>, float, float, std::span<float>);

}  // namespace orispline::bench
