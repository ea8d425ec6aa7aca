// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <orispline/curve/track.hpp>
#include <orispline/io/key_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

class LineReader;

/// A file of keys at its beginning, and what the comments there say: a caller learns which curve the keys are for
/// before it decides how they are read.
class ORISPLINE_EXPORT KeyInput {
 public:
  /// Comments are looked at in the first MiB, and what they say is stated in the frames of the options. Errors:
  /// bad_access; bad_data for a recipe that cannot be understood; bad_argument for frames that contradict each other.
  [[nodiscard]] static Expected<KeyInput> open(Input input, const ReadOptions& options = {});

  KeyInput(KeyInput&&) noexcept;
  KeyInput& operator=(KeyInput&&) noexcept;
  ~KeyInput();

  [[nodiscard]] const Input& input() const noexcept;
  [[nodiscard]] const std::string& path() const noexcept;
  /// Empty where the file has none, or where it is ignored.
  [[nodiscard]] const Recipe& recipe() const noexcept { return recipe_; }
  /// The names of its columns, in its first row or the comment before it, which are read once more with the others;
  /// none where nothing names them.
  [[nodiscard]] std::vector<std::string> header();
  /// All lines from the first on.
  [[nodiscard]] LineReader lines() && noexcept;

 private:
  KeyInput(LineReader lines, Recipe recipe);

  std::unique_ptr<LineReader> lines_;
  Recipe recipe_;
};

/// What the file says of the curve that its keys are for, and what is said beside it.
[[nodiscard]] Recipe recipe_of(const KeyInput& input, const ReadOptions& options);

}}}  // namespace orispline::io
