// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <orispline/base/expected.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/method.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace families {

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

/// What the keys say about the motion that they are of.
struct ModelBelief {
  std::array<double, model_count> models{1.0};  ///< shares of the models, 1 together
  double polynomial = 1.0;                      ///< how far the polynomial of `auto` is to be believed
  double polynomial9 = 0.0;                     ///< how far the one through nine keys is to be believed instead
};

}  // namespace families

/// What the keys of a track say about the motion that they are of, by the method `measured`.
struct KeyFindings {
  double interval = 0.0;         ///< median time between keys [s], the unit of the models' lengths
  families::ModelBelief belief;  ///< the models' shares and how far polynomials are to be believed
  double trust = 0.0;            ///< mean share of a key's window that counts: less across gaps and large turns
  bool given = false;            ///< all by settings of the method, none found
};

/// By the orientations of the keys, or by the settings as far as these give the numbers. Fewer than nine keys say
/// nothing. Error: bad_argument for settings that the method does not accept.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::optional<KeyFindings>> key_findings(const Method& method,
                                                                                 const Keyframes& keys);

/// The method with these findings as settings: a segment of its curve depends on ten keys.
[[nodiscard]] ORISPLINE_EXPORT Method with_findings(Method method, const KeyFindings& findings);

}}  // namespace orispline
