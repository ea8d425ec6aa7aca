// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <utility>
#include <vector>

#include <orispline/curve/chain_jacobian.hpp>
#include <orispline/math/banded_lu.hpp>
#include <orispline/math/geodesic.hpp>
#include <orispline/tune/construction.hpp>

// Control orientations, one per key, that a rule places so that the curve passes through the keys, and how they move
// with a variable of the rule: by the implicit function theorem.

namespace orispline { inline namespace ORISPLINE_ABI {

/// A number that knows how it changes with one variable.
using Slope = Jet<double, 1>;

[[nodiscard]] inline Eigen::Vector3d value_part(const Vector3<Slope>& v) { return {v[0].c[0], v[1].c[0], v[2].c[0]}; }
[[nodiscard]] inline Eigen::Vector3d slope_part(const Vector3<Slope>& v) { return {v[0].c[1], v[1].c[1], v[2].c[1]}; }

/// The orientation that turns by this rotation vector per unit of a variable.
[[nodiscard]] inline Quaternion<Slope> turning(const Eigen::Quaterniond& q, const Eigen::Vector3d& turn) {
  Vector3<Slope> by;
  for (Eigen::Index axis = 0; axis < 3; ++axis) by[axis].c[1] = turn[axis];
  return constant<Slope>(q) * exp<Slope>(by);
}

/// The image of an orientation in another one.
template <Number T>
[[nodiscard]] Quaternion<T> reflection(const Quaternion<T>& at, const Quaternion<T>& q) {
  return at * q.conjugate() * at;
}

/// By how much key i is missed by its control and the two beside it, reflected beyond the ends.
template <Number T, class Rule>
[[nodiscard]] Vector3<T> missed(const Rule& rule, std::size_t i, const std::vector<Quaternion<T>>& d,
                                const Eigen::Quaterniond& key) {
  const std::size_t last = d.size() - 1;
  const Quaternion<T> before = i > 0 ? d[i - 1] : reflection<T>(d[0], d[1]);
  const Quaternion<T> after = i < last ? d[i + 1] : reflection<T>(d[last], d[last - 1]);
  return rule(i, before, d[i], after, constant<T>(key));
}

/// Control orientations that solve for passing through the keys.
template <class Rule>
class MovingControls {
 public:
  MovingControls(const Rule& rule, std::span<const Eigen::Quaterniond> keys,
                 const std::vector<Eigen::Quaterniond>& controls)
      : keys_(keys), controls_(controls), equations_(derivatives(rule)) {
    for (const Eigen::Quaterniond& q : controls) still_.push_back(constant<Slope>(q));
  }

  [[nodiscard]] bool regular() const noexcept { return equations_.regular(); }
  [[nodiscard]] const std::vector<Quaternion<Slope>>& still() const noexcept { return still_; }

  /// The controls as functions of the variable that this rule depends on.
  template <class MovingRule>
  [[nodiscard]] std::vector<Quaternion<Slope>> along(const MovingRule& rule) const {
    Eigen::VectorXd change(3 * static_cast<Eigen::Index>(keys_.size()));
    for (std::size_t i = 0; i < keys_.size(); ++i)
      change.segment<3>(3 * static_cast<Eigen::Index>(i)) = -slope_part(missed<Slope>(rule, i, still_, keys_[i]));
    const Eigen::VectorXd turns = equations_.solve(std::move(change));
    std::vector<Quaternion<Slope>> moved;
    for (std::size_t i = 0; i < keys_.size(); ++i)
      moved.push_back(turning(controls_[i], turns.segment<3>(3 * static_cast<Eigen::Index>(i))));
    return moved;
  }

 private:
  /// Of what the keys are missed by along the turns of the controls.
  [[nodiscard]] BandedMatrix derivatives(const Rule& rule) const {
    using D = chain::Dual9;
    const auto all_missed = [&](const chain::DualSteps& turns) {
      std::vector<Quaternion<D>> d;
      for (std::size_t i = 0; i < keys_.size(); ++i) d.push_back(constant<D>(controls_[i]) * exp<D>(turns[i]));
      chain::DualSteps values;
      for (std::size_t i = 0; i < keys_.size(); ++i) values.push_back(missed<D>(rule, i, d, keys_[i]));
      return values;
    };
    BandedMatrix matrix(3 * keys_.size(), 5);
    chain::differentiate(keys_.size(), false, all_missed,
                         [&](std::size_t key, std::size_t control, const Eigen::Matrix3d& block) {
                           matrix.add(3 * key, 3 * control, block);
                         });
    return matrix;
  }

  std::span<const Eigen::Quaterniond> keys_;
  const std::vector<Eigen::Quaterniond>& controls_;
  BandedLu equations_;
  std::vector<Quaternion<Slope>> still_;
};

/// What constructions that solve equations over all keys have in common: each variable reaches all segments.
class SolvedConstruction : public Construction {
 public:
  SolvedConstruction(const Keyframes& keys, std::vector<Variable> list)
      : keys_(keys), list_(std::move(list)), variables_(variables_in_reach(list_, keys.size() - 1)) {}
  [[nodiscard]] const std::vector<std::vector<std::size_t>>& variables() const noexcept override { return variables_; }

 protected:
  [[nodiscard]] const Keyframes& keys() const noexcept { return keys_; }

  /// With the slopes that `along(variable)` gives as a function of the segment.
  template <class Along>
  [[nodiscard]] std::optional<ConstructedCurve> with_slopes(std::vector<TensionSegment> segments,
                                                            const OpenEndedWork* work, Along along) const {
    ConstructedCurve curve{std::move(segments), std::vector<std::vector<SegmentSlope>>(variables_.size())};
    for (std::size_t v = 0; v < list_.size(); ++v) {
      if (work && work->stopped()) return std::nullopt;
      const auto slope_at = along(list_[v]);
      for (std::size_t i = 0; i < variables_.size(); ++i)
        if (!variables_[i].empty() && variables_[i].front() <= v && v <= variables_[i].back())
          curve.slopes[i].push_back(slope_at(i));
    }
    return curve;
  }

 private:
  const Keyframes& keys_;
  std::vector<Variable> list_;
  std::vector<std::vector<std::size_t>> variables_;
};

}}  // namespace orispline
