// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/base/expected.hpp>

namespace orispline::cli {

/// What the library says of reading a file, in the words of the command: beginning with the flag of an option that is
/// at fault, ending with the flag that would mend it.
[[nodiscard]] Error with_reading_flags(Error error);

}  // namespace orispline::cli
