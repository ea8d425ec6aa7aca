// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include <orispline/online/state_bytes.hpp>

namespace orispline::testing_support {

using StateBytes = std::vector<std::byte>;

/// What a state says, without the checksum behind it.
[[nodiscard]] inline StateBytes unsealed(StateBytes state) {
  state.resize(state.size() - sizeof(std::uint64_t));
  return state;
}

/// With the checksum of whatever the bytes are.
[[nodiscard]] inline StateBytes sealed(StateBytes bytes) { return StateWriter(std::move(bytes)).sealed(); }

}  // namespace orispline::testing_support
