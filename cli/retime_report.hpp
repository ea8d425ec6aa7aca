// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/optimise/retime.hpp>

namespace orispline::cli {

/// What `orispline retime` did.
struct RetimeReport {
  std::string input{}, output{}, method{};
  optimise::MotionLimits limits{};
  optimise::Slowing slowing{};
  double duration_before = 0.0;  ///< [s]
  optimise::Retiming retiming{};
};

/// A few lines for people.
[[nodiscard]] std::string text_of(const RetimeReport& report);

}  // namespace orispline::cli
