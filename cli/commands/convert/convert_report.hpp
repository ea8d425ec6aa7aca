// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/curve/keyframe.hpp>
#include <orispline/io/key_file.hpp>

#include "output/json_document.hpp"

namespace orispline::cli {

/// What `orispline convert` did.
struct ConvertReport {
  std::string input{}, output{};
  const io::FormatInfo *input_format = nullptr, *output_format = nullptr;
  io::RepairReport repairs{};
  KeyframeReport keyframes{};
  std::size_t keys = 0;
  Decimal start{}, end{};                      ///< of the keys, in the file's own time [s]
  std::vector<std::string> dropped_columns{};  ///< of the input, which the output does not hold
  enum class Positions { kept, absent, zero } positions = Positions::kept;
};

/// A few lines for people.
[[nodiscard]] std::string text_of(const ConvertReport& report);

/// The JSON document, described in docs/inspect-json.md.
[[nodiscard]] Json json_of(const ConvertReport& report);

}  // namespace orispline::cli
