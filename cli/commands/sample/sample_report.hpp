// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orispline/analysis/distance.hpp>
#include <orispline/curve/extrapolation.hpp>
#include <orispline/families/measured.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/io/sample_writer.hpp>

#include "output/json_document.hpp"

namespace orispline::cli {

/// The distance of the curve to a file of reference orientations.
struct TruthReport {
  std::string path;
  DistanceStatistics distance;
  Decimal largest_time;  ///< in the file's own time [s]
};

/// What `orispline sample` did.
struct SampleReport {
  std::string input{}, output{}, method{}, method_text{};
  std::size_t keys = 0;
  io::RepairReport repairs{};
  KeyframeReport keyframes{};
  io::SampleColumns columns{};
  std::size_t samples = 0, held_samples = 0;  ///< in all, and outside the curve
  Extrapolation extrapolation = Extrapolation::hold;
  std::size_t rate_orders = 0;  ///< of the keys' own rates that the curve has
  Decimal start{}, end{};       ///< of the curve, in the file's own time [s]
  std::optional<TruthReport> truth{};
  std::optional<KeyFindings> findings{};  ///< by the method measured
  std::optional<double> band{};           ///< the share that the column is meant to hold
  bool keys_held = false;                 ///< all at once, in memory
};

/// A few lines for people.
[[nodiscard]] std::string text_of(const SampleReport& report);
/// In one line, of one of several inputs.
[[nodiscard]] std::string line_of(const SampleReport& report);

/// The JSON document, described in docs/inspect-json.md.
[[nodiscard]] Json json_of(const SampleReport& report);

}  // namespace orispline::cli
