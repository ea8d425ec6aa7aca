// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <orispline/base/expected.hpp>

#include "options/report_options.hpp"

namespace orispline::cli {

/// `orispline reproduce`, as typed.
struct ReproduceArguments {
  std::optional<std::string> experiment, keys, reference, pictures, folder;
  ReportOptions report;
  bool json = false;
};

/// Lists the experiments of the papers, or runs one of them, all of one paper or all.
[[nodiscard]] Expected<void> reproduce(const ReproduceArguments& options);

}  // namespace orispline::cli
