// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/reduce/clip_reduction.hpp>

namespace orispline::inline ORISPLINE_ABI {

/// A channel with fewer keys, within the tolerance [rad, or a length] at every key that it had; itself where that
/// cannot be had with fewer.
///
/// Errors: those of reduce().
template <CurvePoint P>
[[nodiscard]] Expected<Channel<P>> reduced_channel(const Channel<P>& channel, double tolerance,
                                                   const ClipReduceOptions& options);

/// Whether a channel ends as it begins, but for rounding.
template <CurvePoint P>
[[nodiscard]] bool ends_as_it_begins(const Channel<P>& channel);

extern template bool ends_as_it_begins(const RotationChannel&);
extern template bool ends_as_it_begins(const VectorChannel&);
extern template Expected<RotationChannel> reduced_channel(const RotationChannel&, double, const ClipReduceOptions&);
extern template Expected<VectorChannel> reduced_channel(const VectorChannel&, double, const ClipReduceOptions&);

}  // namespace orispline::inline ORISPLINE_ABI
