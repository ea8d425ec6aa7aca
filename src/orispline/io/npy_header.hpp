// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace orispline::io {

/// The header of a NumPy file (.npy, version 1.0) of doubles: little-endian, C order, shape (rows, columns).
///
/// It has 128 bytes whatever the numbers are, so that it can be written again once the rows are counted.
/// Format: NumPy Enhancement Proposal 1.
[[nodiscard]] std::string npy_header(std::size_t rows, std::size_t columns);

}  // namespace orispline::io
