// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <orispline/io/column_search.hpp>
#include <orispline/io/orientation_form.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// What the caller says about the orientation columns of a table.
struct OrientationReading {
  /// Absent: quaternions where there are columns of them, else the only representation that there are columns of.
  std::optional<Representation> representation{};
  /// The order of Euler angles, which also asks for them. Absent: ZYX for `roll,pitch,yaw`.
  std::optional<EulerOrder> euler{};
  /// Of Euler angles whose column does not end in a unit.
  std::optional<AngleUnit> angle_unit{};
};

/// The columns that state the orientation.
struct OrientationColumns {
  OrientationForm form{};
  ColumnGroup group{};  ///< in the order that `orientation_from` takes; incomplete where the header is
};

/// Every canonical name that an orientation column may have.
[[nodiscard]] ORISPLINE_EXPORT std::vector<std::string_view> orientation_names();

/// Finds the columns of one representation.
///
/// Errors: bad_data for several representations to choose from, Euler angles without an order or a unit; bad_argument
/// for options that contradict the header or each other.
[[nodiscard]] ORISPLINE_EXPORT Expected<OrientationColumns> orientation_columns(const ColumnSearch& search,
                                                                                const OrientationReading& reading);

}}}  // namespace orispline::io
