// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace orispline::fuzz {

/// How many bytes of options stand before the file, in inputs of the target that the mutator is linked to.
extern const std::size_t option_bytes;

}  // namespace orispline::fuzz
