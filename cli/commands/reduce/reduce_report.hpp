// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orispline/io/key_file.hpp>
#include <orispline/reduce/reduce.hpp>
#include <orispline/smooth/smooth.hpp>

#include "output/json_document.hpp"

namespace orispline::cli {

/// What was done to the samples before, and how far the chosen curve is from them as they were [rad] and its path [m],
/// those that were rejected apart.
struct SmoothedFirst {
  orispline::Smoothing smoothing;
  DistanceStatistics raw;
  std::optional<DistanceStatistics> raw_positions{};  ///< where there are positions
};

/// What `orispline reduce` did to a recording.
struct ReduceReport {
  std::string input{}, output{};
  std::size_t samples = 0;
  io::RepairReport repairs{};
  orispline::ReduceOptions options;
  std::vector<orispline::Reduction> reductions{};  ///< by each of the methods
  std::size_t chosen = 0;                          ///< of them, the one that was written
  std::vector<Decimal> times{};                    ///< of the samples, in the file's own time [s]
  std::vector<std::uint32_t> lines{};              ///< of the samples, in the file
  std::optional<SmoothedFirst> smoothed{};
};

/// A few lines for people.
[[nodiscard]] std::string text_of(const ReduceReport& report);
/// In one line, of one of several inputs.
[[nodiscard]] std::string line_of(const ReduceReport& report);

/// The JSON document, described in docs/inspect-json.md.
[[nodiscard]] Json json_of(const ReduceReport& report);

}  // namespace orispline::cli
