// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <orispline/curve/keyframe.hpp>
#include <orispline/smooth/gyro_path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The samples that those beside them do not contradict: of the three geodesics between the samples one, two and three
/// places before and behind, two pass a sample nearer than six times what is usual there. Single wild samples are
/// found, also where every tenth is one; runs of them are not.
[[nodiscard]] std::vector<std::size_t> steady_samples(const Keyframes& keys);

/// Finds such rates in the same way, with straight lines in place of geodesics.
[[nodiscard]] CountedRates steady_rates(const GyroRates& gyro);

}}  // namespace orispline
