// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace orispline {

/// Which of two values of a measure is the better one.
enum class Better { less, more, neither };

}  // namespace orispline
