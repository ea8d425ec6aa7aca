// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The time within which the correlation of the noise of several tracks falls to 1/e [s], which they share; absent
/// where their noise is white, or where their motion explains as much.
///
/// One track tells nothing of it, since a motion that is rougher looks alike; the quietest third of several that show
/// noise does. It is the shortest time that explains them nearly as well as any, by the restricted likelihood of each
/// with a penalty and a noise of its own: a longer one would take motion for noise. At most eight tracks are asked, in
/// a thousand samples.
[[nodiscard]] std::optional<double> shared_noise_time(std::span<const Keyframes> tracks, unsigned threads);

}}  // namespace orispline
