// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/fields/warning_json.hpp>

#include "errors.hpp"
#include "json_text.hpp"

namespace orispline::c {

/// The bytes of a file, and what there is to be said of them.
struct Written {
  std::string bytes;
  std::vector<Warning> warnings;
};

/// Gives them to the caller; `warnings` may be null.
inline void give(const Written& file, char** bytes, std::size_t* size, char** warnings) {
  const auto release = [](char* text) { orispline_text_free(text); };
  std::unique_ptr<char, decltype(release)> told(nullptr, release);
  if (warnings) told.reset(text_of_c(json_text(warnings_json(file.warnings))));
  *bytes = text_of_c(file.bytes);
  *size = file.bytes.size();
  if (warnings) *warnings = told.release();
}

}  // namespace orispline::c
