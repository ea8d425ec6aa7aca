// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/base/progress.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/retime/retime.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Keys for the method `auto`, whose curve goes along that of the method through the track at an even rate or speed:
/// what retime() gives for RetimeOptions::constant_rate or constant_speed. Rests have no place in the length of a path,
/// and keep their duration.
///
/// The keys are those of the path's own curve at the times of an EvenLaw for each stretch of an EvenPath, halved until
/// the rate and the path are within `largest_unevenness`, `largest_turn` and `largest_shift` of what they shall be.
/// Source: our own, docs/retime.md.
///
/// Errors: those of EvenPath; bad_argument for a path with stops without an ease; not_converged where more than
/// `most_even_keys` would be needed; cancelled.
[[nodiscard]] Expected<Retiming> evenly_retimed(const Track& track, const Method& method, const RetimeOptions& options,
                                                const Progress& progress);

inline constexpr double largest_unevenness = 1e-3;  ///< of the rate or the speed, as a share of the one asked for
inline constexpr double largest_turn = 1e-4;        ///< of the orientation from the path's [rad]
inline constexpr double largest_shift = 1e-5;       ///< of the position, as a share of the distance between all keys
inline constexpr std::size_t most_even_keys = 100000;

}}  // namespace orispline
