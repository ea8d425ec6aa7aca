// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <orispline/base/expected.hpp>
#include <orispline/curve/own_family.hpp>
#include <orispline/io/input.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// Blending functions that a JSON file states; the format: docs/own-blending.md.
///
/// Errors: bad_access; bad_data with the file, and the line and column where it is no JSON: a file of more than 64 kB,
/// members that there are not or that are missing, values of another kind.
[[nodiscard]] ORISPLINE_EXPORT Expected<BlendingData> read_blending(const Input& input);

/// The same from the text of such a file. Error: bad_data.
[[nodiscard]] ORISPLINE_EXPORT Expected<BlendingData> blending_from_json(std::string_view text);

/// The text that blending_from_json() reads back as the same, on one line; members that say nothing are left out.
[[nodiscard]] ORISPLINE_EXPORT std::string blending_json(const BlendingData& data);

}}}  // namespace orispline::io
