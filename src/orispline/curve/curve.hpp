// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <memory>
#include <span>

#include <orispline/base/expected.hpp>
#include <orispline/curve/knots.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/curve/segment_form.hpp>

namespace orispline {

/// A curve of orientations over knots, evaluated segment by segment. Every family builds one.
///
/// `orientation(t, segment)` takes any Number. A curve may also state `motion(t, segment)` when it has something faster
/// than jets.
template <class C>
concept Curve = requires(const C& c, double t, Jet<double, 3> jet, std::size_t segment) {
  { c.knots() } -> std::convertible_to<const Knots&>;
  { c.orientation(t, segment) } -> std::same_as<Eigen::Quaterniond>;
  { c.orientation(jet, segment) } -> std::same_as<Quaternion<Jet<double, 3>>>;
}
&&std::copyable<C>;

/// The motion of any curve on one of its segments: its own evaluator, or jets through the whole quaternion.
template <Curve C>
[[nodiscard]] Motion motion_on_segment(const C& curve, double t, std::size_t segment) noexcept {
  if constexpr (requires { curve.motion(t, segment); }) return curve.motion(t, segment);
  else return motion_from_jet(curve.orientation(Jet<double, 3>::variable(t), segment));
}

/// Closed time interval [s] on which a curve is defined.
struct Domain {
  double start, end;
  [[nodiscard]] bool contains(double t) const noexcept { return start <= t && t <= end; }
};

/// One key for ever: what every family becomes when there is a single keyframe.
class ConstantCurve {
 public:
  ConstantCurve(double time, const Eigen::Quaterniond& orientation) : knots_({time}), orientation_(orientation) {}
  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  template <Number T>
  [[nodiscard]] Quaternion<T> orientation(const T&, std::size_t) const noexcept {
    return constant<T>(orientation_);
  }

 private:
  Knots knots_;
  Eigen::Quaterniond orientation_;
};

/// Any curve by value: what the registry returns and the faces hold.
///
/// Immutable, cheap to copy, safe to share between threads. Evaluation allocates nothing. Outside the domain the end
/// orientation is held at rest (ω = 0); `checked_motion` makes that an error instead. A NaN time gives NaN.
class AnyCurve {
 public:
  template <class C>
  requires(!std::same_as<C, AnyCurve> && Curve<C>) AnyCurve(C curve)
      : model_(std::make_shared<Model<C>>(std::move(curve))) {}  // NOLINT: a curve is an AnyCurve

  /// Orientation at time t [s].
  [[nodiscard]] Eigen::Quaterniond operator()(double t) const noexcept {
    t = held(t);
    return model_->orientation(t, knots().segment_at(t));
  }

  /// Orientation with body rates at time t [s]. At an interior knot the right-hand segment's, or on request the
  /// left-hand one's; at the last knot always the left-hand one's.
  [[nodiscard]] Motion motion(double t, Side side = Side::right) const noexcept {
    if (t < domain().start || t > domain().end) return {.orientation = (*this)(t)};
    return model_->motion(t, knots().segment_at(t, side));
  }

  /// The same, but a time outside the domain is an error (bad_argument).
  [[nodiscard]] Expected<Motion> checked_motion(double t) const;

  [[nodiscard]] Domain domain() const noexcept { return {knots().front(), knots().back()}; }
  [[nodiscard]] const Knots& knots() const noexcept { return model_->knots(); }

  /// On one segment, whatever the time: what sampling in bulk falls back on.
  [[nodiscard]] Motion motion_on(std::size_t segment, double t) const noexcept { return model_->motion(t, segment); }
  [[nodiscard]] Eigen::Quaterniond orientation_on(std::size_t segment, double t) const noexcept {
    return model_->orientation(t, segment);
  }
  /// What a segment is made of, where it is made of polynomials.
  [[nodiscard]] SegmentForm form(std::size_t segment) const noexcept { return model_->form(segment); }

 private:
  struct Interface {
    virtual ~Interface() = default;
    [[nodiscard]] virtual const Knots& knots() const noexcept = 0;
    [[nodiscard]] virtual Eigen::Quaterniond orientation(double t, std::size_t segment) const noexcept = 0;
    [[nodiscard]] virtual Motion motion(double t, std::size_t segment) const noexcept = 0;
    [[nodiscard]] virtual SegmentForm form(std::size_t segment) const noexcept = 0;
  };
  template <Curve C>
  struct Model final : Interface {
    explicit Model(C c) : curve(std::move(c)) {}
    [[nodiscard]] const Knots& knots() const noexcept override { return curve.knots(); }
    [[nodiscard]] Eigen::Quaterniond orientation(double t, std::size_t segment) const noexcept override {
      return curve.orientation(t, segment);
    }
    [[nodiscard]] Motion motion(double t, std::size_t segment) const noexcept override {
      return motion_on_segment(curve, t, segment);
    }
    [[nodiscard]] SegmentForm form(std::size_t segment) const noexcept override {
      if constexpr (requires { curve.form(segment); }) return curve.form(segment);
      else return {};
    }
    C curve;
  };

  [[nodiscard]] double held(double t) const noexcept {
    const Domain d = domain();
    return t < d.start ? d.start : t > d.end ? d.end : t;
  }

  std::shared_ptr<const Interface> model_;
};

}  // namespace orispline
