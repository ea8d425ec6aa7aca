// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <orispline/base/progress.hpp>
#include <orispline/tune/segment_residuals.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A curve at some values of its variables.
struct ConstructedCurve {
  std::vector<TensionSegment> segments;           ///< without variables of their own
  std::vector<std::vector<SegmentSlope>> slopes;  ///< of every segment, by the variables that it depends on
};

/// A curve that is not affine in what tuning varies: what it is made of, and how that changes with every variable.
class Construction {
 public:
  virtual ~Construction() = default;
  /// Of every segment, increasing. Where all variables reach it, those that are near enough to count.
  [[nodiscard]] virtual const std::vector<std::vector<std::size_t>>& variables() const noexcept = 0;
  /// Absent where the construction has no solution, and where the work is stopped.
  [[nodiscard]] virtual std::optional<ConstructedCurve> at(const CurveOptions& options,
                                                           const OpenEndedWork* work) const = 0;
};

/// What is tuned of a family that is not affine in its parameters.
struct ConstructionModel {
  TensionModel model;  ///< without segments
  std::unique_ptr<Construction> construction;
  std::optional<double> closed_form{};  ///< the value of all variables whose linearised energy is least
};

/// Whether tuning varies the construction of the family's curves.
[[nodiscard]] bool is_constructed(std::string_view method);

/// The parameters named, at all keys where they have influence. The keys live longer than the model. Errors: those of
/// make_curve(); bad_argument for values of ghost keys.
[[nodiscard]] Expected<ConstructionModel> construction_model(const FamilyInfo& family, const Keyframes& keys,
                                                             const CurveOptions& options,
                                                             const std::vector<std::string>& parameters);

/// The variables beyond so many keys from a segment are left out of the derivatives of solved constructions, not of the
/// values: the influence falls to about a quarter per key.
inline constexpr std::size_t construction_reach = 20;

/// The variables, by key, that lie within the reach of every segment.
[[nodiscard]] std::vector<std::vector<std::size_t>> variables_in_reach(const std::vector<Variable>& variables,
                                                                       std::size_t segments);

/// How the control orientations or the rates of each kind of curve follow from what is varied.
using MakeConstruction = std::unique_ptr<Construction>(const Keyframes& keys, const FamilySettings& settings,
                                                       const std::vector<Variable>& variables);
MakeConstruction nu_construction, nu_exact_construction, beta_construction, beta_through_construction,
    beta_g2_construction, beta_g2_global_construction;

}}  // namespace orispline
