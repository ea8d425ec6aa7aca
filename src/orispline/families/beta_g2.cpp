// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/beta_g2.hpp>

#include <numeric>

#include <orispline/curve/beta_polygon.hpp>
#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/points_through.hpp>

namespace orispline::inline ORISPLINE_ABI::families {
namespace {

struct Betas {
  std::vector<double> beta1, beta2;  ///< one per key
};

Betas betas_of(std::size_t keys, const FamilySettings& settings) {
  return {settings.per_key("beta1").all(keys), settings.per_key("beta2").all(keys)};
}

Expected<BetaShape> shape_of(const Betas& betas) { return beta_shape(BetaG2::info.name, betas.beta1, betas.beta2); }

// ------------------------------------------------------------------ local: the published curve, corrected

/// What each segment's acceleration lacks at its left joint: β₁² α + β₂ ω of the segment before less its own α. Rates
/// in the local parameter; corrections before do not change them, for they vanish at u = 1.
std::vector<Eigen::Vector3d> corrections(const ControlPolygon<>& published, const Betas& betas) {
  std::vector<double> whole(published.bases.size() + 1);
  std::iota(whole.begin(), whole.end(), 0.0);
  const CubicBezierCurve curve(Knots(std::move(whole)), CubicBezierBasis{}, published);
  std::vector<Eigen::Vector3d> lacking{Eigen::Vector3d::Zero()};
  for (std::size_t i = 1; i < published.bases.size(); ++i) {
    const double t = static_cast<double>(i), beta1 = betas.beta1[i + 1], beta2 = betas.beta2[i + 1];
    const Motion before = curve.motion(t, i - 1), after = curve.motion(t, i);
    lacking.push_back(beta1 * beta1 * before.angular_acceleration + beta2 * before.angular_velocity -
                      after.angular_acceleration);
  }
  return lacking;
}

/// A polygon of cubic segments, each with its correction behind it.
ControlPolygon<> with_corrections(const ControlPolygon<>& cubic, const std::vector<Eigen::Vector3d>& corrections) {
  ControlPolygon<> polygon{.bases = cubic.bases, .increments = {}};
  for (std::size_t i = 0; i < cubic.bases.size(); ++i) {
    const auto* segment = cubic.increments.data() + 3 * i;
    polygon.increments.insert(polygon.increments.end(), segment, segment + 3);
    polygon.increments.push_back(corrections[i]);
  }
  return polygon;
}

// ------------------------------------------------------------------ global: handles solved for

/// The increment in another frame: that behind a turn by `turn`. In space there is nothing to turn.
template <CurvePoint P, Number T>
Vector3<T> seen_behind(const Vector3<T>& turn, const Vector3<T>& increment) {
  if constexpr (std::same_as<P, Eigen::Quaterniond>) return to_body<T>(exp<T>(turn), increment);
  else return increment;
}

/// Handles v_i, the last increments of the cubic segments before the keys; behind a key it is β₁ v. A ChainProblem.
///
/// With x the middle increments the Beta constraint is x_i = (β₁ + β₁² + β₂/2) v_i - β₁² x_{i-1} seen behind v_i. The
/// rates of the end increments are given.
template <CurvePoint P>
class HandleChain {
 public:
  HandleChain(std::vector<P> keys, const Betas& betas, const HandleChain* before)
      : keys_(std::move(keys)), betas_(&betas) {
    for (std::size_t i = 0; i < size(); ++i) handles_.push_back(before ? before->handles_[i] : starting_handle(i));
  }

  [[nodiscard]] std::size_t size() const noexcept { return keys_.size(); }
  [[nodiscard]] bool closed() const noexcept { return false; }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& handles() const noexcept { return handles_; }
  [[nodiscard]] Eigen::Vector3d leaving(std::size_t i) const { return betas_->beta1[i] * handles_[i]; }

  /// The increment between the inner control points of segment i.
  template <Number T>
  [[nodiscard]] Vector3<T> middle(std::size_t i, const Vector3<T>& v, const Vector3<T>& next) const {
    return displacement(displaced(constant<T>(keys_[i]), Vector3<T>(v * T(betas_->beta1[i]))),
                        displaced(constant<T>(keys_[i + 1]), Vector3<T>(-next)));
  }
  [[nodiscard]] Eigen::Vector3d middle(std::size_t i) const { return middle<double>(i, handles_[i], handles_[i + 1]); }

