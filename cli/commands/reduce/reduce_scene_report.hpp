// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/reduce/clip_reduction.hpp>

#include "output/json_document.hpp"

namespace orispline::cli {

/// What `orispline reduce` did to the clips of a scene.
struct ReduceSceneReport {
  std::string input, output;
  Skeleton skeleton{};
  orispline::ClipReduceOptions options{};
  double metres = 1.0;           ///< in a unit of length of the file; lengths are shown in metres
  std::string_view unit = " m";  ///< of lengths, for people; empty where it is not known
  std::vector<ClipReduction> reductions{};
  std::size_t bytes_before = 0, bytes_after = 0;  ///< of the files; 0 where that is not known
};

/// A few lines for people.
[[nodiscard]] std::string text_of(const ReduceSceneReport& report);
/// In one line, of one of several inputs.
[[nodiscard]] std::string line_of(const ReduceSceneReport& report);

/// The JSON document, described in docs/skeletons.md.
[[nodiscard]] Json json_of(const ReduceSceneReport& report);

}  // namespace orispline::cli
