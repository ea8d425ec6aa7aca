// SPDX-License-Identifier: Apache-2.0
#pragma once

// Families of curves of one's own, as classes: what every task takes as a method.

#include <orispline/curve/cumulative_curve.hpp>
#include <orispline/curve/four_key_curve.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/curve/own_family.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A class that states a family, as those of the library do: `static constexpr FamilyInfo info`, and one of
/// - `basis(settings)`: cumulative blending functions of four keys, of a CumulativeBasis;
/// - `curve<P>(keys, settings)`: a curve through points of one kind, orientations or positions;
/// - `curve(keys, settings)` through orientations, with or without a `path(keys, settings)` through positions.
/// What these give is, or is an Expected of, a class with `knots()` and `point(t, segment)` over any Number.
template <class F>
concept StatedFamily = requires {
  { F::info } -> std::convertible_to<const FamilyInfo&>;
};

/// The family that a class states, for methods.
template <StatedFamily F>
class FamilyOf final : public OwnFamily {
 public:
  FamilyOf() : info_(F::info) { info_.own = this; }

  [[nodiscard]] const FamilyInfo& info() const noexcept override { return info_; }
  [[nodiscard]] Expected<AnyCurve> curve(const Keyframes& keys, const FamilySettings& settings) const override {
    return any<Eigen::Quaterniond>(build<F, Eigen::Quaterniond>(keys, settings));
  }
  /// Error: bad_argument where the family has no curves of positions.
  [[nodiscard]] Expected<AnyPath> path(const Keyframes& keys, const FamilySettings& settings) const override {
    if constexpr (requires { build<F, Eigen::Vector3d>(keys, settings); })
      return any<Eigen::Vector3d>(build<F, Eigen::Vector3d>(keys, settings));
    else
      return failure(ErrorCode::bad_argument,
                     std::string(info_.name) + ": this method has no paths, wanted keys without positions");
  }

 private:
  template <CurvePoint P, class Curve>
  [[nodiscard]] static Expected<AnyCurveThrough<P>> any(Expected<Curve> curve) {
    return std::move(curve).map([](Curve&& made) { return AnyCurveThrough<P>(std::move(made)); });
  }
  template <CurvePoint P, class Curve>
  [[nodiscard]] static Expected<AnyCurveThrough<P>> any(Curve curve) {
    return AnyCurveThrough<P>(std::move(curve));
  }

  FamilyInfo info_;
};

/// The method of a family that a class states, for make_curve() and every task.
template <StatedFamily F>
[[nodiscard]] Method own_method(CurveOptions options = {}) {
  return Method(std::make_shared<const FamilyOf<F>>(), std::move(options));
}

}}  // namespace orispline
