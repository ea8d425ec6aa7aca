// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/base/warning.hpp>
#include <orispline/curve/track.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// `near_half_turn`: steps between keys that may as well go the other way round (`steps`).
[[nodiscard]] ORISPLINE_EXPORT std::vector<Warning> warnings_of(const KeyframeReport& keys);

/// What is noteworthy about the curve of a method through the keys of a track, with the track's settings.
///
/// `closing_step`: a loop returns to its first key so soon after the last that its rates are huge (`closing_step_s`,
/// `shortest_step_s` of the others). `overwound_tangent`: a handle turns a full turn or more away from its key, where a
/// curve of slerps loses its continuity (`turn_deg`). `contradicting_rates`: a method that reads rates has such as the
/// keys do not turn with (`misfit`: their difference over their size), and what they may be instead.
/// `contradicting_accelerations`: angular accelerations by which the body would turn far quicker than the angular
/// velocities say (`summed_rad_s`, `largest_rate_rad_s`). `jump_at_key`: the segments of a curve of one's own do not
/// meet (`jump_deg` of the largest, `keys`). `corner_at_key`: by the parameters of blending functions of one's own the
/// body rests or turns back at keys (`keys`). `overturned_span`: the curve turns more than twice as far as its keys,
/// beside two that are too near in time (`turn_deg`, `turn_of_keys_deg`). `overshot_span`, where that is not told: it
/// swings away from the shortest way between two keys by more than half their step (`swing_deg`, `step_deg`). And what
/// is of the keys. `made`: that curve, where it is at hand; else it is made where it is needed.
[[nodiscard]] ORISPLINE_EXPORT std::vector<Warning> warnings_of(const Method& method, const Track& track,
                                                                const AnyCurve* made = nullptr);

}}  // namespace orispline
