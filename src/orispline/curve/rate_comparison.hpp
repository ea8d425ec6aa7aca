// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What angular velocities may be, other than those of the body in its own frame [rad/s].
struct RateMeaning {
  std::string code;  ///< `world`, `conjugate`, `reversed`, `body_taken_for_world`, `degrees`, `degrees_world`, …,
                     ///< `axes`, `scaled`
  std::string cure;  ///< what to do, in the manner of an Error's message
};

/// Angular velocities that came with orientations, beside those with which the orientations themselves turn.
struct RateComparison {
  std::span<const Eigen::Quaterniond> orientations;
  std::span<const Eigen::Vector3d> given;   ///< taken for body rates
  std::span<const Eigen::Vector3d> turned;  ///< [rad/s], body frame

  /// What both have in common is left out: a gyro may have a bias.
  enum class Bias { none, constant } bias = Bias::none;

  /// Root mean square of the difference, over that of the larger ones: 0 where they agree, √2 of independent ones, 2
  /// where one is the reverse of the other.
  [[nodiscard]] double misfit() const;
  /// The meaning under which they agree, where there is one and they do not agree as body rates.
  ///
  /// With R from body to world and ω of the orientations as they were read, rates of the world are R ω. Had the
  /// orientations to be conjugated, body rates were -R ω, for R̄ = Rᵀ turns with -R ω; and rates of the world -ω.
  [[nodiscard]] std::optional<RateMeaning> better_meaning() const;
};

}}  // namespace orispline
