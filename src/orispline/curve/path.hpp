// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <memory>

#include <orispline/curve/knots.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline {

/// Position with its rates at one time, in the world frame.
struct LinearMotion {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();      ///< [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();      ///< [m/s]
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< [m/s²]
};

/// From a position given with its first two time derivatives.
[[nodiscard]] inline LinearMotion linear_motion_from_jet(const Vector3<Jet<double, 2>>& p) noexcept {
  const auto order = [&p](std::size_t k) {
    return Eigen::Vector3d(p.x().derivative(k), p.y().derivative(k), p.z().derivative(k));
  };
  return {.position = order(0), .velocity = order(1), .acceleration = order(2)};
}

/// A curve of positions over knots, evaluated segment by segment over any Number.
template <class P>
concept Path = std::copyable<P> && requires(const P& p, double t, Jet<double, 2> jet, std::size_t segment) {
  { p.knots() } -> std::convertible_to<const Knots&>;
  { p.position(t, segment) } -> std::convertible_to<Eigen::Vector3d>;
  { p.position(jet, segment) } -> std::convertible_to<Vector3<Jet<double, 2>>>;
};

/// The degree of the polynomials in t that a path states its segments to be; 0 where it states none.
template <Path P>
[[nodiscard]] constexpr int degree_of() noexcept {
  if constexpr (requires { P::degree; }) return P::degree;
  else return 0;
}

/// Any path by value: immutable, cheap to copy, evaluation allocates nothing. Outside its knots the end position is
/// held at rest.
class AnyPath {
 public:
  template <class P>
  requires(!std::same_as<P, AnyPath> && Path<P>) AnyPath(P path)
      : model_(std::make_shared<Model<P>>(std::move(path))) {}  // NOLINT: a path is an AnyPath

  /// Position with velocity and acceleration at time t [s]; at an interior knot of the chosen side.
  [[nodiscard]] LinearMotion linear_motion(double t, Side side = Side::right) const noexcept {
    const Knots& knots = model_->knots();
    if (t < knots.front()) return {.position = model_->linear_motion(knots.front(), 0).position};
    if (t > knots.back()) return {.position = model_->linear_motion(knots.back(), knots.segment_at(t)).position};
    return model_->linear_motion(t, knots.segment_at(t, side));
  }

  [[nodiscard]] const Knots& knots() const noexcept { return model_->knots(); }

  /// On one segment, whatever the time: what sampling in bulk falls back on.
  [[nodiscard]] LinearMotion linear_motion_on(std::size_t segment, double t) const noexcept { return model_->linear_motion(t, segment); }
  [[nodiscard]] Eigen::Vector3d position_on(std::size_t segment, double t) const noexcept {
    return model_->position(t, segment);
  }
  /// The degree of the polynomials in t that all segments are; 0 where they are none.
  [[nodiscard]] int degree() const noexcept { return model_->degree(); }

 private:
  struct Interface {
    virtual ~Interface() = default;
    [[nodiscard]] virtual const Knots& knots() const noexcept = 0;
    [[nodiscard]] virtual LinearMotion linear_motion(double t, std::size_t segment) const noexcept = 0;
    [[nodiscard]] virtual Eigen::Vector3d position(double t, std::size_t segment) const noexcept = 0;
    [[nodiscard]] virtual int degree() const noexcept = 0;
  };
  template <Path P>
  struct Model final : Interface {
    explicit Model(P p) : path(std::move(p)) {}
    [[nodiscard]] const Knots& knots() const noexcept override { return path.knots(); }
    [[nodiscard]] LinearMotion linear_motion(double t, std::size_t segment) const noexcept override {
      return linear_motion_from_jet(path.position(Jet<double, 2>::variable(t), segment));
    }
    [[nodiscard]] Eigen::Vector3d position(double t, std::size_t segment) const noexcept override {
      return path.position(t, segment);
    }
    [[nodiscard]] int degree() const noexcept override { return degree_of<P>(); }
    P path;
  };

  std::shared_ptr<const Interface> model_;
};

/// One position for ever: what every path becomes when there is a single keyframe.
class ConstantPath {
 public:
  ConstantPath(double time, const Eigen::Vector3d& position) : knots_({time}), position_(position) {}
  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  template <Number T>
  [[nodiscard]] Vector3<T> position(const T&, std::size_t) const noexcept {
    return constant<T>(position_);
  }

 private:
  Knots knots_;
  Eigen::Vector3d position_;
};

}  // namespace orispline
