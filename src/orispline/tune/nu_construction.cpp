// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/global_c2.hpp>
#include <orispline/families/nu.hpp>
#include <orispline/tune/solved_construction.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using families::Nu;
using families::NuExact;
using families::NuRatios;
using families::NuRule;
using families::NuSteps;

/// The ratios as functions of the ν of one key.
NuRatios<Slope> ratios_along(NuSteps step, const std::vector<double>& nu, std::size_t key) {
  std::vector<Slope> gamma;
  for (std::size_t i = 0; i < nu.size(); ++i)
    gamma.push_back(families::nu_gamma<Slope>(step, i, i == key ? Slope::variable(nu[i]) : Slope(nu[i])));
  return families::nu_ratios<Slope>(step, gamma);
}

/// The handles of the cubic after key i.
struct Handles {
  Vector3<Slope> leaving, arriving;
};

Handles handles(const std::vector<Quaternion<Slope>>& d, const NuRatios<Slope>& ratios,
                std::span<const Eigen::Quaterniond> keys, std::size_t i) {
  return {increment<Slope>(constant<Slope>(keys[i]), slerp<Slope>(d[i], d[i + 1], ratios.after[i])),
          increment<Slope>(slerp<Slope>(d[i], d[i + 1], ratios.before[i + 1]), constant<Slope>(keys[i + 1]))};
}

/// Of a curve through its keys, whose handles change.
SegmentSlope slope_of_handles(const Eigen::Vector3d& leaving, const Eigen::Vector3d& arriving) {
  return {.increments = {leaving, Eigen::Vector3d::Zero(), arriving}};
}

/// A cubic of slerps with these handles after every key.
template <class HandlesAfter>
std::vector<TensionSegment> slerp_segments(const Keyframes& keys, HandlesAfter handles_after) {
  const auto q = keys.orientations();
  const auto t = keys.times();
  std::vector<TensionSegment> segments;
  for (std::size_t i = 0; i + 1 < q.size(); ++i) {
    const auto [leaving, arriving] = handles_after(i);
    segments.push_back(
        handle_segment(TensionSegment::Product::slerps, t[i], t[i + 1] - t[i], q[i], q[i + 1], leaving, arriving));
  }
  return segments;
}

using TwoHandles = std::pair<Eigen::Vector3d, Eigen::Vector3d>;

class NuConstruction final : public SolvedConstruction {
 public:
  using SolvedConstruction::SolvedConstruction;

  [[nodiscard]] std::optional<ConstructedCurve> at(const CurveOptions& options,
                                                   const OpenEndedWork* work) const override {
    const auto made = settle(Nu::info, options, keys().size()).and_then([&](const FamilySettings& settings) {
      return Nu::construction(keys(), settings);
    });
    if (!made) return std::nullopt;
    const auto q = keys().orientations();
    const NuSteps step{keys().times()};
    const std::vector<double>& nu = options.parameters.find("nu")->second;
    const MovingControls controls(made->rule, q, made->controls);
    if (!controls.regular()) return std::nullopt;
    const NuRatios<Slope> still = ratios_along(step, nu, 0);
    auto segments = slerp_segments(keys(), [&](std::size_t i) {
      const Handles h = handles(controls.still(), still, q, i);
      return TwoHandles(value_part(h.leaving), value_part(h.arriving));
    });
    return with_slopes(std::move(segments), work, [&](const Variable& variable) {
      const NuRule<Slope> rule{ratios_along(step, nu, variable.key), made->rule.start, made->rule.end};
      return [d = controls.along(rule), ratios = rule.ratios, q](std::size_t i) {
        const Handles h = handles(d, ratios, q, i);
        return slope_of_handles(slope_part(h.leaving), slope_part(h.arriving));
      };
    });
  }
};

class NuExactConstruction final : public SolvedConstruction {
 public:
  using SolvedConstruction::SolvedConstruction;

  [[nodiscard]] std::optional<ConstructedCurve> at(const CurveOptions& options,
                                                   const OpenEndedWork* work) const override {
    const auto chain = settle(NuExact::info, options, keys().size()).and_then([&](const FamilySettings& settings) {
      return NuExact::rates(keys(), settings);
    });
    if (!chain) return std::nullopt;
    BandedMatrix matrix(3 * chain->size(), 5);
    chain->jacobian([&](std::size_t equation, std::size_t rate, const Eigen::Matrix3d& block) {
      matrix.add(3 * equation, 3 * rate, block);
    });
    const BandedLu equations(std::move(matrix));
    if (!equations.regular()) return std::nullopt;
    const auto t = keys().times();
    const auto third = [t](std::size_t i) { return (t[i + 1] - t[i]) / 3.0; };
    const std::vector<Eigen::Vector3d>& rates = chain->rates();
    auto segments =
        slerp_segments(keys(), [&](std::size_t i) { return TwoHandles(third(i) * rates[i], third(i) * rates[i + 1]); });
    return with_slopes(std::move(segments), work, [&](const Variable& variable) {
      Eigen::VectorXd change = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(chain->size()));
      change.segment<3>(3 * static_cast<Eigen::Index>(variable.key)) = -chain->residual_per_nu(variable.key);
      return [turned = equations.solve(std::move(change)), third](std::size_t i) {
        const auto of = [&](std::size_t k) -> Eigen::Vector3d {
          return third(i) * turned.segment<3>(3 * static_cast<Eigen::Index>(k));
        };
        return slope_of_handles(of(i), of(i + 1));
      };
    });
  }
};

}  // namespace

std::unique_ptr<Construction> nu_construction(const Keyframes& keys, const FamilySettings&,
                                              const std::vector<Variable>& variables) {
  return std::make_unique<NuConstruction>(keys, variables);
}

std::unique_ptr<Construction> nu_exact_construction(const Keyframes& keys, const FamilySettings&,
                                                    const std::vector<Variable>& variables) {
  return std::make_unique<NuExactConstruction>(keys, variables);
}

}}  // namespace orispline
