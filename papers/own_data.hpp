// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "papers/experiment.hpp"

namespace orispline::cli {

/// The user's own keys, and with a recording of the same motion a flight.
struct OwnData {
  KeysInstead keys;
  std::optional<Flight> flight{};
};

/// Reads the files, and warns of what their reading says. Errors: those of reading and of beside_recording(); bad_data
/// for fewer than four keys.
[[nodiscard]] Expected<OwnData> read_own_data(const std::string& keys, const std::optional<std::string>& reference);

}  // namespace orispline::cli
