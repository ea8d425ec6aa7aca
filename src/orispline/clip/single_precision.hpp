// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/clip/clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A channel as a reader finds it in a file that holds floats, with quaternions made unit. Doing it again changes
/// nothing but the last digit of a few quaternions in a thousand. Nothing where no such file can hold it: two times
/// become one, or a number is too large.
template <CurvePoint P>
[[nodiscard]] std::optional<Channel<P>> held_in_single_precision(Channel<P> channel);

/// The same, but the channel as it was where no such file can hold it.
template <CurvePoint P>
[[nodiscard]] Channel<P> in_single_precision(const Channel<P>& channel) {
  return held_in_single_precision(channel).value_or(channel);
}

extern template std::optional<RotationChannel> held_in_single_precision(RotationChannel);
extern template std::optional<VectorChannel> held_in_single_precision(VectorChannel);

}}  // namespace orispline
