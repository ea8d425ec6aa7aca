// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/analysis/distance.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/method.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How far a method misses keys that it is not given [rad]: every 4th inner key is left out, four times over, so that
/// each is left out once; the curve through the others is compared with those.
///
/// An estimate of the size of the error between the keys where nothing denser is known. It is not fit for choosing a
/// method: without some of its keys a motion looks rougher than it is, and stiff methods look better than they are.
/// On recordings, taking the method of the least leave-out error ends farther from the truth than always taking `auto`.
///
/// Parameters with a value per key are refused, for the keys are others. Errors: those of make_curve(); bad_data for
/// fewer than 3 keys.
[[nodiscard]] ORISPLINE_EXPORT Expected<DistanceStatistics> leave_out_error(const Keyframes& keys,
                                                                            const Method& method = {});

}}  // namespace orispline
