// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>

#include <orispline/math/jet.hpp>
#include <orispline/math/series.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// w·α + z·ω of the motion exp(ψ) for constant w and z, with its second derivatives by ψ, ψ' and ψ'', which are called
/// p, v and a.
///
/// It is a function of scalars. With A, B the ratios of versine and sine defect as functions of x = p², A', B' their
/// slopes and s = p·v:
///
///     A (-p·(a×w) - p·(v×z)) + A' (-2s p·(v×w)) + B' 2s ((w·p) s - (w·v) x) + w·a + z·v
///     + B ((w·p)(p·a + v²) - (w·v) s - (w·a) x + (z·p) s - (z·v) x)
template <Number T>
class LeastRateSum {
 public:
  LeastRateSum(const Vector3<T>& p, const Vector3<T>& v, const Vector3<T>& a, const Vector3<T>& w, const Vector3<T>& z)
      : p_(p), v_(v), a_(a), w_(w), z_(z) {
    const T x = p.squaredNorm(), s = p.dot(v), vv = v.squaredNorm(), pa = p.dot(a), one(1.0);
    const T wp = w.dot(p), wv = w.dot(v), wa = w.dot(a), zp = z.dot(p), zv = z.dot(v), pvw = p.dot(v.cross(w));
    const auto place = Jet<T, 3>::variable(x);
    const auto versine = series::versine_ratio(place), defect = series::sine_defect_ratio(place);
    slopes_.fill(T(0.0));
    curvature_.setConstant(T(0.0));
    slopes_[WA] = slopes_[ZV] = one;
    add(versine, 0, -p.dot(a.cross(w)) - p.dot(v.cross(z)), {{PAW, -one}, {PVZ, -one}}, {});
    add(versine, 1, s * pvw * -2.0, {{S, pvw * -2.0}, {PVW, s * -2.0}}, {{S, PVW, one * -2.0}});
    add(defect, 0, wp * (pa + vv) - wv * s - wa * x + zp * s - zv * x,
        {{WP, pa + vv}, {PA, wp}, {VV, wp}, {WV, -s}, {S, zp - wv}, {WA, -x}, {X, -wa - zv}, {ZP, s}, {ZV, -x}},
        {{WP, PA, one}, {WP, VV, one}, {WV, S, -one}, {WA, X, -one}, {ZP, S, one}, {ZV, X, -one}});
    add(defect, 1, s * (wp * s - wv * x) * 2.0,
        {{WP, s * s * 2.0}, {S, wp * s * 4.0 - wv * x * 2.0}, {WV, s * x * -2.0}, {X, s * wv * -2.0}},
        {{WP, S, s * 4.0}, {S, S, wp * 4.0}, {S, WV, x * -2.0}, {X, S, wv * -2.0}, {X, WV, s * -2.0}});
  }

  [[nodiscard]] Eigen::Matrix<T, 9, 9> curvature() const {
    const auto by = gradients();
    const Eigen::Matrix<T, scalars, 9> curved = curvature_ * by;
    Eigen::Matrix<T, 9, 9> sum = by.transpose() * curved;
    const auto add_block = [&sum](Eigen::Index row, Eigen::Index column, const T& diagonal, const Matrix3<T>& rest) {
      Matrix3<T> block = rest;
      for (Eigen::Index k = 0; k < 3; ++k) block(k, k) += diagonal;
      sum.template block<3, 3>(row, column) += block;
      if (row != column) sum.template block<3, 3>(column, row) += block.transpose();
    };
    const Matrix3<T> none = Matrix3<T>::Constant(T(0.0)), W = skew<T>(w_), Z = skew<T>(z_);
    add_block(0, 0, slopes_[X] * 2.0, none);
    add_block(3, 3, slopes_[VV] * 2.0, none);
    add_block(0, 3, slopes_[S], W * -slopes_[PVW] - Z * slopes_[PVZ]);
    add_block(0, 6, slopes_[PA], W * -slopes_[PAW]);
    return sum;
  }

 private:
  /// p², p·v, v², w·p, w·v, w·a, p·a, p·(a×w), p·(v×w), z·p, z·v, p·(v×z)
  enum Scalar : std::uint8_t { X, S, VV, WP, WV, WA, PA, PAW, PVW, ZP, ZV, PVZ };
  static constexpr int scalars = 12;
  struct Slope {
    Scalar by;
    T value;
  };
  struct Second {
    Scalar by, and_by;
    T value;
  };

  /// Adds a function of x, differentiated so many times, times a polynomial that has these slopes.
  void add(const Jet<T, 3>& function, std::size_t order, const T& value, std::initializer_list<Slope> slopes,
           std::initializer_list<Second> seconds) {
    const T f = function.derivative(order), f1 = function.derivative(order + 1);
    slopes_[X] += f1 * value;
    curvature_(X, X) += function.derivative(order + 2) * value;
    for (const Slope& slope : slopes) {
      slopes_[slope.by] += f * slope.value;
      curvature_(X, slope.by) += f1 * slope.value;
      curvature_(slope.by, X) += f1 * slope.value;
    }
    for (const Second& second : seconds) {
      curvature_(second.by, second.and_by) += f * second.value;
      if (second.by != second.and_by) curvature_(second.and_by, second.by) += f * second.value;
    }
  }

  /// Of the scalars, a row for each.
  [[nodiscard]] Eigen::Matrix<T, scalars, 9> gradients() const {
    Eigen::Matrix<T, scalars, 9> by = Eigen::Matrix<T, scalars, 9>::Constant(T(0.0));
    const auto set = [&by](Scalar scalar, Eigen::Index first, const Vector3<T>& slope) {
      by.template block<1, 3>(scalar, first) = slope.transpose();
    };
    set(X, 0, p_ * T(2.0)), set(S, 0, v_), set(S, 3, p_), set(VV, 3, v_ * T(2.0)), set(PA, 0, a_), set(PA, 6, p_);
    set(WP, 0, w_), set(WV, 3, w_), set(WA, 6, w_), set(ZP, 0, z_), set(ZV, 3, z_);
    set(PAW, 0, a_.cross(w_)), set(PAW, 6, w_.cross(p_)), set(PVW, 0, v_.cross(w_)), set(PVW, 3, w_.cross(p_));
    set(PVZ, 0, v_.cross(z_)), set(PVZ, 3, z_.cross(p_));
    return by;
  }

  Vector3<T> p_, v_, a_, w_, z_;
  std::array<T, scalars> slopes_;
  Eigen::Matrix<T, scalars, scalars> curvature_;
};

}}}  // namespace orispline::families
