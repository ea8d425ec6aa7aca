// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/jobs/bake.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

// The two files of baked curves that players read. docs/bake.md describes them.

/// A document of one line.
[[nodiscard]] ORISPLINE_EXPORT std::string baked_json(const BakeOutcome& outcome);
/// Little-endian on every machine.
[[nodiscard]] ORISPLINE_EXPORT std::string baked_bytes(const BakeOutcome& outcome);

}}}  // namespace orispline::jobs
