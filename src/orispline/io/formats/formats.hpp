// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <orispline/io/file_format.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

// THE list of formats. Each is stated by the file of this folder that has its name.

extern const FormatInfo csv_format, tum_format, euroc_format, npy_format;

inline constexpr std::array all_formats{&csv_format, &tum_format, &euroc_format, &npy_format};

}}}  // namespace orispline::io
