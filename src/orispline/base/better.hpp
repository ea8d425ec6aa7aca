// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Which of two values of a measure is the better one.
enum class Better { less, more, neither };

}}  // namespace orispline
