// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/curve.hpp>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

Expected<Motion> AnyCurve::checked_motion(double t) const {
  const Domain d = domain();
  if (!d.contains(t))
    return failure(ErrorCode::bad_argument,
                   formatted("time {} is outside the curve, wanted {} to {}", t, d.start, d.end));
  return motion(t);
}

}}  // namespace orispline
