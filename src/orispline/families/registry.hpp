// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include <orispline/curve/curve.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/handle_rates.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/curve/path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Every family's description, in the order of the list.
[[nodiscard]] ORISPLINE_EXPORT std::span<const FamilyInfo> families_info() noexcept;

/// The family of that name or alias; an unknown name is an error (bad_argument) that lists the known ones.
[[nodiscard]] ORISPLINE_EXPORT Expected<const FamilyInfo*> find_family(std::string_view name);

/// The family of a method, of the registry or one's own. Error: that of the name.
[[nodiscard]] ORISPLINE_EXPORT Expected<const FamilyInfo*> family_of_method(const Method& method);

/// Builds the curve of a method through (or near) the keys: `make_curve("auto", keys)`.
///
/// One key gives a constant curve. Errors: bad_argument for an unknown name or options that the method does not accept;
/// bad_data for too few keys; not_converged where the method solves equations that have no solution it can find.
[[nodiscard]] ORISPLINE_EXPORT Expected<AnyCurve> make_curve(const Method& method, const Keyframes& keys);

/// The orientation curve with the path of its kind through the keys' positions, if they have any. Errors: those of
/// make_curve().
[[nodiscard]] ORISPLINE_EXPORT Expected<PoseCurve> make_pose_curve(const Method& method, const Keyframes& keys);

/// The handle that turns farthest away from its key, where that is a full turn or more: there a curve of slerps
/// (`squad-timed`, `shoemake`, `tcb`) is no longer C1, or goes another way than its formula means. Absent for other
/// families. Errors: those of make_curve() before anything is solved.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::optional<HandleTurn>> overwound_tangent(const Method& method,
                                                                                     const Keyframes& keys);

}}  // namespace orispline
