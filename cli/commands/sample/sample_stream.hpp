// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/sample/sample_report.hpp"
#include "commands/sample/sample_request.hpp"

#include <orispline/io/key_reader.hpp>

namespace orispline::cli {

/// Whether the samples can be made while the keys are read: those of a grid, of a method whose segments depend on a few
/// keys, where nothing else asks for all keys at once.
[[nodiscard]] bool goes_in_pieces(const SampleRequest& request, const io::KeyReader& keys);

/// Reads the keys and writes the samples piece by piece, in memory that grows with neither.
///
/// Precondition: goes_in_pieces().
[[nodiscard]] Expected<SampleReport> sample_in_pieces(const SampleRequest& request, io::KeyReader keys);

}  // namespace orispline::cli
