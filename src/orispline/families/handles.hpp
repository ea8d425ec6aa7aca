// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Whether the curves of a method have handles that may turn too far, which overwound_tangent() looks for.
/// Precondition: there is such a method.
[[nodiscard]] bool can_overwind(const Method& method);

}}  // namespace orispline
