// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/bspline_through.hpp>

#include <orispline/curve/bspline_basis.hpp>
#include <orispline/curve/cumulative_curve.hpp>
#include <orispline/curve/four_key_curve.hpp>
#include <orispline/curve/points_through.hpp>
#include <orispline/curve/rate_chain.hpp>
#include <orispline/curve/reflected.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

using Basis = BSplineBasis<3>;

/// Two knots beyond either end of the curve's own.
Basis basis_of(const Knots& knots, const FamilySettings& settings) {
  const auto t = knots.times();
  const auto last = static_cast<std::ptrdiff_t>(t.size()) - 1;
  const auto mirrored = reflected(t);
  const auto knot = [&](std::ptrdiff_t i) -> double {
    const auto at = [&](std::ptrdiff_t k) { return t[static_cast<std::size_t>(k)]; };
    if (0 <= i && i <= last) return at(i);
    if (settings.closure) {
      const std::ptrdiff_t periods = i < 0 ? (i + 1) / last - 1 : i / last;
      return at(i - periods * last) + static_cast<double>(periods) * settings.closure->period;
    }
    if (settings.choice("phantom") == "reflect") return mirrored[i];
    return i < 0 ? at(0) + static_cast<double>(i) * (at(1) - at(0))
                 : at(last) + static_cast<double>(i - last) * (at(last) - at(last - 1));
  };
  Basis basis;
  for (std::ptrdiff_t i = -2; i <= last + 2; ++i) basis.knots.push_back(knot(i));
  return basis;
}

/// The first two cumulative functions and their rates [1/s] at a knot, where the third is still zero.
struct KnotWeights {
  std::array<double, 2> value, rate;
};

std::vector<KnotWeights> weights_of(const Knots& knots, const Basis& basis, std::size_t keys) {
  std::vector<KnotWeights> weights;
  for (std::size_t i = 0; i < keys; ++i) {
    const bool at_end = i == knots.segments();
    const auto b = basis(knots.span(at_end ? i - 1 : i), Jet<double, 1>::variable(knots.times()[i]));
    const std::size_t first = at_end ? 1 : 0;
    weights.push_back({{b[first].c[0], b[first + 1].c[0]}, {b[first].c[1], b[first + 1].c[1]}});
  }
  return weights;
}

/// The control orientations as unknowns: at its knot the curve must meet each key.
class BSplineChain {
 public:
  BSplineChain(const Keyframes& keys, const FamilySettings& settings, const std::vector<KnotWeights>& weights,
               double share, const BSplineChain* before)
      : keys_(with_steps_of(share, keys.orientations())), controls_(keys_), weights_(weights), settings_(settings) {
    for (std::size_t i = 0; before && i < keys_.size(); ++i)
      controls_[i] = displaced(keys_[i], displacement(before->keys_[i], before->controls_[i]));
    settings_.start.angular_velocity *= share;
    settings_.end.angular_velocity *= share;
  }

  [[nodiscard]] std::size_t size() const { return keys_.size(); }
  [[nodiscard]] bool closed() const { return settings_.closure.has_value(); }
  [[nodiscard]] bool plausible() const { return true; }

  void move(std::span<const Eigen::Vector3d> by) {
    for (std::size_t i = 0; i < by.size(); ++i) controls_[i] = displaced(controls_[i], by[i]).normalized();
  }

  template <Number T>
  [[nodiscard]] std::vector<Vector3<T>> residual(std::span<const Vector3<T>> moved_by) const {
    std::vector<Quaternion<T>> p;
    for (std::size_t i = 0; i < size(); ++i) p.push_back(displaced(constant<T>(controls_[i]), moved_by[i]));
    const std::vector<Vector3<T>> w = increments<T>(p);
    std::vector<Vector3<T>> residual;
    residual.reserve(size());
    for (std::size_t i = 0; i < size(); ++i) {
      const auto& at = weights_[i].value;  // from control i: back over its increment, forth to the knot
      const Quaternion<T> value = p[i] * exp<T>(w[i] * T(at[0] - 1.0)) * exp<T>(w[i + 1] * T(at[1]));
      residual.push_back(increment<T>(value, constant<T>(keys_[i])));
    }
    return residual;
  }

  /// From the control before the first one to the one after the last.
  [[nodiscard]] ControlPolygon<> polygon() const {
    ControlPolygon<> polygon{.bases = {}, .increments = increments<double>(controls_)};
    const std::vector<Eigen::Vector3d> w = polygon.increments;
    polygon.bases.push_back(controls_[0] * exp<double>(-w[0]));
    polygon.bases.insert(polygon.bases.end(), controls_.begin(), controls_.end() - (closed() ? 1 : 2));
    if (closed()) polygon.increments.push_back(w[1]);
    return polygon;
  }

 private:
  /// One before every control, and one after the last; those that reach beyond the ends by the end rule.
  template <Number T>
  [[nodiscard]] std::vector<Vector3<T>> increments(const std::vector<Quaternion<T>>& p) const {
    const std::size_t last = size() - 1;
    std::vector<Vector3<T>> w(size() + 1);
    for (std::size_t i = 1; i <= last; ++i) w[i] = increment<T>(p[i - 1], p[i]);
    if (closed()) {
      w.front() = w.back() = increment<T>(p[last], come_round(p[0], *settings_.closure));
      return w;
    }
    w.front() = increment_before<T>(w[1]);
    w.back() = increment_after<T>(w[last], p[last]);
    return w;
  }

  /// From the ghost to the first control, so that with ω = λ' Ad(exp(-μ v)) w + μ' v the curve starts at the end's
  /// rate.
  template <Number T>
  [[nodiscard]] Vector3<T> increment_before(const Vector3<T>& v) const {
    if (settings_.start.rule == EndRule::natural) return v;
    const auto& [value, rate] = weights_.front();
    const Vector3<T> missing = constant<T>(settings_.start.angular_velocity) - v * T(rate[1]);
    return to_world<T>(exp<T>(v * T(value[1])), missing) * T(1.0 / rate[0]);
  }

  /// From the last control p to the ghost, as above; the turn from p to the curve is that to the key which it meets.
  template <Number T>
  [[nodiscard]] Vector3<T> increment_after(const Vector3<T>& w, const Quaternion<T>& p) const {
    if (settings_.end.rule == EndRule::natural) return w;
    const auto& rate = weights_.back().rate;
    const Vector3<T> carried = to_body<T>(p.conjugate() * constant<T>(keys_.back()), w);
    return (constant<T>(settings_.end.angular_velocity) - carried * T(rate[0])) * T(1.0 / rate[1]);
  }

  std::vector<Eigen::Quaterniond> keys_, controls_;
  std::vector<KnotWeights> weights_;
  FamilySettings settings_;
};

}  // namespace

Expected<CumulativeCurve<BSplineBasis<3>>> BSplineThrough::curve(const Keyframes& keys,
                                                                 const FamilySettings& settings) {
  Knots knots = four_key_knots(keys, settings);
  Basis basis = basis_of(knots, settings);
  const std::vector<KnotWeights> weights = weights_of(knots, basis, keys.size());
  return solve_chain(info.name,
                     [&](double share, const BSplineChain* before) {
                       return BSplineChain(keys, settings, weights, share, before);
                     })
      .map([&](const BSplineChain& chain) {
        return CumulativeCurve<Basis>(std::move(knots), std::move(basis), chain.polygon());
      });
}

Expected<HermitePath<3>> BSplineThrough::path(const Keyframes& keys, const FamilySettings& settings) {
  return cubic_spline_path(info.name, keys, settings);
}

}}}  // namespace orispline::families
