// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/clip/clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A channel as a reader finds it in a file that holds floats, with quaternions made unit. Doing it again changes
/// nothing but the last digit of a few quaternions in a thousand. Where two times become one it is as it was, for no
/// such file can hold it.
template <CurvePoint P>
[[nodiscard]] Channel<P> in_single_precision(Channel<P> channel);

extern template RotationChannel in_single_precision(RotationChannel);
extern template VectorChannel in_single_precision(VectorChannel);

}}  // namespace orispline
