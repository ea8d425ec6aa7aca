// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <orispline/analysis/distance.hpp>
#include <orispline/base/interval.hpp>
#include <orispline/base/progress.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/fields/field_info.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What tuning makes as small as it can.
enum class Objective {
  linearised,    ///< ∫|Σ β̃_k'' φ_k|² dt [rad²/s³]: ∫|α|² less what the factors turn each other
  acceleration,  ///< ∫|α|² dt [rad²/s³]
  torque,        ///< ∫|J α + ω × J ω|² dt, body frame [(kg m²)² rad²/s³ = N² m² s]
  jerk,          ///< ∫|dα/dt|² dt, body frame [rad²/s⁵]
  curvature,     ///< ∫|κ|² ds = ∫|α⊥|²/|ω|³ dt [1/rad], of the path whatever its speed: PathShape
  fit,           ///< mean square of the angle to a reference [rad²]
};

/// How tensions are sought.
struct TuneOptions {
  Objective objective = Objective::acceleration;
  std::optional<Eigen::Matrix3d> inertia{};  ///< [kg m²], body frame; for `torque`
  OrientationSeries reference{};             ///< for `fit`; times [s] of the keys
  std::optional<Interval> bounds{};          ///< of every tension; absent: what the family accepts
  std::vector<std::string> parameters{};     ///< to vary; empty: all that the family lets vary
};

/// The result of tuning.
struct Tuning {
  Track track{};                          ///< the one given, its settings the values that were found
  Method method{};                        ///< the one given, with one value per key of every parameter that was varied
  std::vector<std::string> parameters{};  ///< the ones that were varied
  double energy_before = 0.0, energy_after = 0.0;  ///< in the unit of the objective
  std::size_t iterations = 0;                      ///< after the closed form; 0 where that is the answer
  double stationarity = 0.0;        ///< by which share of the energy a Gauss–Newton step would lower it still
  std::vector<Warning> warnings{};  ///< `not_at_rest`; of the inertia that counts, and of the method's curve
};

/// Error (bad_argument): options that contradict each other, such as an objective without what it needs, and those that
/// are wrong whatever the keys are.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check(const TuneOptions& options);

/// The methods whose tensions can be tuned, between commas.
[[nodiscard]] ORISPLINE_EXPORT std::string tunable_methods();

/// The tensions that make the objective least, starting from those of the method and, where it is silent, of the track.
///
/// The closed form minimises `linearised` by one banded solve in linear time; every other objective is refined from
/// there, in 200 iterations at most, usually to a stationarity of 1e-14. More than 1e-8 is a warning, `not_at_rest`
/// (`stationarity`, `iterations`). Tensions without influence stay as they are, and all where the energy is no more
/// than the rounding of the keys. Source: docs/tune.md. Errors: those of make_curve() and of check(); bad_argument for
/// a family without tensions, an unknown parameter, a loop; bad_data for fewer than three keys and for a reference
/// without a time between the first and the last key; not_converged where no tensions that are not at rest are better
/// than those before; cancelled.
[[nodiscard]] ORISPLINE_EXPORT Expected<Tuning> tune(const Track& track, const Method& method,
                                                     const TuneOptions& options = {}, const Progress& progress = {});

template <>
inline constexpr std::array words<Objective>{
    word("linearised", Objective::linearised,
         "∫|α|² dt without the part by which the factors turn each other, in closed form"),
    word("acceleration", Objective::acceleration, "∫|α|² dt, α the angular acceleration"),
    word("torque", Objective::torque, "∫|Jα + ω × Jω|² dt for a body of the inertia J"),
    word("jerk", Objective::jerk, "∫|dα/dt|² dt"),
    word("curvature", Objective::curvature,
         "∫|κ|² ds, κ the change of the direction of the turn by the angle s travelled, whatever the speed"),
    word("fit", Objective::fit, "mean square of the angle to the reference, at its times between the end keys")};

/// In which the energies of an objective are.
[[nodiscard]] ORISPLINE_EXPORT std::string_view unit_of(Objective objective) noexcept;

template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<TuneOptions>() noexcept;
template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<Tuning>() noexcept;

}}  // namespace orispline
