// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/io/key_file.hpp>

namespace orispline::cli {

/// What reading touched, one clause each: `dropped 2 rows of duplicate times`; empty when nothing.
[[nodiscard]] std::string text_of(const io::RepairReport& repairs);

}  // namespace orispline::cli
