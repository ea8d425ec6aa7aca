// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

#include <orispline/base/abi.hpp>

namespace orispline::inline ORISPLINE_ABI::families {

/// Twelve Gaussian processes that recorded motion may be between keys: integrated white noise, so that the best guess
/// is the cubic spline, alone and with seven shares of key noise; then four whose rates forget within about an
/// interval.
inline constexpr std::size_t model_count = 12, noise_models = 8, velocity_models = 4;

/// Share of the variance of a second difference that is key noise, of the first eight models.
inline constexpr std::array<double, noise_models> noise_shares{0.0, 0.03, 0.1, 0.2, 0.35, 0.5, 0.65, 0.8};

/// How smooth the velocity is and how long it remembers, in intervals, of the last four models.
struct VelocityModel {
  int twice_smoothness;  ///< 2ν of the Matérn process: 1 gives the spline in tension
  double length;
};
inline constexpr std::array<VelocityModel, velocity_models> velocity_shapes{
    VelocityModel{1, 0.7}, VelocityModel{1, 1.5}, VelocityModel{3, 0.7}, VelocityModel{3, 1.2}};

using PerModel = Eigen::Array<double, static_cast<int>(model_count), 1>;

/// The keys whose times a window has.
inline constexpr std::size_t window_keys = 9;

/// Nine keys seen from one of them.
struct WindowTimes {
  std::array<double, window_keys> x;  ///< times since key `centre`, in median intervals, increasing
  std::size_t centre;
};

/// What every model makes of the increments from the centre of a window to its keys: linear maps, which depend on the
/// times alone. Source: docs/families/measured.md, Formula (1).
struct ModelMaps {
  std::array<PerModel, window_keys> miss;           ///< of the centre by its prediction from the other eight keys
  std::array<PerModel, window_keys> first, second;  ///< derivatives at the centre, by median intervals
  PerModel precision;                               ///< one over the variance of the miss
};
[[nodiscard]] ModelMaps model_maps(const WindowTimes& window);

/// How far a new record at the centre is expected from the curve through the other eight keys: the variance by each
/// model. The curve joins the noise of the keys at both sides of the centre linearly.
[[nodiscard]] PerModel model_variances(const WindowTimes& window);

}  // namespace orispline::inline ORISPLINE_ABI::families
