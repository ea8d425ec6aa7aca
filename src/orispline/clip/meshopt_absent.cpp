// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/key_compression.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

bool has_meshopt() noexcept { return false; }

}}  // namespace orispline
