// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/curve/curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Offsets of the clocks [s] at which two motions may be the same but for their axes: the moved time is the fixed one
/// and the offset. The likeliest comes first.
///
/// Both are cut into equal intervals, and what the body turns in each is compared, which no choice of axes changes. The
/// motions overlap by half of the shorter one at least. None where one of them is 30 000 times as long as the other.
[[nodiscard]] std::vector<double> offsets_in_question(const AnyCurve& moved, const AnyCurve& fixed,
                                                      double sampling_interval);

/// Rotation vectors [rad, body frame] of what a body turns in successive intervals of a length [s].
[[nodiscard]] std::vector<Eigen::Vector3d> turns_in_intervals(const AnyCurve& curve, double start, double length,
                                                              std::size_t count);

}}  // namespace orispline
