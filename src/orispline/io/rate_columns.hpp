// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <orispline/io/column_search.hpp>
#include <orispline/io/frame.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// What a rate without a number in its three cells is.
enum class FreeRates {
  allowed,  ///< left free: NaN
  refused,  ///< not finite
};

/// Which angular rates are read.
struct RateReading {
  int orders = 1;      ///< highest order: 0 none, 1 angular velocities, 2 and accelerations, 3 and jerks
  bool world = false;  ///< those in the world frame too, for orders without any in the body frame
};

/// The columns of the rates of one order.
struct RateVector {
  VectorColumns columns;
  Frame frame;
};

/// By order: angular velocity, acceleration, jerk; where there is none there is none of a higher order.
using RateColumns = std::array<std::optional<RateVector>, 3>;

/// Every canonical name that a column of rates may have.
[[nodiscard]] ORISPLINE_EXPORT std::vector<std::string_view> rate_names();

/// `wx,wy,wz`, `ax,ay,az`, `jx,jy,jz` in their frames and units.
///
/// Errors (bad_data): one of three columns without the others; accelerations without velocities, jerks without
/// accelerations.
[[nodiscard]] ORISPLINE_EXPORT Expected<RateColumns> rate_columns(const ColumnSearch& search,
                                                                  const RateReading& reading);

}}}  // namespace orispline::io
