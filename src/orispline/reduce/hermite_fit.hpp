// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <orispline/reduce/hermite_span.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Whether the first and the last of a row of rates may change.
struct FreeEnds {
  bool first = false, last = false;
};

/// The rates at the keys of a row of spans with the least squares of what they miss: a linear system of 3 by 3 blocks
/// around the diagonal.
template <CurvePoint P>
void fit_rates(std::span<HermiteSpan<P>* const> spans, std::span<Eigen::Vector3d> rates, FreeEnds free);

/// Rates with which all spans hold, where they are found: by least squares, and where the worst target is missed by
/// little, by further rounds that weigh each target by its miss (Lawson). The rates are those of the last round.
template <CurvePoint P>
[[nodiscard]] bool find_rates(std::span<HermiteSpan<P>* const> spans, std::span<Eigen::Vector3d> rates, FreeEnds free,
                              double square_bound);

}}  // namespace orispline
