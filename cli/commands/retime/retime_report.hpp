// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/retime/retime.hpp>

#include "output/json_document.hpp"

namespace orispline::cli {

/// What `orispline retime` did.
struct RetimeReport {
  std::string input{}, output{};
  orispline::MotionLimits limits{};
  orispline::Slowing slowing{};  ///< that was asked for
  double duration_before = 0.0;  ///< [s]
  orispline::Retiming retiming{};
};

/// A few lines for people.
[[nodiscard]] std::string text_of(const RetimeReport& report);
/// In one line, of one of several inputs.
[[nodiscard]] std::string line_of(const RetimeReport& report);

/// The JSON document, described in docs/inspect-json.md.
[[nodiscard]] Json json_of(const RetimeReport& report);

}  // namespace orispline::cli
