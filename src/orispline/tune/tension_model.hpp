// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orispline/base/progress.hpp>
#include <orispline/curve/curve_through.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Bernstein coefficients of degree `form_degree` of a segment's blending functions β̃_1, β̃_2, β̃_3.
using BlendingRows = std::array<BernsteinForm, 3>;

/// The rotation vectors of a segment's factors [rad].
using Increments = std::array<Eigen::Vector3d, 3>;

/// A segment whose blending functions are affine in the tensions of its two keys.
struct TensionSegment {
  enum class Product {
    cumulative,  ///< from ∏ exp(β̃_k(u) φ_k)
    slerps,      ///< a cubic of slerps with the handles β̃_1'(0) φ_1/3 and β̃_3'(1) φ_3/3 at its two keys
    bezier,      ///< a cumulative cubic with the same handles
  };
  Product product = Product::cumulative;
  double start = 0.0, step = 0.0;  ///< [s]
  Eigen::Quaterniond from, to;     ///< the base of the product; of handles the two keys
  Increments increments;
  BlendingRows constant;                        ///< with all variables zero
  std::optional<Eigen::Vector3d> correction{};  ///< of `beta-g2`: a factor behind a cumulative cubic
  std::vector<std::size_t> variables{};         ///< that it depends on, increasing
  std::vector<BlendingRows> slopes{};           ///< what a unit of each of them adds
};

/// What tuning varies: one of the family's parameters at one key.
struct Variable {
  std::string parameter;
  std::size_t key;
  double initial, lowest, highest;
};

/// A family's curve through keys as a function of its tensions.
struct TensionModel {
  std::vector<Variable> variables;  ///< by key; those without influence are left out
  std::vector<TensionSegment> segments;
  CurveOptions options;  ///< of the curve, every tension that may vary with one value per key

  /// The options with other values of the variables.
  [[nodiscard]] CurveOptions with(const std::vector<double>& values) const;
};

/// A polynomial of lower degree with coefficients of degree `form_degree`.
[[nodiscard]] BernsteinForm elevated(BernsteinForm form, std::size_t degree);

/// A cubic between two keys with the given handles [rad] on leaving and on arriving, without variables.
[[nodiscard]] TensionSegment handle_segment(TensionSegment::Product product, double start, double step,
                                            const Eigen::Quaterniond& from, const Eigen::Quaterniond& to,
                                            const Eigen::Vector3d& leaving, const Eigen::Vector3d& arriving);

/// A cumulative cubic with these increments between its control points, without variables.
[[nodiscard]] TensionSegment cumulative_segment(double start, double step, const Eigen::Quaterniond& from,
                                                const Increments& increments);

/// The blending function of a correction.
[[nodiscard]] BernsteinForm correction_form();

/// The parameters of a family that tuning can free, in the order of the family; empty for other families.
[[nodiscard]] std::vector<std::string> tunable_parameters(const FamilyInfo& family);

/// The model of a family that is affine in the parameters named, as all are that are not constructed.
///
/// It is read off the family itself: a function that is affine is known from its values at 0 and at 1. The tensions of
/// an end key that is clamped or at rest stay as they are, for there the ghost key follows them.
/// Errors: those of make_curve(); bad_argument for `tcb` with the end rule `handle`, and for `uniform` of order 4 or 5;
/// cancelled where the work is stopped.
[[nodiscard]] Expected<TensionModel> tension_model(const FamilyInfo& family, const Keyframes& keys,
                                                   const CurveOptions& options,
                                                   const std::vector<std::string>& parameters,
                                                   const OpenEndedWork& work);

}}  // namespace orispline
