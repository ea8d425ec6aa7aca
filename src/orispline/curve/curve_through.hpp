// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <memory>
#include <variant>

#include <orispline/curve/knots.hpp>
#include <orispline/curve/motion.hpp>
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

/// A segment q(u) = slerp(outer exp(u φ), inner exp(u ψ); 2u(1-u)), a spherical quadrangle.
struct SquadForm {
  Eigen::Quaterniond outer, inner;
  Eigen::Vector3d outer_increment, inner_increment;  ///< φ and ψ [rad]
};

/// What a segment is made of, where that is evaluated in bulk.
using SegmentForm = std::variant<std::monostate, CumulativeForm, ChartForm, RationalForm, SquadForm>;

/// A curve through points of one kind over knots, evaluated segment by segment. Every family builds one.
///
/// `point(t, segment)` takes any Number. A curve may also state `motion(t, segment)` when it has something faster than
/// jets.
template <class C, class P>
concept CurveThrough = CurvePoint<P> && requires(const C& c, double t, Jet<double, 3> jet, std::size_t segment) {
  { c.knots() } -> std::convertible_to<const Knots&>;
  { c.point(t, segment) } -> std::same_as<P>;
  { c.point(jet, segment) } -> std::same_as<PointOver<P, Jet<double, 3>>>;
} && std::copyable<C>;

/// The motion of any curve on one of its segments: its own evaluator, or jets through the whole point.
template <class C>
[[nodiscard]] auto motion_on_segment(const C& curve, double t, std::size_t segment) noexcept {
  if constexpr (requires { curve.motion(t, segment); }) return curve.motion(t, segment);
  else return motion_from_jet(curve.point(Jet<double, 3>::variable(t), segment));
}

/// One key for ever: what every family becomes when there is a single keyframe.
template <CurvePoint P>
class ConstantCurve {
 public:
  ConstantCurve(double time, const P& point) : knots_({time}), point_(point) {}
  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  template <Number T>
  [[nodiscard]] PointOver<P, T> point(const T& t, std::size_t) const noexcept {
    const T sure = T(1.0) + (t - t);  // NaN for NaN, as of every curve
    PointOver<P, T> point = constant<T>(point_);
    if constexpr (std::same_as<P, Eigen::Quaterniond>) point.coeffs() *= sure;
    else point *= sure;
    return point;
  }

 private:
  Knots knots_;
  P point_;
};

/// Any curve through points of one kind, without its own type: immutable, cheap to copy, evaluation allocates nothing.
template <CurvePoint P>
class ErasedCurve {
 public:
  template <class C>
  requires(!std::same_as<C, ErasedCurve> && CurveThrough<C, P>) explicit ErasedCurve(C curve)
      : model_(std::make_shared<Model<C>>(std::move(curve))) {}
  // Moving copies, which is cheap: what was moved from stays the curve that it was.
  ErasedCurve(const ErasedCurve&) noexcept = default;
  ErasedCurve& operator=(const ErasedCurve&) noexcept = default;

  [[nodiscard]] const Knots& knots() const noexcept { return model_->knots(); }
  [[nodiscard]] P point(double t, std::size_t segment) const noexcept { return model_->point(t, segment); }
  [[nodiscard]] MotionOf<P> motion(double t, std::size_t segment) const noexcept { return model_->motion(t, segment); }
  [[nodiscard]] SegmentForm form(std::size_t segment) const noexcept { return model_->form(segment); }

 private:
  struct Interface {
    virtual ~Interface() = default;
    [[nodiscard]] virtual const Knots& knots() const noexcept = 0;
    [[nodiscard]] virtual P point(double t, std::size_t segment) const noexcept = 0;
    [[nodiscard]] virtual MotionOf<P> motion(double t, std::size_t segment) const noexcept = 0;
    [[nodiscard]] virtual SegmentForm form(std::size_t segment) const noexcept = 0;
  };
  template <CurveThrough<P> C>
  struct Model final : Interface {
    explicit Model(C c) : curve(std::move(c)) {}
    [[nodiscard]] const Knots& knots() const noexcept override { return curve.knots(); }
    [[nodiscard]] P point(double t, std::size_t segment) const noexcept override { return curve.point(t, segment); }
    [[nodiscard]] MotionOf<P> motion(double t, std::size_t segment) const noexcept override {
      return motion_on_segment(curve, t, segment);
    }
    [[nodiscard]] SegmentForm form(std::size_t segment) const noexcept override {
      if constexpr (requires { curve.form(segment); }) return curve.form(segment);
      else return {};
    }
    C curve;
  };

  std::shared_ptr<const Interface> model_;
};

}}  // namespace orispline
