// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <orispline/batch/sample.hpp>
#include <orispline/curve/extrapolation.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Writes the samples outside the curve again, which `sample…` holds at rest; those inside stay as they are.
///
/// Errors (bad_argument): room for another number of samples, or for positions that the keys do not have; where times
/// outside are an error, the first of them, with its index.
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Expected<void> extrapolate(const PoseCurve& curve, std::span<const double> times,
                                                          Extrapolation how, const Samples<T>& out, Work work = {});

/// The error (bad_argument, with its index) of the first time that is outside the curve. NaN is none.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check_inside(const AnyCurve& curve, std::span<const double> times);

}}  // namespace orispline
