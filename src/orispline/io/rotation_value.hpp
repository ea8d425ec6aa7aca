// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include <orispline/base/expected.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// One rotation by the names that columns of files have, `qw=0.8,qx=0,qy=0,qz=0.6` or
/// `roll_deg=180,pitch_deg=0,yaw_deg=90`, also `euler=ZXZ,e1_deg=…`; a text without `=` is the name of a file with such
/// a header and one row. Angles that have no names of their own want `euler=ORDER`, which files cannot state.
///
/// Errors, of this option: bad_argument, bad_data and bad_access for what is no rotation, or more than one.
[[nodiscard]] Expected<Eigen::Quaterniond> rotation_value(std::string_view option, std::string_view text);

}}}  // namespace orispline::io
