// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/io/key_file.hpp>
#include <orispline/smooth/smooth.hpp>

#include "output/json_document.hpp"

namespace orispline::cli {

/// What `orispline smooth` did.
struct SmoothReport {
  Track recording{};  ///< as it was read
  io::RepairReport repairs{};
  std::string output{};
  orispline::Penalty penalty{};
  orispline::Loss loss{};
  bool samples = false;
  std::size_t rows = 0;  ///< written
  orispline::Smoothing smoothing{};
};

/// A page for people.
[[nodiscard]] std::string text_of(const SmoothReport& report);
/// In one line, of one of several inputs.
[[nodiscard]] std::string line_of(const SmoothReport& report);

/// The JSON document, described in docs/inspect-json.md.
[[nodiscard]] Json json_of(const SmoothReport& report);

}  // namespace orispline::cli