  template <Number T>
  [[nodiscard]] std::vector<Vector3<T>> residual(std::span<const Vector3<T>> steps) const {
    std::vector<Vector3<T>> v, missing;
    for (std::size_t i = 0; i < size(); ++i) v.push_back(constant<T>(handles_[i]) + steps[i]);
    for (std::size_t i = 0; i < size(); ++i) {
      if (i == 0 || i + 1 == size()) {
        missing.push_back(v[i] - constant<T>(starting_handle(i)));
        continue;
      }
      const double b1 = betas_->beta1[i], b2 = betas_->beta2[i], weight = b1 + b1 * b1 + 0.5 * b2;
      const Vector3<T> x = middle<T>(i, v[i], v[i + 1]);
      const Vector3<T> arriving = seen_behind<P, T>(v[i], middle<T>(i - 1, v[i - 1], v[i]));
      missing.push_back((x - v[i] * T(weight) + arriving * T(b1 * b1)) * T(1.0 / (1.0 + weight + b1 * b1)));
    }
    return missing;
  }

  void move(std::span<const Vector3<double>> steps) {
    for (std::size_t i = 0; i < size(); ++i) handles_[i] += steps[i];
  }

  /// No handle is longer than half a turn.
  [[nodiscard]] bool plausible() const {
    if constexpr (std::same_as<P, Eigen::Quaterniond>)
      for (std::size_t i = 0; i < size(); ++i)
        if (!(std::max(1.0, betas_->beta1[i]) * handles_[i].norm() < std::numbers::pi)) return false;
    return true;
  }

 private:
  /// A third of the increment at an end, the mean of both at an inner key.
  [[nodiscard]] Eigen::Vector3d starting_handle(std::size_t i) const {
    const std::size_t last = size() - 1;
    const Eigen::Vector3d before = i > 0 ? displacement(keys_[i - 1], keys_[i]) : displacement(keys_[0], keys_[1]);
    const Eigen::Vector3d after = i < last ? displacement(keys_[i], keys_[i + 1]) : before;
    return (before + after) / 6.0;
  }

  std::vector<P> keys_;
  const Betas* betas_;
  std::vector<Eigen::Vector3d> handles_;
};

template <CurvePoint P>
Expected<HandleChain<P>> solved_handles(std::span<const P> keys, const Betas& betas) {
  return solve_chain(BetaG2::info.name, [&](double share, const HandleChain<P>* before) {
    return HandleChain<P>(with_steps_of(share, keys), betas, before);
  });
}

bool is_global(const FamilySettings& settings) { return settings.choice("form") == "global"; }
Knots joint_times(const Keyframes& keys) { return Knots({keys.times().begin() + 1, keys.times().end() - 1}); }

}  // namespace

Expected<CumulativeCurve<BetaG2::Basis>> BetaG2::curve(const Keyframes& keys, const FamilySettings& settings) {
  const Betas betas = betas_of(keys.size(), settings);
  const auto q = keys.orientations();
  const auto shape = shape_of(betas);
  if (!shape) return tl::unexpected(shape.error());
  if (!is_global(settings)) {
    const ControlPolygon<> published = beta_polygon(q, *shape);
    return CumulativeCurve<Basis>(joint_times(keys), Basis{},
                                  with_corrections(published, corrections(published, betas)));
  }
  return solved_handles(q, betas).map([&](const HandleChain<Eigen::Quaterniond>& chain) {
    ControlPolygon<> cubic{.bases = {q.begin(), q.end() - 1}, .increments = {}};
    for (std::size_t i = 0; i + 1 < q.size(); ++i)
      cubic.increments.insert(cubic.increments.end(), {chain.leaving(i), chain.middle(i), chain.handles()[i + 1]});
    const std::vector<Eigen::Vector3d> none(q.size() - 1, Eigen::Vector3d::Zero());
    return CumulativeCurve<Basis>(key_knots(keys), Basis{}, with_corrections(cubic, none));
  });
}

Expected<CubicBezierPath> BetaG2::path(const Keyframes& keys, const FamilySettings& settings) {
  const Betas betas = betas_of(keys.size(), settings);
  const auto p = keys.positions();
  const auto shape = shape_of(betas);
  if (!shape) return tl::unexpected(shape.error());
  if (!is_global(settings))  // in space the published curve is G2 by itself
    return CubicBezierPath(joint_times(keys), CubicBezierBasis{}, beta_polygon(p, *shape));
  const UnitPositions unit(p);
  return solved_handles<Eigen::Vector3d>(unit.points, betas).map([&](const HandleChain<Eigen::Vector3d>& chain) {
    std::vector<Eigen::Vector3d> points{p[0]};
    for (std::size_t i = 0; i + 1 < p.size(); ++i) {
      points.push_back(p[i] + unit.extent * chain.leaving(i));
      points.push_back(p[i + 1] - unit.extent * chain.handles()[i + 1]);
      points.push_back(p[i + 1]);
    }
    return CubicBezierPath(key_knots(keys), CubicBezierBasis{}, points);
  });
}

}  // namespace orispline::inline ORISPLINE_ABI::families
