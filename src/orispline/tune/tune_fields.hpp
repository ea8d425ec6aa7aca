// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/fields/field_info.hpp>
#include <orispline/tune/tune.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

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
