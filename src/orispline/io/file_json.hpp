// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/fields/json.hpp>
#include <orispline/io/key_file.hpp>

// Files as members of documents.

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// What reading mended: docs/inspect-json.md.
ORISPLINE_EXPORT void add_repairs(Json& json, const RepairReport& repairs);

/// The formats that there are, and the options of `reading` and of `writing` with their sentences, as people state
/// them.
[[nodiscard]] ORISPLINE_EXPORT Json files_json();

}}}  // namespace orispline::io
