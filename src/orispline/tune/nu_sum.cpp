// SPDX-License-Identifier: Apache-2.0
#include <orispline/tune/nu_sum.hpp>

#include <algorithm>
#include <limits>

#include <orispline/curve/chain_jacobian.hpp>
#include <orispline/families/nu.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/banded_lu.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

using families::Nu;
using families::NuRatios;
using families::NuRule;
using families::NuSteps;
using Slope = Jet<double, 1>;
template <Number T>
using ControlsOver = std::vector<Quaternion<T>>;
using Controls = ControlsOver<Slope>;

/// The control orientations, which turn by these rotation vectors per unit of a variable.
Controls moving(const std::vector<Eigen::Quaterniond>& controls, const Eigen::VectorXd& turns) {
  Controls moved;
  for (std::size_t i = 0; i < controls.size(); ++i) {
    Vector3<Slope> turn;
    for (Eigen::Index axis = 0; axis < 3; ++axis) turn[axis].c[1] = turns[3 * static_cast<Eigen::Index>(i) + axis];
    moved.push_back(constant<Slope>(controls[i]) * exp<Slope>(turn));
  }
  return moved;
}

/// By how much key i is missed, as a function of its controls.
template <Number T, class Rule>
Vector3<T> missed(const Rule& rule, std::size_t i, const ControlsOver<T>& d, const Eigen::Quaterniond& key) {
  const std::size_t before = i > 0 ? i - 1 : i, after = std::min(i + 1, d.size() - 1);
  return rule.template operator()<T>(i, d[before], d[i], d[after], constant<T>(key));
}

/// The ratios as functions of the ν of one key.
NuRatios<Slope> ratios_along(NuSteps step, const std::vector<double>& nu, std::size_t key) {
  std::vector<Slope> gamma;
  for (std::size_t i = 0; i < nu.size(); ++i)
    gamma.push_back(families::nu_gamma<Slope>(step, i, i == key ? Slope::variable(nu[i]) : Slope(nu[i])));
  return families::nu_ratios<Slope>(step, gamma);
}

/// Derivatives of what the keys are missed by along the turns of the controls.
BandedMatrix control_jacobian(const Nu::Construction& made, std::span<const Eigen::Quaterniond> keys) {
  using D = chain::Dual9;
  const auto all_missed = [&](const chain::DualSteps& turns) {
    ControlsOver<D> d;
    for (std::size_t i = 0; i < keys.size(); ++i) d.push_back(constant<D>(made.controls[i]) * exp<D>(turns[i]));
    chain::DualSteps values;
    for (std::size_t i = 0; i < keys.size(); ++i) values.push_back(missed<D>(made.rule, i, d, keys[i]));
    return values;
  };
  BandedMatrix matrix(3 * keys.size(), 5);
  chain::differentiate(keys.size(), false, all_missed,
                       [&](std::size_t key, std::size_t control, const Eigen::Matrix3d& block) {
                         matrix.add(3 * key, 3 * control, block);
                       });
  return matrix;
}

Eigen::Vector3d values_of(const Vector3<Slope>& v) { return {v[0].c[0], v[1].c[0], v[2].c[0]}; }
Eigen::Vector3d slopes_of(const Vector3<Slope>& v) { return {v[0].c[1], v[1].c[1], v[2].c[1]}; }

/// The handles of the cubic after key i.
struct Handles {
  Vector3<Slope> leaving, arriving;
};

Handles handles(const Controls& d, const NuRatios<Slope>& ratios, std::span<const Eigen::Quaterniond> keys,
                std::size_t i) {
  return {increment<Slope>(constant<Slope>(keys[i]), slerp<Slope>(d[i], d[i + 1], ratios.after[i])),
          increment<Slope>(slerp<Slope>(d[i], d[i + 1], ratios.before[i + 1]), constant<Slope>(keys[i + 1]))};
}

}  // namespace

NuSum::NuSum(const Keyframes& keys, const TensionModel& model, const Goal& goal, const OpenEndedWork* work)
    : SumOfSquares(work), keys_(keys), model_(model), goal_(goal), variables_(keys.size() - 1) {
  for (std::size_t i = 0; i < variables_.size(); ++i)
    for (std::size_t v = i > reach ? i - reach : 0; v < std::min(model.variables.size(), i + reach); ++v)
      variables_[i].push_back(v);
  std::vector<double> values;
  for (const Variable& variable : model.variables) values.push_back(variable.initial);
  move_to(values);
}

void NuSum::move_to(const std::vector<double>& values) {
  segments_.clear();
  slopes_.assign(variables_.size(), {});
  const CurveOptions options = model_.with(values);
  const auto made = settle(Nu::info, options, keys_.size()).and_then([&](const FamilySettings& settings) {
    return Nu::construction(keys_, settings);
  });
  if (!made) return;
  const auto q = keys_.orientations();
  const NuSteps step{keys_.times()};
  const std::vector<double>& nu = options.parameters.find("nu")->second;
  const BandedLu equations(control_jacobian(*made, q));
  if (!equations.regular()) return;
  const auto size = 3 * static_cast<Eigen::Index>(q.size());
  const Controls still = moving(made->controls, Eigen::VectorXd::Zero(size));
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    const Handles h = handles(still, ratios_along(step, nu, 0), q, i);
    segments_.push_back(handle_segment(TensionSegment::Product::slerps, keys_.times()[i], step(i + 1), q[i], q[i + 1],
                                       values_of(h.leaving), values_of(h.arriving)));
  }
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (stopped()) return segments_.clear();
    const NuRule<Slope> rule{ratios_along(step, nu, model_.variables[v].key), made->rule.start, made->rule.end};
    Eigen::VectorXd change = Eigen::VectorXd::Zero(size);
    for (std::size_t i = 0; i < q.size(); ++i)
      change.segment<3>(3 * static_cast<Eigen::Index>(i)) = slopes_of(missed<Slope>(rule, i, still, q[i]));
    const Controls d = moving(made->controls, equations.solve(-change));
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      if (variables_[i].empty() || v < variables_[i].front() || v > variables_[i].back()) continue;
      const Handles h = handles(d, rule.ratios, q, i);
      slopes_[i].push_back({slopes_of(h.leaving), Eigen::Vector3d::Zero(), slopes_of(h.arriving)});
    }
  }
}

std::size_t NuSum::residual_count(std::size_t block) const { return orispline::residual_count(goal_, block); }

Eigen::VectorXd NuSum::residuals(std::size_t block) const {
  if (segments_.empty())
    return Eigen::VectorXd::Constant(static_cast<Eigen::Index>(residual_count(block)),
                                     std::numeric_limits<double>::quiet_NaN());
  return residual_values(segments_[block], goal_, block, {});
}

Eigen::MatrixXd NuSum::jacobian(std::size_t block) const {
  return residual_jacobian(segments_[block], goal_, block, slopes_[block]);
}

Expected<TensionModel> nu_model(const Keyframes& keys, const CurveOptions& options) {
  return make_curve({Nu::info.name, options}, keys)
      .and_then([&](const AnyCurve&) { return settle(Nu::info, options, keys.size()); })
      .map([&](const FamilySettings& settings) {
        TensionModel model{.variables = {}, .segments = {}, .options = options};
        const std::vector<double> nu = model.options.parameters["nu"] = settings.per_key("nu").all(keys.size());
        const Parameter& p = Nu::parameters.front();
        for (std::size_t key = 1; key + 1 < keys.size(); ++key)
          model.variables.push_back({"nu", key, nu[key], p.lowest, p.highest});
        return model;
      });
}

}  // namespace orispline::inline ORISPLINE_ABI
