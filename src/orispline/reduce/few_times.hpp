// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <orispline/clip/clip.hpp>
#include <orispline/clip/clip_motion.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A channel whose keys may become fewer: geodesics through some of its own. From each key on, the last one to which
/// they are within the tolerance at all keys between, as those to all keys before it are.
struct KeyReach {
  std::vector<std::size_t> last{};
  double bytes_of_key = 0.0;  ///< of its value, compressed
};

/// Of linear keys with these values, which are those of the channel rounded, from the motion there [rad, or a length].
template <CurvePoint P>
[[nodiscard]] KeyReach reach_of(const Channel<P>& rounded, const ChannelCurve<P>& motion, double tolerance);

/// Which keys of each channel stay: those of channels that share their times are the same, and it is chosen which do,
/// so that all together take the fewest bytes. All channels have the same times; the first key and the last one stay.
/// By the keys that each needs by itself the channels are put in a row, of which each set of times serves a stretch:
/// of all such stretches the best are found.
[[nodiscard]] std::vector<std::vector<std::size_t>> keys_at_few_times(const std::vector<KeyReach>& channels);

extern template KeyReach reach_of(const RotationChannel&, const ChannelCurve<Eigen::Quaterniond>&, double);
extern template KeyReach reach_of(const VectorChannel&, const ChannelCurve<Eigen::Vector3d>&, double);

}}  // namespace orispline
