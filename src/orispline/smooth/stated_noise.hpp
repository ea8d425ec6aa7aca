// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/curve/track.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// σ of every sample per axis [rad], as the settings of a recording state it: `sigma` or `sigma_deg`; of the axes of
/// the body `sigma_x`, `sigma_y`, `sigma_z`, or `cov_xx`, `cov_yy`, `cov_zz` [rad²], whose mean variance counts. Empty
/// where none do.
///
/// Errors (bad_data, with the key): one that is not above 0, or not finite; two of these forms; one of three axes
/// without the others.
[[nodiscard]] Expected<std::vector<double>> stated_noise(const Track& recording);

/// Without these settings and those of a band, which are not those of smoothed keys.
void forget_stated_noise(Track& track);

}}  // namespace orispline
