// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/family.hpp>
#include <orispline/retime/retime.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Whether keys of a method may get other times at all. Errors: those of retime().
[[nodiscard]] Expected<void> check_motion(const FamilyInfo& family, const Method& method, const Keyframes& keys);

/// Whether slowing can bring what is limited within limits: where a derivative jumps, the next one is infinite; and
/// whether there is a position where one is limited. Errors: those of retime().
[[nodiscard]] Expected<void> check_limits(const FamilyInfo& family, const Method& method, const Keyframes& keys,
                                          const RetimeOptions& options);

}}  // namespace orispline
