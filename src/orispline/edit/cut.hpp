// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/base/expected.hpp>
#include <orispline/clip/clip.hpp>

// A clip on another clock, or a part of one: each channel stays the curve that it is, by the interpolation it has.

namespace orispline { inline namespace ORISPLINE_ABI {

/// The part of a channel from one time to another [s], with a key at either end; before its first key and after its
/// last one it stands still. A channel of one key keeps one, at `from`.
///
/// Steps, linear channels and cubics of vectors stay what they are. A cubic of the components of a quaternion has keys
/// that are no unit quaternions where it is cut: its piece is scaled by a function of time, and halved until the
/// rotation is within 1e-7 rad of what it was. Preconditions: check_clip() finds the channel sound; `from` < `to`.
template <CurvePoint P>
[[nodiscard]] Channel<P> part_of(const Channel<P>& channel, double from, double to);
extern template RotationChannel part_of(const RotationChannel&, double, double);
extern template VectorChannel part_of(const VectorChannel&, double, double);

/// The part of a clip, channel by channel. Precondition: as of part_of().
[[nodiscard]] ORISPLINE_EXPORT Clip part_of(const Clip& clip, Domain part);

/// The key time that a stated one means where the two differ by no more than the rounding to `float`, else the stated
/// one [s].
[[nodiscard]] ORISPLINE_EXPORT double key_time_near(const Clip& clip, double time);

/// All times later by that much [s].
[[nodiscard]] ORISPLINE_EXPORT Clip shifted(Clip clip, double by);
/// So many times as fast, from the same start. Precondition: the factor is above 0.
[[nodiscard]] ORISPLINE_EXPORT Clip with_speed(Clip clip, double factor);
/// With keys at so many even times per second from its start, and one at its end, whatever is left there [Hz]. Steps
/// keep their keys, and so does a channel of one; all others become linear. Precondition: the rate is above 0.
[[nodiscard]] ORISPLINE_EXPORT Clip resampled(Clip clip, double rate);
/// Backwards in time, within the same times. Steps keep the value that the curve has between two keys.
[[nodiscard]] ORISPLINE_EXPORT Clip reversed(Clip clip);

}}  // namespace orispline
