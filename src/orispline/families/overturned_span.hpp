// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/base/warning.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/track.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Says where the curve turns more than twice as far as its keys, and half a right angle more than they do: between
/// keys that stand far apart in time, beside two that are too near for how far they turn.
///
/// Only spans beside keys that turn so much faster are looked at, the worst few of them, by curves of the keys around
/// them: that takes a few nanoseconds a key. `method` is completed with the settings of the track. `made` is the curve,
/// or null: where that turns by far too little in a span, no other is made.
[[nodiscard]] std::optional<Warning> overturned_span(const Method& method, const FamilyInfo& family, const Track& track,
                                                     const AnyCurve* made);

}}  // namespace orispline
