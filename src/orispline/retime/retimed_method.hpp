// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/base/expected.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/retime/retime.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Whether keys of a method may get other times at all, whether slowing can bring what is limited within limits, and
/// whether there is a position where one is limited. Errors: those of retime().
[[nodiscard]] Expected<void> check_retimed(const FamilyInfo& family, const Method& method, const Keyframes& keys,
                                           const RetimeOptions& options);

}}  // namespace orispline
