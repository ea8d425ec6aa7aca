// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/tune/tune.hpp>

#include "output/json_document.hpp"

namespace orispline::cli {

/// What `orispline tune` did.
struct TuneReport {
  std::string input{}, output{};
  orispline::Objective objective{};
  std::vector<double> times{};  ///< of the keys [s], in the file's own time
  orispline::Tuning tuning{};
};

/// A few lines for people.
[[nodiscard]] std::string text_of(const TuneReport& report);

/// The JSON document, described in docs/inspect-json.md.
[[nodiscard]] Json json_of(const TuneReport& report);

}  // namespace orispline::cli
