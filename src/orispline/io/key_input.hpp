// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include <orispline/curve/track.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/io/line_reader.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// A file of keys at its beginning, and what the comments there say: a caller learns which curve the keys are for
/// before it decides how they are read.
class ORISPLINE_EXPORT KeyInput {
 public:
  /// Opens a file; `-` is standard input. Comments are looked at in its first MiB. Errors: bad_access; bad_data for a
  /// recipe that cannot be understood.
  [[nodiscard]] static Expected<KeyInput> open(const std::string& path, RecipeUse use = RecipeUse::honoured);

  [[nodiscard]] const std::string& path() const noexcept { return lines_.path(); }
  /// Empty where the file has none, or where it is ignored.
  [[nodiscard]] const Recipe& recipe() const noexcept { return recipe_; }
  /// All lines from the first on.
  [[nodiscard]] LineReader lines() && noexcept { return std::move(lines_); }

 private:
  KeyInput(LineReader lines, Recipe recipe) : lines_(std::move(lines)), recipe_(std::move(recipe)) {}

  LineReader lines_;
  Recipe recipe_;
};

}}}  // namespace orispline::io
