// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orispline/base/expected.hpp>

#include "options/field_options.hpp"
#include "options/report_options.hpp"

namespace orispline::cli {

/// `orispline difference`, as typed.
struct DifferenceArguments {
  std::string first, second;       ///< files of skeletons
  std::vector<std::string> clips;  ///< names; empty: all
  TypedFields shell;               ///< of orispline::ClipReduceOptions
  std::optional<std::string> rate;
  bool json = false;
  ReportOptions report;
};

/// How far the motions of one skeleton in two files are from each other: by joint and clip, in angle and in the world.
[[nodiscard]] Expected<void> difference(const DifferenceArguments& options);

}  // namespace orispline::cli
