// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/clip/clip_difference.hpp>

#include "output/json_document.hpp"

namespace orispline::cli {

/// How far two motions of a clip are from each other.
struct ClipDifference {
  std::string clip{};
  std::size_t times = 0;                 ///< at which they were compared
  std::vector<std::string> joints{};     ///< names of those that are in both files
  std::vector<JointDifference> worst{};  ///< of each of them
};

/// What `orispline difference` found.
struct DifferenceReport {
  std::string first, second;
  double shell = default_shell;
  std::vector<ClipDifference> clips{};
  std::vector<std::string> only_in_first{}, only_in_second{};  ///< names of clips
  std::size_t joints_only_in_first = 0;
};

/// A few lines for people.
[[nodiscard]] std::string text_of(const DifferenceReport& report);

/// The JSON document, described in docs/skeletons.md.
[[nodiscard]] Json json_of(const DifferenceReport& report);

}  // namespace orispline::cli
