// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// check() of the options, and whether they suit the recording. Errors: bad_argument for a smoothing time out of range,
/// bad_data for a gyro without rates.
[[nodiscard]] Expected<void> check_recording(const Keyframes& recording, const SmoothOptions& options);

}}  // namespace orispline
