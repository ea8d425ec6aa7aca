// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <orispline/curve/chain.hpp>
#include <orispline/curve/loop.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The keys from the same first one on with every step shortened to a share of its length.
template <CurvePoint P>
[[nodiscard]] std::vector<P> with_steps_of(double share, std::span<const P> keys) {
  std::vector<P> shortened(keys.begin(), keys.end());
  if (share == 1.0) return shortened;
  for (std::size_t i = 1; i < keys.size(); ++i)
    shortened[i] = displaced(shortened[i - 1], share * displacement(keys[i - 1], keys[i]));
  return shortened;
}

/// Positions seen from the first one in units of their extent: equations over them are solved to the same tolerance
/// wherever they lie and however far apart.
struct UnitPositions {
  Eigen::Vector3d origin;
  double extent = 0.0;  ///< [m]
  std::vector<Eigen::Vector3d> points;

  explicit UnitPositions(std::span<const Eigen::Vector3d> positions) : origin(positions.front()) {
    for (const Eigen::Vector3d& p : positions) extent = std::max(extent, (p - origin).norm());
    if (!(extent > 0.0)) extent = 1.0;
    for (const Eigen::Vector3d& p : positions) points.push_back((p - origin) / extent);
  }
};

/// Control points, one per key, sought so that their curve passes through the keys: a ChainProblem.
///
/// `rule(i, before, at, after, key)` over any Number is what control points i-1, i, i+1 miss key i by; beyond the ends
/// the control points are reflected, around a loop they are those of the other side. `Rule::forbidden_turn` [rad]: so
/// far from its key a control orientation is wrong.
template <CurvePoint P, class Rule>
class PointChain {
 public:
  /// Starts where `before` has brought its control points relative to its keys, else at the keys.
  PointChain(std::vector<P> keys, Rule rule, std::optional<Closure> closure, const PointChain* before)
      : keys_(std::move(keys)), points_(keys_), rule_(std::move(rule)), closure_(closure) {
    for (std::size_t i = 0; before && i < keys_.size(); ++i) points_[i] = displaced(keys_[i], before->offset(i));
  }

  [[nodiscard]] const std::vector<P>& points() const noexcept { return points_; }
  [[nodiscard]] std::size_t size() const noexcept { return keys_.size(); }
  [[nodiscard]] bool closed() const noexcept { return closure_.has_value(); }

  template <Number T>
  [[nodiscard]] std::vector<Vector3<T>> residual(std::span<const Vector3<T>> steps) const {
    std::vector<PointOver<P, T>> p;
    for (std::size_t i = 0; i < size(); ++i) p.push_back(displaced(constant<T>(points_[i]), steps[i]));
    const std::size_t last = size() - 1;
    const auto beyond = [&](const auto& end, const auto& inwards, const auto& across) {
      return closure_ ? come_round(across, *closure_) : on_geodesic(end, inwards, -1.0);
    };
    const auto before = beyond(p[0], p[1], p[last]), after = beyond(p[last], p[last - 1], p[0]);
    std::vector<Vector3<T>> missing;
    for (std::size_t i = 0; i <= last; ++i)
      missing.push_back(rule_(i, i > 0 ? p[i - 1] : before, p[i], i < last ? p[i + 1] : after, constant<T>(keys_[i])));
    return missing;
  }

  void move(std::span<const Vector3<double>> steps) {
    for (std::size_t i = 0; i < size(); ++i) {
      points_[i] = displaced(points_[i], steps[i]);
      if constexpr (std::same_as<P, Eigen::Quaterniond>) points_[i].normalize();
    }
  }

  /// No control orientation is as far from its key as the rule forbids.
  [[nodiscard]] bool plausible() const {
    if constexpr (std::same_as<P, Eigen::Quaterniond>)
      for (std::size_t i = 0; i < size(); ++i)
        if (!(offset(i).norm() < Rule::forbidden_turn)) return false;
    return true;
  }

 private:
  [[nodiscard]] Eigen::Vector3d offset(std::size_t i) const { return displacement(keys_[i], points_[i]); }

  std::vector<P> keys_, points_;
  Rule rule_;
  std::optional<Closure> closure_;
};

/// The control points, one per key, whose open or closed curve passes through the keys. Errors: not_converged.
template <CurvePoint P, class Rule>
[[nodiscard]] Expected<std::vector<P>> control_points_through(std::span<const P> keys, std::string_view method,
                                                              Rule rule, std::optional<Closure> closure = {}) {
  using Chain = PointChain<P, Rule>;
  const auto solved = [&](std::span<const P> points) {
    return solve_chain(method,
                       [&](double share, const Chain* before) {
                         return Chain(with_steps_of(share, points), rule, closure, before);
                       })
        .map([](const Chain& chain) { return chain.points(); });
  };
  if constexpr (std::same_as<P, Eigen::Quaterniond>) {
    return solved(keys);
  } else {
    const UnitPositions unit(keys);
    return solved(unit.points).map([&](std::vector<P> points) {
      for (P& p : points) p = unit.origin + unit.extent * p;
      return points;
    });
  }
}

}}  // namespace orispline
