// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/base/warning.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/track.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Says where the curve swings farther from the shortest way between two keys than half their step, and than a quarter
/// of the steps beside it, and a degree: so far no smooth motion goes that its keys show.
///
/// Only spans beside far faster steps are looked at, the worst few of them. `method` is completed with the settings of
/// the track. `made` is the curve, or null: then curves of the keys around are made. Rests are left out.
[[nodiscard]] std::optional<Warning> overshot_span(const Method& method, const FamilyInfo& family, const Track& track,
                                                   const AnyCurve* made);

}}  // namespace orispline
